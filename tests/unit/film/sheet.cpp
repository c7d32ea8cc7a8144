#include "common/film/sheet.h"

#include <limits>

#include "common/film/canvas.h"
#include "common/film/font.h"
#include "tests/catch.h"

using namespace twintrace;

namespace {

SheetContent someContent(int width, int height) {
  SheetContent content;
  content.header = {"verdict: different"};
  content.a = Image(width, height);
  content.b = Image(width, height);
  content.ulp.assign(content.a.pixelCount(), 0.0f);
  return content;
}

std::size_t countColour(const DisplayImage& image, const Colour& colour) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    count +=
        image.rgb[i] == colour[0] && image.rgb[i + 1] == colour[1] && image.rgb[i + 2] == colour[2];
  }
  return count;
}

}  // namespace

TEST_CASE("glyphOf tells printable characters apart", "[film]") {
  for (char a = '!'; a <= '`'; ++a) {
    for (char b = '!'; b < a && a != '\\' && a != '`' && a != '{'; ++b) {
      INFO(a << " and " << b);
      if (b != '\\') CHECK(glyphOf(a) != glyphOf(b));
    }
  }
  CHECK(glyphOf('q') == glyphOf('Q'));
  CHECK(glyphOf('\x80') == glyphOf('\n'));
}

TEST_CASE("Canvas cuts off what falls outside", "[film]") {
  Canvas canvas(4, 4, {0, 0, 0});
  canvas.fillRectangle(-5, 3, 100, 100, {1, 2, 3});
  canvas.drawText(2, -12, "WWW", {9, 9, 9}, 2);
  CHECK(countColour(canvas.image(), {1, 2, 3}) == 4);
}

TEST_CASE("Canvas draws text at the scale asked for", "[film]") {
  Canvas canvas(20, 20, {0, 0, 0});
  canvas.drawText(1, 1, "-", {255, 255, 255}, 2);
  CHECK(countColour(canvas.image(), {255, 255, 255}) == 5 * 2 * 2);
}

TEST_CASE("drawSheet enlarges small pictures by a whole factor", "[film]") {
  SheetContent content = someContent(16, 8);
  content.a.rgb[0] = content.a.rgb[1] = content.a.rgb[2] = std::numeric_limits<float>::quiet_NaN();
  const DisplayImage sheet = drawSheet(content);
  // Magenta in a and in the difference, 23 = ceil(360 / 16) screen pixels wide and high.
  CHECK(countColour(sheet, {255, 0, 255}) == 2 * 23 * 23);
}

TEST_CASE("drawSheet leaves out maps that are not there", "[film]") {
  SheetContent content = someContent(16, 16);
  const DisplayImage withUlp = drawSheet(content);
  content.z = Image(16, 16);
  const DisplayImage withZ = drawSheet(content);
  CHECK(withZ.width > withUlp.width);
}

TEST_CASE("drawSheet copes with single pixels, no header and long names", "[film]") {
  SheetContent content = someContent(1, 1);
  content.header = {std::string(3000, 'x'), ""};
  content.nameA = std::string(500, 'a');
  CHECK(drawSheet(content).width > 0);
  content.header.clear();
  content.ulp.clear();
  CHECK(drawSheet(content).height > 0);
}
