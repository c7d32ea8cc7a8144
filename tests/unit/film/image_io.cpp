#include "common/film/image_io.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "common/base/error.h"
#include "tests/catch.h"
#include "tests/unit/film/film_fixtures.h"

using namespace twintrace;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image gradient(int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = 0.37f * static_cast<float>(i) - 1.0f;
  return image;
}

bool sameBytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

ExrContent someContent() {
  ExrContent content;
  content.image = gradient(5, 4);
  content.image.rgb[3] = kNan;
  content.image.rgb[4] = -kInfinity;
  content.image.rgb[5] = 1e-42f;
  content.variance = gradient(5, 4);
  content.variance.rgb[0] = 0.125f;
  content.count.assign(20, 64.0f);
  content.extra = {{"ulp", std::vector<float>(20, 3.0f)}, {"z.R", std::vector<float>(20, -1.5f)}};
  content.metadata = {{"scene", "abc"}, {"seed", "1"}};
  return content;
}

/// Writes an image with any channels, as another program would.
void writeForeign(const std::string& path, const std::vector<std::string>& channels,
                  const std::vector<float>& pixel, OIIO::TypeDesc format = OIIO::TypeDesc::FLOAT) {
  OIIO::ImageSpec spec(2, 1, static_cast<int>(channels.size()), format);
  spec.channelnames = channels;
  std::vector<float> values = pixel;
  values.insert(values.end(), pixel.begin(), pixel.end());
  const auto output = OIIO::ImageOutput::create(path);
  REQUIRE(output);
  REQUIRE(output->open(path, spec));
  REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  REQUIRE(output->close());
}

}  // namespace

TEST_CASE("readExr gives back every bit and key that writeExr wrote", "[film]") {
  const test::TemporaryDirectory directory;
  const ExrContent content = someContent();
  writeExr(directory.file("a.exr"), content);
  const ExrContent read = readExr(directory.file("a.exr"));
  CHECK(read.image.width == 5);
  CHECK(read.image.height == 4);
  CHECK(sameBytes(read.image.rgb, content.image.rgb));
  CHECK(sameBytes(read.variance.rgb, content.variance.rgb));
  CHECK(read.count == content.count);
  CHECK(read.metadata == content.metadata);
  REQUIRE(read.extra.size() == 2);
  CHECK(read.extra[0].name == "ulp");
  CHECK(read.extra[0].values == content.extra[0].values);
  CHECK(read.extra[1].name == "z.R");
}

TEST_CASE("writeExr writes equal bytes for equal content", "[film]") {
  const test::TemporaryDirectory directory;
  writeExr(directory.file("a.exr"), someContent());
  writeExr(directory.file("b.exr"), someContent());
  CHECK(test::bytesOf(directory.file("a.exr")) == test::bytesOf(directory.file("b.exr")));
  CHECK(test::bytesOf(directory.file("a.exr")).find(".partial") == std::string::npos);
}

TEST_CASE("writeExr writes floats, ZIP, and prefixed keys", "[film]") {
  const test::TemporaryDirectory directory;
  writeExr(directory.file("a.exr"), someContent());
  const auto input = OIIO::ImageInput::open(directory.file("a.exr"));
  REQUIRE(input);
  CHECK(input->spec().format == OIIO::TypeDesc::FLOAT);
  CHECK(input->spec().get_string_attribute("compression") == "zip");
  CHECK(input->spec().get_string_attribute("twintrace:seed") == "1");
  CHECK(input->spec().get_string_attribute("DateTime") == "1970:01:01 00:00:00");
}

TEST_CASE("exrContent holds what a film knows", "[film]") {
  Film film(2, 1, {{"seed", "1"}});
  film.addFrame(std::vector<float>(6, 2.0f), 2, 0);
  film.addFrame(std::vector<float>(6, 6.0f), 2, 8);
  const ExrContent content = exrContent(film);
  CHECK(content.image.rgb == std::vector<float>(6, 2.0f));
  CHECK(content.variance.rgb == std::vector<float>(6, 2.0f));
  CHECK(content.count == std::vector<float>(2, 2.0f));
  CHECK(content.metadata == FilmMetadata{{"passes", "2"}, {"samples", "0-1,8-9"}, {"seed", "1"}});
}

TEST_CASE("readExr finds colours by name, else takes the first channels", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  writeForeign(path, {"A", "R", "G", "B"}, {9.0f, 1.0f, 2.0f, 3.0f});
  CHECK(readExr(path).image.rgb == std::vector<float>{1, 2, 3, 1, 2, 3});
  CHECK(readExr(path).variance.empty());
  CHECK(readExr(path).count.empty());
  writeForeign(path, {"X", "Y", "Z"}, {4.0f, 5.0f, 6.0f});
  CHECK(readExr(path).image.rgb == std::vector<float>{4, 5, 6, 4, 5, 6});
  writeForeign(path, {"Y"}, {7.0f});
  CHECK(readExr(path).image.rgb == std::vector<float>(6, 7.0f));
}

TEST_CASE("readLinearImage reads EXR and HDR", "[film]") {
  const test::TemporaryDirectory directory;
  for (const std::string name : {"sky.exr", "sky.hdr"}) {
    writeForeign(directory.file(name), {"R", "G", "B"}, {0.5f, 1.0f, 2.0f});
    CHECK(readLinearImage(directory.file(name)).rgb == std::vector<float>{0.5f, 1, 2, 0.5f, 1, 2});
  }
}

TEST_CASE("readLinearImage refuses display values", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("a.png");
  writePng(path, gradient(2, 2));
  CHECK(test::messageOf<FileError>([&] { readLinearImage(path); }) ==
        path + ": found an image of uint8, expected linear floats (EXR or HDR)");
}

TEST_CASE("readers name the file and the reason", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string none = directory.file("none.exr");
  CHECK(test::messageOf<IoError>([&] { readExr(none); }) ==
        none + ": cannot be read: no such file");
  const std::string broken = directory.file("broken.exr");
  test::writeBytes(broken, "this is not an image");
  const std::string message = test::messageOf<IoError>([&] { readExr(broken); });
  CHECK(message.starts_with(broken + ": cannot be read: "));
  CHECK(message.size() > (broken + ": cannot be read: ").size());
}

TEST_CASE("readers report a file cut off in its pixels", "[film]") {
  const test::TemporaryDirectory directory;
  ExrContent content;
  content.image = gradient(200, 200);
  writeExr(directory.file("a.exr"), content);
  const std::string bytes = test::bytesOf(directory.file("a.exr"));
  for (const std::size_t size : {bytes.size() / 2, bytes.size() / 50, std::size_t{100}}) {
    test::writeBytes(directory.file("a.exr"), bytes.substr(0, size));
    CHECK_THROWS_AS(readExr(directory.file("a.exr")), IoError);
  }
}

TEST_CASE("writers name the file and leave nothing behind when they fail", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("missing/a.exr");
  CHECK(test::messageOf<IoError>([&] {
          writeExr(path, someContent());
        }).starts_with(path + ": cannot be written: "));
  CHECK_THROWS_AS(writePng(directory.file("missing/a.png"), gradient(2, 2)), IoError);
  CHECK_THROWS_AS(writePng(directory.file("a.unknown"), gradient(2, 2)), IoError);
  CHECK(directory.empty());
}

TEST_CASE("srgbCode follows the sRGB curve and clips", "[film]") {
  CHECK(srgbCode(0.0f) == 0);
  CHECK(srgbCode(-1.0f) == 0);
  CHECK(srgbCode(kNan) == 0);
  CHECK(srgbCode(1.0f) == 255);
  CHECK(srgbCode(kInfinity) == 255);
  CHECK(srgbCode(0.0031308f) == 10);
  CHECK(srgbCode(0.21404114f) == 128);  // the linear value of code 127.5
  CHECK(srgbCode(0.5f) == 188);
}

TEST_CASE("toDisplay shows pixels with a NaN in magenta", "[film]") {
  Image image(2, 1);
  image.rgb = {0.0f, kNan, 0.0f, 1.0f, kInfinity, 0.0f};
  CHECK(toDisplay(image).rgb == std::vector<std::uint8_t>{255, 0, 255, 255, 255, 0});
}

TEST_CASE("writePng writes equal bytes for equal content", "[film]") {
  const test::TemporaryDirectory directory;
  writePng(directory.file("a.png"), gradient(9, 9));
  writePng(directory.file("b.png"), gradient(9, 9));
  CHECK(test::bytesOf(directory.file("a.png")) == test::bytesOf(directory.file("b.png")));
}
