#include "gpu/program.h"

#include "common/base/error.h"
#include "gpu/context.h"
#include "gpu/gl_api.h"

namespace twintrace {

namespace {

// One triangle over the whole target; its corners lie outside, so no diagonal seam runs through it.
constexpr const char* kVertexShader = R"(#version 450 core
void main() {
  vec2 corner = vec2(float((gl_VertexID & 1) * 4 - 1), float((gl_VertexID & 2) * 2 - 1));
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const char* kindName(GLenum kind) {
  switch (kind) {
    case GL_VERTEX_SHADER:
      return "vertex";
    case GL_FRAGMENT_SHADER:
      return "fragment";
    default:
      return "compute";
  }
}

/// A shader object, needed only until its program is linked.
class Shader {
 public:
  Shader(Context& context, GLenum kind) : gl_(context.gl()), name_(gl_.CreateShader(kind)) {}
  ~Shader() { gl_.DeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  bool compile(const std::string& text) {
    const char* start = text.c_str();
    gl_.ShaderSource(name_, 1, &start, nullptr);
    gl_.CompileShader(name_);
    GLint compiled = GL_FALSE;
    gl_.GetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
    return compiled == GL_TRUE;
  }

  std::string log() const {
    GLint length = 0;
    gl_.GetShaderiv(name_, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length), '\0');
    gl_.GetShaderInfoLog(name_, length, &length, text.data());
    text.resize(static_cast<std::size_t>(length));
    return text;
  }

  GLuint name() const { return name_; }

 private:
  const GlApi& gl_;
  GLuint name_;
};

/// Compiles one stage and attaches it; the shader must live until the program is linked.
std::string attach(const GlApi& gl, GLuint program, Shader& shader, GLenum kind,
                   const ShaderSource& source) {
  const bool compiled = shader.compile(source.text);
  std::string log = source.mapLog(shader.log());
  if (!compiled) {
    throw DeviceError(std::string("the driver rejects the ") + kindName(kind) + " shader:\n" + log);
  }
  gl.AttachShader(program, shader.name());
  return log;
}

std::string linkLog(const GlApi& gl, GLuint program) {
  GLint length = 0;
  gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  gl.GetProgramInfoLog(program, length, &length, text.data());
  text.resize(static_cast<std::size_t>(length));
  return text;
}

}  // namespace

Program::Program(Context& context) : context_(context) {
  const auto current = context_.use();
  name_ = context_.gl().CreateProgram();
}

Program::Program(Context& context, Stage stage, const ShaderSource& source) : Program(context) {
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  const GLenum kind = stage == Stage::fragment ? GL_FRAGMENT_SHADER : GL_COMPUTE_SHADER;
  Shader shader(context_, kind);
  std::optional<Shader> vertexShader;
  if (stage == Stage::fragment) {
    vertexShader.emplace(context_, GL_VERTEX_SHADER);
    attach(gl, name_, *vertexShader, GL_VERTEX_SHADER, {kVertexShader, {}, {}});
  }
  log_ = attach(gl, name_, shader, kind, source);
  gl.ProgramParameteri(name_, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  gl.LinkProgram(name_);
  log_ += source.mapLog(linkLog(gl, name_));
  if (!isLinked()) {
    throw DeviceError(std::string("the driver can't link the ") + kindName(kind) + " program:\n" +
                      log_);
  }
  context_.check("linking a program");
}

Program::~Program() {
  const auto current = context_.use();
  context_.gl().DeleteProgram(name_);
}

void Program::set(std::string_view name, std::int32_t value) {
  const auto current = context_.use();
  context_.gl().ProgramUniform1i(name_, location(name), value);
}

void Program::set(std::string_view name, std::uint32_t value) {
  const auto current = context_.use();
  context_.gl().ProgramUniform1ui(name_, location(name), value);
}

void Program::set(std::string_view name, float value) {
  const auto current = context_.use();
  context_.gl().ProgramUniform1f(name_, location(name), value);
}

void Program::set(std::string_view name, glm::vec3 value) {
  const auto current = context_.use();
  context_.gl().ProgramUniform3f(name_, location(name), value.x, value.y, value.z);
}

void Program::dispatch(glm::uvec3 groups) {
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  gl.UseProgram(name_);
  gl.DispatchCompute(groups.x, groups.y, groups.z);
  gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
  context_.check("running a compute shader");
}

std::optional<ProgramBinary> Program::binary() const {
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  GLint size = 0;
  gl.GetProgramiv(name_, GL_PROGRAM_BINARY_LENGTH, &size);
  if (size <= 0 || context_.integer(GL_NUM_PROGRAM_BINARY_FORMATS) == 0) return std::nullopt;
  ProgramBinary binary;
  binary.bytes.resize(static_cast<std::size_t>(size));
  gl.GetProgramBinary(name_, size, &size, &binary.format, binary.bytes.data());
  context_.check("reading a program's binary");
  binary.bytes.resize(static_cast<std::size_t>(size));
  return binary;
}

std::unique_ptr<Program> Program::fromBinary(Context& context, const ProgramBinary& binary) {
  const auto current = context.use();
  std::unique_ptr<Program> program(new Program(context));
  context.gl().ProgramBinary(program->name_, binary.format, binary.bytes.data(),
                             static_cast<GLsizei>(binary.bytes.size()));
  const bool accepted = program->isLinked();
  try {
    context.check("loading a program's binary");
  } catch (const DeviceError&) {
    return nullptr;
  }
  return accepted ? std::move(program) : nullptr;
}

std::int32_t Program::location(std::string_view name) {
  const auto known = locations_.find(name);
  if (known != locations_.end()) return known->second;
  const std::string key(name);
  const GLint found = context_.gl().GetUniformLocation(name_, key.c_str());
  return locations_.emplace(key, found).first->second;
}

bool Program::isLinked() const {
  GLint linked = GL_FALSE;
  context_.gl().GetProgramiv(name_, GL_LINK_STATUS, &linked);
  return linked == GL_TRUE;
}

}  // namespace twintrace
