#include <array>

#include "gpu/context.h"
#include "tests/unit/gpu/gl_fixture.h"

namespace twintrace {

TEST_CASE("a fragment program covers every pixel once", "[gl]") {
  inEachContext([](Context& context) {
    Program program(context, Stage::fragment,
                    sourceOf("out vec4 color;\nvoid main() { color = gl_FragCoord; }\n"));
    const std::vector<float> pixels = drawnPixels(context, program, 5, 3);
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 5; ++x) {
        const std::size_t at = static_cast<std::size_t>(4 * (5 * y + x));
        CHECK(pixels[at] == static_cast<float>(x) + 0.5f);
        CHECK(pixels[at + 1] == static_cast<float>(y) + 0.5f);
      }
    }
  });
}

TEST_CASE("a compute program reads and writes storage buffers", "[gl]") {
  inEachContext([](Context& context) {
    Program program(context, Stage::compute,
                    sourceOf("layout(local_size_x = 4) in;\n"
                             "layout(std430, binding = 0) buffer In { uint given[]; };\n"
                             "layout(std430, binding = 1) buffer Out { uint result[]; };\n"
                             "uniform uint factor;\n"
                             "void main() {\n"
                             "  uint i = gl_GlobalInvocationID.x;\n"
                             "  result[i] = factor * given[i];\n"
                             "}\n"));
    const std::array<std::uint32_t, 8> given = {0, 1, 2, 3, 4, 5, 6, 0xffffffffu};
    std::array<std::uint32_t, 8> result{};
    const StorageBuffer input(context, std::as_bytes(std::span(given)));
    const StorageBuffer output(context, sizeof result);
    input.bind(0);
    output.bind(1);
    program.set("factor", 3u);
    program.dispatch({2, 1, 1});
    output.read(std::as_writable_bytes(std::span(result)));
    for (std::size_t i = 0; i < given.size(); ++i) CHECK(result[i] == 3u * given[i]);
  });
}

TEST_CASE("uniforms of each type arrive, and unknown ones are ignored", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  Program program(
      *context, Stage::fragment,
      sourceOf("uniform int a;\nuniform uint b;\nuniform float c;\nuniform vec3 d;\n"
               "out vec4 color;\n"
               "void main() { color = vec4(float(a), float(b), c, d.x + d.y * d.z); }\n"));
  program.set("a", -2);
  program.set("b", 3u);
  program.set("c", 0.5f);
  program.set("d", glm::vec3(1.0f, 2.0f, 4.0f));
  program.set("none", 1.0f);
  CHECK(drawnPixels(*context, program, 1, 1) == std::vector<float>{-2.0f, 3.0f, 0.5f, 9.0f});
}

TEST_CASE("a uniform set with the wrong type is found by the next draw", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  Program program(
      *context, Stage::fragment,
      sourceOf("uniform float a;\nout vec4 color;\nvoid main() { color = vec4(a); }\n"));
  FloatTarget target(*context, 1, 1);
  program.set("a", 1u);
  CHECK_THROWS_AS(target.draw(program), DeviceError);
}

TEST_CASE("a GLSL error names the shader file and line", "[gl]") {
  inEachContext([](Context& context) {
    ShaderRequest request;
    request.main = "main.glsl";
    request.prelude = "const int kCount = 1;\n";
    request.virtualFiles["main.glsl"] = "#include \"shared/layout.glsl\"\nvoid main() {}\n";
    const ShaderLibrary library({},
                                {{"shared/layout.glsl", {"\n\nint x = undeclaredName;\n", ""}}});
    const std::string message = messageOf<DeviceError>(
        [&] { Program(context, Stage::compute, assembleShader(library, request)); });
    INFO(message);
    CHECK(message.find("the driver rejects the compute shader:\nshaders/shared/layout.glsl:3:") ==
          0);
    CHECK(message.find("undeclaredName") != std::string::npos);
  });
}

TEST_CASE("a GLSL error after an include names the including file's own line", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  ShaderRequest request;
  request.main = "main.glsl";
  request.virtualFiles["main.glsl"] = "#include \"shared/layout.glsl\"\nint x = undeclaredName;\n";
  const std::string message = messageOf<DeviceError>(
      [&] { Program(*context, Stage::fragment, assembleShader(ShaderLibrary(), request)); });
  INFO(message);
  CHECK(message.find("fragment shader:\n<main.glsl>:2:") != std::string::npos);
}

TEST_CASE("a GLSL error in the prelude is said to be there", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  ShaderRequest request;
  request.main = "main.glsl";
  request.prelude = "\nint x = undeclaredName;\n";
  request.virtualFiles["main.glsl"] = "void main() {}\n";
  const std::string message = messageOf<DeviceError>(
      [&] { Program(*context, Stage::fragment, assembleShader(ShaderLibrary(), request)); });
  CHECK(message.find("<prelude>:2:") != std::string::npos);
}

TEST_CASE("a program that can't be linked is an error", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const ShaderSource source = sourceOf("float f();\nout vec4 c;\nvoid main() { c = vec4(f()); }\n");
  const std::string message =
      messageOf<DeviceError>([&] { Program(*context, Stage::fragment, source); });
  CHECK(message.find("the driver can't link the fragment program") == 0);
}

}  // namespace twintrace
