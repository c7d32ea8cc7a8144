#include "gpu/buffers.h"

#include <array>
#include <bit>

#include "tests/unit/gpu/gl_fixture.h"

namespace twintrace {

namespace {

// 0, -0, denormals, infinities, quiet and signalling NaN with payload, largest, all bits.
constexpr std::array<glm::uvec4, 3> kPatterns = {
    glm::uvec4(0x00000000u, 0x80000000u, 0x00000001u, 0x807fffffu),
    glm::uvec4(0x7f800000u, 0xff800000u, 0x7fc12345u, 0x7f812345u),
    glm::uvec4(0x7f7fffffu, 0xffffffffu, 0x3f800000u, 0xdeadbeefu)};

}  // namespace

TEST_CASE("BufferTexture keeps every bit pattern", "[gl]") {
  inEachContext([](Context& context) {
    Program program(context, Stage::compute,
                    sourceOf("layout(local_size_x = 1) in;\n"
                             "uniform usamplerBuffer texels;\n"
                             "layout(std430, binding = 0) buffer Out { uvec4 result[]; };\n"
                             "void main() {\n"
                             "  int i = int(gl_GlobalInvocationID.x);\n"
                             "  result[i] = texelFetch(texels, i);\n"
                             "}\n"));
    const BufferTexture texture(context, kPatterns);
    std::array<glm::uvec4, kPatterns.size()> result{};
    const StorageBuffer output(context, sizeof result);
    texture.bind(2);
    output.bind(0);
    program.set("texels", 2);
    program.dispatch({static_cast<unsigned>(result.size()), 1, 1});
    output.read(std::as_writable_bytes(std::span(result)));
    for (std::size_t i = 0; i < result.size(); ++i) {
      for (int c = 0; c < 4; ++c) CHECK(result[i][c] == kPatterns[i][c]);
    }
  });
}

TEST_CASE("a picture keeps every bit pattern that a fragment program writes", "[gl]") {
  inEachContext([](Context& context) {
    Program program(context, Stage::fragment,
                    sourceOf("uniform usamplerBuffer texels;\n"
                             "out vec4 color;\n"
                             "void main() {\n"
                             "  color = uintBitsToFloat(texelFetch(texels, int(gl_FragCoord.x)));\n"
                             "}\n"));
    const BufferTexture texture(context, kPatterns);
    texture.bind(0);
    program.set("texels", 0);
    const std::vector<float> pixels =
        drawnPixels(context, program, static_cast<int>(kPatterns.size()), 1);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      CHECK(std::bit_cast<std::uint32_t>(pixels[i]) == kPatterns[i / 4][static_cast<int>(i % 4)]);
    }
  });
}

TEST_CASE("BufferTexture without texels holds one zero texel", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const BufferTexture texture(*context, {});
  texture.bind(0);
  Program program(*context, Stage::fragment,
                  sourceOf("uniform usamplerBuffer texels;\nout vec4 color;\n"
                           "void main() { color = vec4(texelFetch(texels, 0)) + 1.0; }\n"));
  CHECK(drawnPixels(*context, program, 1, 1) == std::vector<float>(4, 1.0f));
}

TEST_CASE("BufferTexture names the figures when there are too many texels", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  // Only the size is looked at before the error, so nothing stands behind the pointer.
  const std::span<const glm::uvec4> texels(kPatterns.data(), std::size_t{1} << 40);
  const std::string message = messageOf<DeviceError>([&] { BufferTexture(*context, texels); });
  CHECK(message.find("scene texels: found 1099511627776, the device allows ") == 0);
}

TEST_CASE("FloatTarget names the figures when it is too large", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const int size = FloatTarget::maxSize(*context) + 1;
  const std::string message = messageOf<DeviceError>([&] { FloatTarget(*context, 1, size); });
  CHECK(message == "picture height: found " + std::to_string(size) + ", the device allows " +
                       std::to_string(size - 1));
}

TEST_CASE("FloatTarget keeps the outputs of a program apart", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  Program program(*context, Stage::fragment,
                  sourceOf("layout(location = 0) out vec4 a;\nlayout(location = 1) out vec4 b;\n"
                           "void main() { a = vec4(-1.0); b = vec4(2.0); }\n"));
  FloatTarget target(*context, 1, 1, 2);
  target.draw(program);
  std::array<float, 4> first{};
  std::array<float, 4> second{};
  target.read(first, 0);
  target.read(second, 1);
  CHECK(first[0] == -1.0f);
  CHECK(second[0] == 2.0f);
}

TEST_CASE("StorageBuffer names the figures when it is too large", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const std::string message =
      messageOf<DeviceError>([&] { StorageBuffer(*context, std::size_t{1} << 50); });
  CHECK(message.find("bytes of a storage buffer: found 1125899906842624, the device allows ") == 0);
}

}  // namespace twintrace
