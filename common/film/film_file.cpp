#include "common/film/film_file.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/film/atomic_file.h"
#include "common/trace/options.h"

namespace twintrace {
namespace {

// The arrays go to the file as they lie in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(PixelSums) == 96);

using Json = nlohmann::json;

constexpr char kMagic[8] = {'T', 'W', 'I', 'N', 'F', 'I', 'L', 'M'};
constexpr std::uint32_t kVersion = 1;
constexpr std::uint64_t kFixedSize =
    sizeof(kMagic) + 2 * sizeof(std::uint32_t) + sizeof(XXH64_hash_t);

class Checksum {
 public:
  Checksum() : state_(XXH3_createState(), XXH3_freeState) { XXH3_64bits_reset(state_.get()); }
  void update(const void* data, std::size_t size) { XXH3_64bits_update(state_.get(), data, size); }
  XXH64_hash_t digest() const { return XXH3_64bits_digest(state_.get()); }

 private:
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

Json headerOf(const FilmData& data) {
  Json ranges = Json::array();
  for (const SampleRange& range : data.ranges.list()) ranges.push_back({range.first, range.count});
  Json places = Json::array();
  for (const BadFrame& bad : data.badPlaces) {
    places.push_back({bad.x, bad.y, bad.firstSample, std::bit_cast<std::uint32_t>(bad.values[0]),
                      std::bit_cast<std::uint32_t>(bad.values[1]),
                      std::bit_cast<std::uint32_t>(bad.values[2])});
  }
  return {{"width", data.width}, {"height", data.height},     {"passes", data.passes},
          {"samples", ranges},   {"metadata", data.metadata}, {"bad_frames", places}};
}

class FilmWriter {
 public:
  explicit FilmWriter(const std::string& path) : stream_(path, std::ios::binary) {}

  void write(const void* data, std::size_t size) {
    stream_.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
    checksum_.update(data, size);
  }

  /// Appends the checksum; false if anything failed to be written.
  bool finish() {
    const XXH64_hash_t digest = checksum_.digest();
    write(&digest, sizeof(digest));
    stream_.close();
    return stream_.good();
  }

 private:
  std::ofstream stream_;
  Checksum checksum_;
};

class FilmReader {
 public:
  explicit FilmReader(const std::string& path) : path_(path), stream_(path, std::ios::binary) {
    std::error_code error;
    size_ =
        std::filesystem::is_directory(path, error) ? 0 : std::filesystem::file_size(path, error);
    if (error) throw IoError(path + ": cannot be read: " + error.message());
    if (!stream_.is_open() || std::filesystem::is_directory(path)) {
      throw IoError(path + ": cannot be read");
    }
  }

  Film read() {
    const Json header = readHeader();
    FilmData data = decode(header);
    readBytes(data.pixels.data(), data.pixels.size() * sizeof(PixelSums));
    readBytes(data.badCount.data(), data.badCount.size() * sizeof(std::uint32_t));
    const XXH64_hash_t expected = checksum_.digest();
    XXH64_hash_t found = 0;
    readBytes(&found, sizeof(found));
    if (found != expected) fail("found a checksum that does not match: the file is damaged");
    checkBadFrames(data);
    return Film(std::move(data));
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw FileError({Diagnostic{SourceLocation{path_}, message}});
  }

  void readBytes(void* data, std::size_t size) {
    stream_.read(static_cast<char*>(data), static_cast<std::streamsize>(size));
    if (!stream_) throw IoError(path_ + ": cannot be read");
    checksum_.update(data, size);
  }

  Json readHeader() {
    char magic[sizeof(kMagic)] = {};
    if (size_ < kFixedSize) fail("found " + std::to_string(size_) + " bytes, expected a film");
    readBytes(magic, sizeof(magic));
    if (std::memcmp(magic, kMagic, sizeof(magic)) != 0)
      fail("found another kind of file, expected a film");
    std::uint32_t version = 0;
    readBytes(&version, sizeof(version));
    if (version != kVersion) {
      fail("found film version " + std::to_string(version) + ", expected " +
           std::to_string(kVersion));
    }
    readBytes(&headerSize_, sizeof(headerSize_));
    if (headerSize_ > size_ - kFixedSize) fail("found the file cut off in its header");
    std::string text(headerSize_, '\0');
    readBytes(text.data(), text.size());
    Json header = Json::parse(text, nullptr, false);
    if (header.is_discarded()) fail("found a header that is not JSON");
    return header;
  }

  FilmData decode(const Json& header) {
    try {
      FilmData data;
      data.width = header.at("width").get<int>();
      data.height = header.at("height").get<int>();
      data.passes = header.at("passes").get<int>();
      data.metadata = header.at("metadata").get<FilmMetadata>();
      for (const Json& range : header.at("samples")) {
        data.ranges.add(
            SampleRange{range.at(0).get<std::uint64_t>(), range.at(1).get<std::uint64_t>()});
      }
      for (const Json& bad : header.at("bad_frames")) data.badPlaces.push_back(decodeBadFrame(bad));
      allocate(data);
      return data;
    } catch (const Json::exception& error) {
      fail(std::string("found a header that is not a film's: ") + error.what());
    } catch (const UsageError& error) {
      fail(error.what());
    }
  }

  static BadFrame decodeBadFrame(const Json& bad) {
    const auto value = [&](std::size_t i) {
      return std::bit_cast<float>(bad.at(i).get<std::uint32_t>());
    };
    return BadFrame{bad.at(0).get<int>(),
                    bad.at(1).get<int>(),
                    bad.at(2).get<std::uint32_t>(),
                    {value(3), value(4), value(5)}};
  }

  /// Makes room for the arrays, once the header is known to match the size of the file.
  void allocate(FilmData& data) const {
    if (data.width < 1 || data.height < 1 || std::int64_t{data.width} * data.height > kMaxPixels) {
      fail("found a film of " + std::to_string(data.width) + "x" + std::to_string(data.height) +
           " pixels");
    }
    if (data.passes < 0 || data.passes > kMaxPasses ||
        (data.passes == 0) != data.ranges.list().empty()) {
      fail("found " + std::to_string(data.passes) + " passes per frame");
    }
    const auto pixelCount =
        static_cast<std::size_t>(data.width) * static_cast<std::size_t>(data.height);
    const std::uint64_t expected =
        kFixedSize + headerSize_ + pixelCount * (sizeof(PixelSums) + sizeof(std::uint32_t));
    if (size_ != expected) {
      fail("found " + std::to_string(size_) + " bytes, expected " + std::to_string(expected));
    }
    data.pixels.resize(pixelCount);
    data.badCount.resize(pixelCount);
  }

  /// A checksum shows no fault of the program that wrote the file.
  void checkBadFrames(const FilmData& data) const {
    const std::uint64_t frames =
        data.passes == 0 ? 0 : data.ranges.sampleCount() / std::uint64_t(data.passes);
    for (const std::uint32_t bad : data.badCount) {
      if (bad <= frames) continue;
      fail("found " + std::to_string(bad) + " bad frames in a pixel, expected at most " +
           std::to_string(frames));
    }
    if (data.badPlaces.size() > kMaxBadPlaces) {
      fail("found " + std::to_string(data.badPlaces.size()) + " places of bad frames, expected " +
           "at most " + std::to_string(kMaxBadPlaces));
    }
    for (const BadFrame& bad : data.badPlaces) {
      if (bad.x >= 0 && bad.x < data.width && bad.y >= 0 && bad.y < data.height) continue;
      fail("found a bad frame at pixel " + std::to_string(bad.x) + "," + std::to_string(bad.y) +
           ", expected a pixel of the film");
    }
  }

  std::string path_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  std::uint32_t headerSize_ = 0;
  Checksum checksum_;
};

}  // namespace

void writeFilm(const std::string& path, const Film& film) {
  const FilmData& data = film.data();
  const std::string header = headerOf(data).dump();
  const auto headerSize = static_cast<std::uint32_t>(header.size());
  AtomicFile file(path);
  FilmWriter writer(file.partialPath());
  writer.write(kMagic, sizeof(kMagic));
  writer.write(&kVersion, sizeof(kVersion));
  writer.write(&headerSize, sizeof(headerSize));
  writer.write(header.data(), header.size());
  writer.write(data.pixels.data(), data.pixels.size() * sizeof(PixelSums));
  writer.write(data.badCount.data(), data.badCount.size() * sizeof(std::uint32_t));
  if (!writer.finish()) throw IoError(path + ": cannot be written");
  file.commit();
}

Film readFilm(const std::string& path) {
  return FilmReader(path).read();
}

}  // namespace twintrace
