#include "gpu/context.h"

#include "common/base/error.h"
#include "gpu/gl_api.h"
#include "gpu/platform.h"

#include <utility>

namespace twintrace {

namespace {

// A lost context reports errors without end.
constexpr int kMaxErrors = 16;

void APIENTRY appendMessage(GLenum, GLenum, GLuint, GLenum, GLsizei, const GLchar* message,
                            const void* log) {
  auto* text = static_cast<std::string*>(const_cast<void*>(log));
  *text += std::string("\n  ") + message;
}

const char* errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:
      return "an unknown error";
  }
}

std::string textOf(const GlApi& gl, GLenum name) {
  const auto* text = reinterpret_cast<const char*>(gl.GetString(name));
  return text != nullptr ? text : "";
}

}  // namespace

Context::Context(std::unique_ptr<Platform> platform)
    : platform_(std::move(platform)), driverMessages_(std::make_unique<std::string>()) {
  const Current current = use();
  gl_ = std::make_unique<GlApi>(loadGlApi(platform_->loader()));
  vendor_ = textOf(*gl_, GL_VENDOR);
  renderer_ = textOf(*gl_, GL_RENDERER);
  version_ = textOf(*gl_, GL_VERSION);
  source_ = platform_->description();
  enableDebugMessages();
  // A core context draws nothing without a vertex array object, even if no attribute is read.
  gl_->CreateVertexArrays(1, &vertexArray_);
  gl_->BindVertexArray(vertexArray_);
  check("setting up the context");
}

Context::~Context() {
  const Current current = use();
  gl_->DebugMessageCallback(nullptr, nullptr);
  gl_->DeleteVertexArrays(1, &vertexArray_);
}

std::int64_t Context::integer(std::uint32_t name) {
  const Current current = use();
  GLint64 value = 0;
  gl_->GetInteger64v(name, &value);
  check("asking for a limit");
  return value;
}

void Context::finish() {
  const Current current = use();
  gl_->Finish();
  check("waiting for the device");
}

void Context::check(std::string_view doing) {
  const Current current = use();
  std::string names;
  for (int i = 0; i < kMaxErrors; ++i) {
    const GLenum error = gl_->GetError();
    if (error == GL_NO_ERROR) break;
    names += std::string(names.empty() ? "" : ", ") + errorName(error);
  }
  const std::string messages = std::exchange(*driverMessages_, "");
  if (names.empty()) return;
  throw DeviceError("GL error " + names + " while " + std::string(doing) + messages);
}

void Context::enter() {
  if (depth_ == 0) platform_->bind();
  ++depth_;
}

void Context::leave() noexcept {
  --depth_;
  if (depth_ == 0) platform_->release();
}

void Context::enableDebugMessages() {
  // Only errors: drivers send performance hints and shader statistics through the same channel.
  gl_->Enable(GL_DEBUG_OUTPUT);
  gl_->Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl_->DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  gl_->DebugMessageControl(GL_DEBUG_SOURCE_API, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr,
                           GL_TRUE);
  gl_->DebugMessageCallback(appendMessage, driverMessages_.get());
}

}  // namespace twintrace
