#include "common/film/film_file.h"

#include <limits>

#include "common/base/error.h"
#include "tests/catch.h"
#include "tests/unit/film/film_fixtures.h"

using namespace twintrace;

namespace {

Film someFilm() {
  Film film(5, 3, {{"scene", "abc"}, {"seed", "1"}});
  film.addFrame(test::randomFrame(5, 3, 1), 2, 0);
  std::vector<float> bad = test::randomFrame(5, 3, 2);
  bad[7] = -std::numeric_limits<float>::infinity();
  film.addFrame(bad, 2, 10);
  return film;
}

}  // namespace

TEST_CASE("readFilm gives back what writeFilm wrote", "[film]") {
  const test::TemporaryDirectory directory;
  const Film film = someFilm();
  writeFilm(directory.file("a.film"), film);
  const Film read = readFilm(directory.file("a.film"));
  CHECK(compareFilms(read, film).differingPixels == 0);
  CHECK(read.passes() == 2);
  CHECK(read.data().metadata == film.data().metadata);
  CHECK(read.data().ranges == film.data().ranges);
  REQUIRE(read.data().badPlaces.size() == 1);
  CHECK(read.data().badPlaces[0].values == film.data().badPlaces[0].values);
  writeFilm(directory.file("b.film"), read);
  CHECK(test::bytesOf(directory.file("a.film")) == test::bytesOf(directory.file("b.film")));
}

TEST_CASE("readFilm goes on where a film ended", "[film]") {
  const test::TemporaryDirectory directory;
  writeFilm(directory.file("a.film"), someFilm());
  Film read = readFilm(directory.file("a.film"));
  CHECK_THROWS_AS(read.addFrame(test::randomFrame(5, 3, 3), 2, 10), UsageError);
  CHECK_NOTHROW(read.addFrame(test::randomFrame(5, 3, 3), 2, 12));
}

TEST_CASE("readFilm notices every damaged byte", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("a.film");
  writeFilm(path, someFilm());
  const std::string bytes = test::bytesOf(path);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    test::writeBytes(path, damaged);
    INFO("byte " << i << " of " << bytes.size());
    REQUIRE_THROWS_AS(readFilm(path), FileError);
  }
}

TEST_CASE("readFilm notices a file cut off anywhere", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("a.film");
  writeFilm(path, someFilm());
  const std::string bytes = test::bytesOf(path);
  for (std::size_t size = 0; size < bytes.size(); size += 13) {
    test::writeBytes(path, bytes.substr(0, size));
    INFO("cut at " << size);
    REQUIRE_THROWS_AS(readFilm(path), FileError);
  }
}

TEST_CASE("readFilm says what it found", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("a.film");
  const auto message = [&] { return test::messageOf<FileError>([&] { readFilm(path); }); };
  test::writeBytes(path, "short");
  CHECK(message() == path + ": found 5 bytes, expected a film");
  test::writeBytes(path, "this is certainly not a film file");
  CHECK(message() == path + ": found another kind of file, expected a film");
  writeFilm(path, someFilm());
  std::string bytes = test::bytesOf(path);
  bytes[8] = 9;
  test::writeBytes(path, bytes);
  CHECK(message() == path + ": found film version 9, expected 1");
  bytes[8] = 1;
  test::writeBytes(path, bytes + "x");
  CHECK(message() == path + ": found " + std::to_string(bytes.size() + 1) + " bytes, expected " +
                         std::to_string(bytes.size()));
  bytes.back() = static_cast<char>(bytes.back() + 1);
  test::writeBytes(path, bytes);
  CHECK(message() == path + ": found a checksum that does not match: the file is damaged");
}

TEST_CASE("readFilm refuses bad frames that can't be", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("a.film");
  const auto dataWith = [](const BadFrame& place) {
    FilmData data;
    data.width = data.height = 1;
    data.passes = 2;
    data.ranges.add(SampleRange{0, 4});
    data.pixels.resize(1);
    data.badCount = {2};
    data.badPlaces = {place};
    return data;
  };
  writeFilm(path, Film(dataWith(BadFrame{})));
  CHECK_NOTHROW(readFilm(path));
  writeFilm(path, Film(dataWith(BadFrame{1, 0, 0, {}})));
  CHECK_THROWS_AS(readFilm(path), FileError);
  FilmData tooMany = dataWith(BadFrame{});
  tooMany.badCount = {3};
  writeFilm(path, Film(std::move(tooMany)));
  CHECK_THROWS_AS(readFilm(path), FileError);
  FilmData tooManyPlaces = dataWith(BadFrame{});
  tooManyPlaces.badPlaces.resize(kMaxBadPlaces + 1);
  writeFilm(path, Film(std::move(tooManyPlaces)));
  CHECK_THROWS_AS(readFilm(path), FileError);
}

TEST_CASE("readFilm names a file that is not there", "[film]") {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("none.film");
  CHECK(test::messageOf<IoError>([&] { readFilm(path); }) ==
        path + ": cannot be read: No such file or directory");
  CHECK_THROWS_AS(readFilm(directory.file("")), IoError);
}

TEST_CASE("writeFilm leaves nothing behind when it fails", "[film]") {
  const test::TemporaryDirectory directory;
  CHECK_THROWS_AS(writeFilm(directory.file("missing/a.film"), someFilm()), IoError);
  CHECK(directory.empty());
}
