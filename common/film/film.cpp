#include "common/film/film.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <tuple>

#include "common/base/error.h"
#include "common/base/parallel_for.h"
#include "common/trace/options.h"

namespace twintrace {
namespace {

/// Calls body(y) for every row, in parallel.
template <class Body>
void forRows(int height, const Body& body) {
  parallelFor(tbb::blocked_range<int>(0, height), [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y != rows.end(); ++y) body(y);
  });
}

std::size_t pixelIndex(const FilmData& data, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(data.width) +
         static_cast<std::size_t>(x);
}

/// The payload of a NaN depends on the machine that made it, the bytes of a film must not.
float canonicalNan(float value) {
  return value != value ? std::numeric_limits<float>::quiet_NaN() : value;
}

auto orderOf(const BadFrame& bad) {
  return std::tuple(bad.firstSample, bad.y, bad.x);
}

std::string sizeText(const FilmData& data) {
  return std::to_string(data.width) + "x" + std::to_string(data.height);
}

void requireFilmSize(int width, int height) {
  if (width > 0 && height > 0 && std::int64_t{width} * height <= kMaxPixels) return;
  throw UsageError("found a film of " + std::to_string(width) + "x" + std::to_string(height) +
                   " pixels, expected positive sides and at most " + std::to_string(kMaxPixels) +
                   " pixels");
}

void requireFrame(const FilmData& data, std::size_t sumCount, int passes) {
  if (sumCount != data.pixels.size() * 3) {
    throw UsageError("found a frame of " + std::to_string(sumCount) + " values, expected " +
                     std::to_string(data.pixels.size() * 3));
  }
  if (passes < 1 || passes > kMaxPasses) {
    throw UsageError("found " + std::to_string(passes) + " passes, expected 1 to " +
                     std::to_string(kMaxPasses));
  }
  if (data.passes != 0 && passes != data.passes) {
    throw UsageError("found a frame of " + std::to_string(passes) + " passes, expected " +
                     std::to_string(data.passes) + " as in the film's other frames");
  }
}

void requireFrameCount(const SampleRanges& ranges, int passes) {
  if (ranges.sampleCount() / static_cast<std::uint64_t>(passes) <= kMaxFrames) return;
  throw UsageError("a film holds at most " + std::to_string(kMaxFrames) + " frames");
}

void requireSameMetadata(const FilmMetadata& a, const FilmMetadata& b) {
  if (a == b) return;
  const auto [inA, inB] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const auto describe = [](auto entry, const FilmMetadata& all) {
    return entry == all.end() ? std::string("nothing") : entry->first + " = " + entry->second;
  };
  throw UsageError("the films differ in what determines their bits: found " + describe(inB, b) +
                   ", expected " + describe(inA, a));
}

void requireMergeable(const FilmData& a, const FilmData& b) {
  if (a.width != b.width || a.height != b.height) {
    throw UsageError("found a film of " + sizeText(b) + " pixels, expected " + sizeText(a));
  }
  requireSameMetadata(a.metadata, b.metadata);
  if (a.passes != 0 && b.passes != 0 && a.passes != b.passes) {
    throw UsageError("found a film with " + std::to_string(b.passes) +
                     " passes per frame, expected " + std::to_string(a.passes));
  }
}

}  // namespace

Film::Film(int width, int height, FilmMetadata metadata) {
  requireFilmSize(width, height);
  data_.width = width;
  data_.height = height;
  data_.metadata = std::move(metadata);
  const std::size_t pixelCount = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  data_.pixels.resize(pixelCount);
  data_.badCount.resize(pixelCount);
}

Film::Film(FilmData data) : data_(std::move(data)) {
  assert(data_.pixels.size() == data_.badCount.size());
}

std::uint32_t Film::frameCount() const {
  if (data_.passes == 0) return 0;
  return static_cast<std::uint32_t>(data_.ranges.sampleCount() /
                                    static_cast<std::uint64_t>(data_.passes));
}

void Film::addFrame(std::span<const float> sums, int passes, std::uint32_t firstSample) {
  requireFrame(data_, sums.size(), passes);
  SampleRanges ranges = data_.ranges;
  ranges.add(SampleRange{firstSample, static_cast<std::uint64_t>(passes)});
  requireFrameCount(ranges, passes);

  std::mutex mutex;
  std::vector<BadFrame> badPlaces;
  forRows(data_.height, [&](int y) {
    std::vector<BadFrame> badInRow;
    addRow(sums, y, firstSample, badInRow);
    if (badInRow.empty()) return;
    const std::lock_guard lock(mutex);
    badPlaces.insert(badPlaces.end(), badInRow.begin(), badInRow.end());
  });
  keepBadPlaces(badPlaces);
  data_.ranges = std::move(ranges);
  data_.passes = passes;
}

void Film::addRow(std::span<const float> sums, int y, std::uint32_t firstSample,
                  std::vector<BadFrame>& badPlaces) {
  for (int x = 0; x < data_.width; ++x) {
    const std::size_t pixel = pixelIndex(data_, x, y);
    const float* value = &sums[pixel * 3];
    if (inSumRange(value[0]) && inSumRange(value[1]) && inSumRange(value[2])) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        data_.pixels[pixel][channel].add(value[channel]);
      }
      continue;
    }
    ++data_.badCount[pixel];
    if (badPlaces.size() == kMaxBadPlaces) continue;
    badPlaces.push_back(
        BadFrame{x,
                 y,
                 firstSample,
                 {canonicalNan(value[0]), canonicalNan(value[1]), canonicalNan(value[2])}});
  }
}

void Film::keepBadPlaces(std::span<const BadFrame> places) {
  std::vector<BadFrame>& kept = data_.badPlaces;
  kept.insert(kept.end(), places.begin(), places.end());
  std::sort(kept.begin(), kept.end(),
            [](const BadFrame& a, const BadFrame& b) { return orderOf(a) < orderOf(b); });
  if (kept.size() > kMaxBadPlaces) kept.resize(kMaxBadPlaces);
}

void Film::merge(const Film& other) {
  requireMergeable(data_, other.data_);
  if (other.data_.passes == 0) return;
  SampleRanges ranges = data_.ranges;
  ranges.add(other.data_.ranges);
  requireFrameCount(ranges, other.data_.passes);

  forRows(data_.height, [&](int y) {
    for (int x = 0; x < data_.width; ++x) {
      const std::size_t pixel = pixelIndex(data_, x, y);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        data_.pixels[pixel][channel].merge(other.data_.pixels[pixel][channel]);
      }
      data_.badCount[pixel] += other.data_.badCount[pixel];
    }
  });
  keepBadPlaces(other.data_.badPlaces);
  data_.ranges = std::move(ranges);
  data_.passes = other.data_.passes;
}

std::uint64_t Film::badFrameCount() const {
  std::uint64_t count = 0;
  for (const std::uint32_t bad : data_.badCount) count += bad;
  return count;
}

Image Film::mean() const {
  Image image(data_.width, data_.height);
  const std::uint32_t frames = frameCount();
  forRows(data_.height, [&](int y) {
    for (int x = 0; x < data_.width; ++x) {
      const std::size_t pixel = pixelIndex(data_, x, y);
      const std::uint32_t good = frames - data_.badCount[pixel];
      for (std::size_t channel = 0; channel < 3; ++channel) {
        image.rgb[pixel * 3 + channel] =
            good == 0
                ? std::numeric_limits<float>::quiet_NaN()
                : static_cast<float>(meanOf(data_.pixels[pixel][channel], good) / data_.passes);
      }
    }
  });
  return image;
}

Image Film::variance() const {
  Image image(data_.width, data_.height);
  const std::uint32_t frames = frameCount();
  const double scale = 1.0 / (double(data_.passes) * double(data_.passes));
  forRows(data_.height, [&](int y) {
    for (int x = 0; x < data_.width; ++x) {
      const std::size_t pixel = pixelIndex(data_, x, y);
      const std::uint32_t good = frames - data_.badCount[pixel];
      for (std::size_t channel = 0; good > 1 && channel < 3; ++channel) {
        image.rgb[pixel * 3 + channel] =
            static_cast<float>(varianceOf(data_.pixels[pixel][channel], good) * scale);
      }
    }
  });
  return image;
}

std::vector<float> Film::count() const {
  std::vector<float> counts(data_.badCount.size());
  const std::uint32_t frames = frameCount();
  for (std::size_t pixel = 0; pixel < counts.size(); ++pixel) {
    counts[pixel] = static_cast<float>(frames - data_.badCount[pixel]);
  }
  return counts;
}

FilmDifference compareFilms(const Film& a, const Film& b) {
  if (a.width() != b.width() || a.height() != b.height()) {
    throw UsageError("found films of " + sizeText(a.data()) + " and " + sizeText(b.data()) +
                     " pixels, expected equal sizes");
  }
  FilmDifference difference;
  const bool sameFrames = a.frameCount() == b.frameCount();
  for (std::size_t pixel = 0; pixel < a.data().pixels.size(); ++pixel) {
    if (sameFrames && a.data().pixels[pixel] == b.data().pixels[pixel] &&
        a.data().badCount[pixel] == b.data().badCount[pixel]) {
      continue;
    }
    const int index = static_cast<int>(pixel);
    if (!difference.first) difference.first = PixelPosition{index % a.width(), index / a.width()};
    ++difference.differingPixels;
  }
  return difference;
}

double relativeStandardError(const Film& film) {
  const FilmData& data = film.data();
  const std::uint32_t frames = film.frameCount();
  if (frames < 2) return std::numeric_limits<double>::infinity();

  // Rows are summed one after the other, so that the stop does not depend on the scheduling.
  std::vector<std::array<double, 6>> rows(static_cast<std::size_t>(data.height));
  forRows(data.height, [&](int y) {
    std::array<double, 6>& row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < data.width; ++x) {
      const std::size_t pixel = pixelIndex(data, x, y);
      const std::uint32_t good = frames - data.badCount[pixel];
      for (std::size_t channel = 0; good > 0 && channel < 3; ++channel) {
        row[channel] += meanOf(data.pixels[pixel][channel], good);
        row[channel + 3] += varianceOf(data.pixels[pixel][channel], good) / good;
      }
    }
  });
  std::array<double, 6> total{};
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += row[i];
  }
  double worst = 0.0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (total[channel + 3] == 0.0) continue;
    worst = std::max(worst, std::sqrt(total[channel + 3]) / std::abs(total[channel]));
  }
  return worst;
}

}  // namespace twintrace
