#include "common/film/film.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/error.h"
#include "common/film/film_file.h"
#include "tests/catch.h"
#include "tests/unit/film/film_fixtures.h"

using namespace twintrace;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr int kWidth = 7;
constexpr int kHeight = 5;
constexpr int kPasses = 4;

Film emptyFilm() {
  return Film(kWidth, kHeight, {{"scene", "abc"}});
}

/// Frame number `index` of a rendering in which each seventh frame has bad values.
std::vector<float> frame(std::uint32_t index) {
  std::vector<float> sums = test::randomFrame(kWidth, kHeight, index);
  if (index % 7 == 3) sums[index % sums.size()] = index % 2 == 0 ? kNan : kInfinity;
  return sums;
}

void addFrames(Film& film, const std::vector<std::uint32_t>& indices) {
  for (const std::uint32_t index : indices) film.addFrame(frame(index), kPasses, index * kPasses);
}

std::string fileBytes(const Film& film) {
  const test::TemporaryDirectory directory;
  writeFilm(directory.file("x.film"), film);
  return test::bytesOf(directory.file("x.film"));
}

Film onePixel(const std::vector<std::vector<float>>& frames, int passes = 1) {
  Film film(1, 1, {});
  std::uint32_t first = 0;
  for (const std::vector<float>& sums : frames) {
    film.addFrame(sums, passes, first);
    first += static_cast<std::uint32_t>(passes);
  }
  return film;
}

}  // namespace

TEST_CASE("Film divides sums by frames and passes only in its queries", "[film]") {
  const Film film = onePixel({{4.0f, 2.0f, 0.0f}, {8.0f, 2.0f, 0.0f}}, 4);
  CHECK(film.mean().rgb == std::vector<float>{1.5f, 0.5f, 0.0f});
  CHECK(film.variance().rgb == std::vector<float>{0.5f, 0.0f, 0.0f});  // of frame means 1 and 2
  CHECK(film.count() == std::vector<float>{2.0f});
  CHECK(film.data().ranges.toString() == "0-7");
}

TEST_CASE("Film without frames has no mean and no count", "[film]") {
  const Film film(1, 1, {});
  CHECK(std::isnan(film.mean().rgb[0]));
  CHECK(film.variance().rgb[0] == 0.0f);
  CHECK(film.count()[0] == 0.0f);
  CHECK(film.frameCount() == 0);
}

TEST_CASE("Film leaves a bad frame out of its pixel and says where", "[film]") {
  const float limit = 1073741824.0f;
  for (const float bad : {kNan, kInfinity, -kInfinity, limit, -limit}) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      Film film(2, 1, {});
      std::vector<float> sums = {1.0f, 1.0f, 1.0f, 2.0f, 2.0f, 2.0f};
      film.addFrame(sums, 1, 0);
      sums[3 + channel] = bad;
      film.addFrame(sums, 1, 1);
      CHECK(film.count() == std::vector<float>{2.0f, 1.0f});
      CHECK(film.mean().rgb == std::vector<float>{1.0f, 1.0f, 1.0f, 2.0f, 2.0f, 2.0f});
      CHECK(film.badFrameCount() == 1);
      REQUIRE(film.data().badPlaces.size() == 1);
      const BadFrame& place = film.data().badPlaces[0];
      CHECK(place.x == 1);
      CHECK(place.y == 0);
      CHECK(place.firstSample == 1);
      CHECK((place.values[channel] == bad || std::isnan(bad)));
    }
  }
}

TEST_CASE("Film keeps the first places of bad frames and counts all", "[film]") {
  Film film(40, 3, {});
  film.addFrame(std::vector<float>(360, kNan), 1, 5);
  film.addFrame(std::vector<float>(360, kNan), 1, 0);
  CHECK(film.badFrameCount() == 240);
  REQUIRE(film.data().badPlaces.size() == kMaxBadPlaces);
  for (int i = 0; i < static_cast<int>(kMaxBadPlaces); ++i) {
    const BadFrame& place = film.data().badPlaces[static_cast<std::size_t>(i)];
    CHECK(place.firstSample == 0);
    CHECK(place.x == i);
    CHECK(place.y == 0);
  }
}

TEST_CASE("Film does not keep a NaN's payload", "[film]") {
  const float odd = std::bit_cast<float>(0xffc12345u);
  CHECK(fileBytes(onePixel({{odd, 0.0f, 0.0f}})) == fileBytes(onePixel({{kNan, 0.0f, 0.0f}})));
}

TEST_CASE("Film has the same bytes for any order, split and thread count", "[film]") {
  constexpr std::uint32_t kFrames = 24;
  std::vector<std::uint32_t> order(kFrames);
  for (std::uint32_t i = 0; i < kFrames; ++i) order[i] = i;
  Film whole = emptyFilm();
  addFrames(whole, order);
  const std::string expected = fileBytes(whole);
  std::mt19937 random(11);
  for (int trial = 0; trial < 60; ++trial) {
    INFO("trial " << trial);
    const std::size_t threads =
        std::vector<std::size_t>{1, 2, 5}[static_cast<std::size_t>(trial % 3)];
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Film> parts;
    std::size_t taken = 0;
    while (taken < order.size()) {
      const std::size_t count = std::min<std::size_t>(1 + random() % 10, order.size() - taken);
      parts.push_back(emptyFilm());
      const auto first = order.begin() + static_cast<std::ptrdiff_t>(taken);
      addFrames(parts.back(), {first, first + static_cast<std::ptrdiff_t>(count)});
      taken += count;
    }
    Film merged = emptyFilm();
    std::shuffle(parts.begin(), parts.end(), random);
    for (const Film& part : parts) merged.merge(part);
    REQUIRE(fileBytes(merged) == expected);
    REQUIRE(compareFilms(merged, whole).differingPixels == 0);
  }
}

TEST_CASE("Film refuses frames that do not fit", "[film]") {
  Film film = emptyFilm();
  addFrames(film, {0});
  const std::vector<float> sums = frame(1);
  CHECK_THROWS_AS(film.addFrame(std::span(sums).first(3), kPasses, 4), UsageError);
  CHECK_THROWS_AS(film.addFrame(sums, kPasses + 1, 4), UsageError);
  CHECK_THROWS_AS(film.addFrame(sums, kPasses, 0), UsageError);
  CHECK_THROWS_AS(film.addFrame(sums, kPasses, 3), UsageError);
  CHECK_THROWS_AS(emptyFilm().addFrame(sums, 0, 0), UsageError);
  CHECK_THROWS_AS(emptyFilm().addFrame(sums, 4097, 0), UsageError);
  Film untouched = emptyFilm();
  addFrames(untouched, {0});
  CHECK(compareFilms(film, untouched).differingPixels == 0);
}

TEST_CASE("Film refuses sizes that are empty or too large", "[film]") {
  CHECK_THROWS_AS(Film(0, 4, {}), UsageError);
  CHECK_THROWS_AS(Film(4, -1, {}), UsageError);
  CHECK_THROWS_AS(Film(1 << 15, 1 << 15, {}), UsageError);
}

TEST_CASE("Film merges only with its like and says what differs", "[film]") {
  Film film(2, 2, {{"scene", "abc"}, {"seed", "1"}});
  const auto message = [&](const Film& other) {
    return test::messageOf<UsageError>([&] { film.merge(other); });
  };
  CHECK(message(Film(2, 3, {{"scene", "abc"}, {"seed", "1"}})) ==
        "found a film of 2x3 pixels, expected 2x2");
  CHECK(message(Film(2, 2, {{"scene", "abc"}, {"seed", "2"}})) ==
        "the films differ in what determines their bits: found seed = 2, expected seed = 1");
  CHECK(message(Film(2, 2, {{"scene", "abc"}})) ==
        "the films differ in what determines their bits: found nothing, expected seed = 1");
  const std::vector<float> sums(12, 1.0f);
  film.addFrame(sums, 2, 0);
  Film other(2, 2, {{"scene", "abc"}, {"seed", "1"}});
  other.addFrame(sums, 3, 6);
  CHECK(message(other) == "found a film with 3 passes per frame, expected 2");
  Film overlapping(2, 2, {{"scene", "abc"}, {"seed", "1"}});
  overlapping.addFrame(sums, 2, 1);
  CHECK(message(overlapping) == "samples 1-2 overlap samples 0-1 that the film already holds");
}

TEST_CASE("Film refuses more frames than its sums can hold", "[film]") {
  FilmData data;
  data.width = data.height = data.passes = 1;
  data.ranges.add(SampleRange{0, kMaxFrames});
  data.pixels.resize(1);
  data.badCount.resize(1);
  Film film(std::move(data));
  CHECK_THROWS_AS(film.addFrame(std::vector<float>(3, 1.0f), 1, kMaxFrames), UsageError);
}

TEST_CASE("compareFilms counts differing pixels and finds the first", "[film]") {
  Film a = emptyFilm();
  Film b = emptyFilm();
  std::vector<float> sums = frame(0);
  a.addFrame(sums, kPasses, 0);
  CHECK(compareFilms(a, b).differingPixels == kWidth * kHeight);
  sums[(2 * kWidth + 3) * 3 + 1] = std::nextafter(sums[(2 * kWidth + 3) * 3 + 1], 1e9f);
  sums[(4 * kWidth + 1) * 3] = kNan;
  b.addFrame(sums, kPasses, 0);
  const FilmDifference difference = compareFilms(a, b);
  CHECK(difference.differingPixels == 2);
  CHECK(difference.first == PixelPosition{3, 2});
  CHECK_THROWS_AS(compareFilms(a, Film(1, 1, {})), UsageError);
}

TEST_CASE("relativeStandardError is that of the image mean", "[film]") {
  CHECK(std::isinf(relativeStandardError(onePixel({{1.0f, 1.0f, 1.0f}}))));
  CHECK(relativeStandardError(onePixel({{1.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 1.0f}})) == 0.0);
  // Channel 0: frame means 1 and 3: mean 2, variance 2, error of the mean 1.
  CHECK(relativeStandardError(onePixel({{1.0f, 1.0f, 1.0f}, {3.0f, 1.0f, 1.0f}})) == 0.5);
}
