#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/film/exact_sum.h"
#include "common/film/image.h"
#include "common/film/sample_ranges.h"

namespace twintrace {

/// What determines the bits of a film besides its samples: version, scene hash, options, seed.
using FilmMetadata = std::map<std::string, std::string>;

/// A frame that was left out of a pixel because a channel was not finite or not below 2^30.
struct BadFrame {
  int x = 0;
  int y = 0;
  std::uint32_t firstSample = 0;
  std::array<float, 3> values{};  ///< the pixel's frame sums; every NaN is stored as one quiet NaN
};

/// Places of bad frames that a film keeps: the first ones by frame, then row, then column.
inline constexpr std::size_t kMaxBadPlaces = 16;

using PixelSums = std::array<ChannelSum, 3>;

/// The content of a film, as written to `.film` files.
struct FilmData {
  int width = 0;
  int height = 0;
  int passes = 0;  ///< samples per frame; 0 before the first frame
  FilmMetadata metadata;
  SampleRanges ranges;
  std::vector<PixelSums> pixels;        ///< sums of frame sums, row-major
  std::vector<std::uint32_t> badCount;  ///< frames left out, per pixel
  std::vector<BadFrame> badPlaces;      ///< sorted, at most kMaxBadPlaces
};

/// Exact sums of rendered frames: any split of the samples into films at frame boundaries, added
/// and merged in any order, gives the same bytes. 100 bytes per pixel; a film can be moved, not
/// copied.
class Film {
 public:
  /// An empty film. @throws UsageError unless both sides are positive and their product is at most
  /// kMaxPixels.
  Film(int width, int height, FilmMetadata metadata);

  /// A film with this content, which must be consistent (readFilm checks it).
  explicit Film(FilmData data);

  Film(Film&&) = default;
  Film& operator=(Film&&) = default;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// Adds one frame, over rows in parallel. The sums are added as they are and divided only in the
  /// queries, so that nothing is rounded here beyond the grid of exact_sum.h.
  /// @param sums width * height * 3 floats: each pixel's sum of `passes` samples.
  /// @param passes samples per frame, 1..kMaxPasses; the same in all frames of a film.
  /// @param firstSample index of the frame's first sample.
  /// @throws UsageError if the frame does not fit or overlaps samples that the film holds.
  void addFrame(std::span<const float> sums, int passes, std::uint32_t firstSample);

  /// Adds all frames of another film.
  /// @throws UsageError unless size, passes and metadata are equal and the samples disjoint.
  void merge(const Film& other);

  int width() const { return data_.width; }
  int height() const { return data_.height; }
  int passes() const { return data_.passes; }
  const FilmData& data() const { return data_; }

  /// Frames added so far, whether good or bad in a given pixel.
  std::uint32_t frameCount() const;

  /// Frames that were left out, over all pixels.
  std::uint64_t badFrameCount() const;

  /// Mean of the good samples; NaN in a pixel that has none.
  Image mean() const;

  /// Sample variance of frame means (sums / passes); 0 in a pixel with fewer than two good frames.
  /// The standard error of the mean is sqrt(variance / count).
  Image variance() const;

  /// Good frames per pixel.
  std::vector<float> count() const;

 private:
  void addRow(std::span<const float> sums, int y, std::uint32_t firstSample,
              std::vector<BadFrame>& badPlaces);
  void keepBadPlaces(std::span<const BadFrame> places);

  FilmData data_;
};

/// Pixels whose sums or counts differ between two films.
struct FilmDifference {
  std::int64_t differingPixels = 0;
  std::optional<PixelPosition> first;  ///< in row order
};

/// Compares two films' sums and counts bit by bit. @throws UsageError if the sizes differ.
FilmDifference compareFilms(const Film& a, const Film& b);

/// Standard error of the image mean over the image mean, the worst channel: what --target-error
/// bounds. Infinite with fewer than two frames or if the mean of a noisy channel is 0.
double relativeStandardError(const Film& film);

}  // namespace twintrace
