#include "experiments/compare_files.h"

#include <fmt/format.h>

#include "common/base/error.h"

namespace twintrace {
namespace {

bool hasMetadata(const ExrContent& content) {
  return content.metadata.contains("scene_hash");
}

/// Whether both files have an entry and it is the same.
bool shareEntry(const ExrContent& a, const ExrContent& b, const char* key) {
  const auto inA = a.metadata.find(key);
  const auto inB = b.metadata.find(key);
  return inA != a.metadata.end() && inB != b.metadata.end() && inA->second == inB->second;
}

/// Whether two files of ours drew from the same random numbers for the same scene.
bool shareSeed(const ExrContent& a, const ExrContent& b) {
  return shareEntry(a, b, "scene_hash") && shareEntry(a, b, "seed") && shareEntry(a, b, "noise");
}

bool drewSameSamples(const ExrContent& a, const ExrContent& b) {
  return shareSeed(a, b) && shareEntry(a, b, "samples");
}

void requireSameSize(const PictureFiles& files, const Image& a, const Image& b) {
  if (a.sameSize(b)) return;
  throw UsageError(
      fmt::format("found pictures of {}x{} ({}) and {}x{} ({}) pixels, expected equal sizes",
                  a.width, a.height, files.a, b.width, b.height, files.b));
}

ImageEstimate estimateOf(const ExrContent& content, const std::string& path,
                         const std::string& errorPath) {
  if (!errorPath.empty()) return estimateFrom(content.image, readLinearImage(errorPath));
  return estimateFrom(content, path);
}

std::string noErrorsNote(const std::string& path, const char* option) {
  return fmt::format(
      "{}: no errors are known, so only equal bits could be judged: there are no Variance.R, "
      "Variance.G, Variance.B and count channels, nor a picture of standard errors with {}",
      path, option);
}

bool hasErrors(const ExrContent& content, const std::string& errorPath) {
  return !errorPath.empty() || (!content.variance.empty() && !content.count.empty());
}

void judgeUnpaired(Comparison& comparison, const ImageEstimate& a, const ImageEstimate& b,
                   const ComparisonSettings& settings) {
  comparison.family = familyTest(a, b, settings.alpha);
  comparison.equivalence =
      equivalenceTest(channelMeans(a), channelMeans(b), settings.bound, settings.alpha);
  comparison.verdict = unpairedVerdict(comparison.family, comparison.equivalence);
}

}  // namespace

Comparison compareFiles(const PictureFiles& files, const ComparisonSettings& settings) {
  checkSettings(settings);
  ExrContent contentA = readExr(files.a);
  ExrContent contentB = readExr(files.b);
  requireSameSize(files, contentA.image, contentB.image);
  Comparison result = comparePictures(std::move(contentA), std::move(contentB));
  result.family.alpha = settings.alpha;
  result.equivalence.bound = settings.bound;

  const bool errorsKnownA = hasErrors(result.a, files.standardErrorA);
  const bool errorsKnownB = hasErrors(result.b, files.standardErrorB);
  const bool errorsKnown = errorsKnownA && errorsKnownB;
  const bool unknownOrigin = !hasMetadata(result.a) || !hasMetadata(result.b);
  const bool equalBits = result.differingPixels == 0;
  result.paired =
      drewSameSamples(result.a, result.b) || (equalBits && (unknownOrigin || !errorsKnown));
  if (result.paired) result.verdict = pairedVerdict(result.differingPixels);
  if (!result.paired && !errorsKnownA) {
    result.notes.push_back(noErrorsNote(files.a, "--stderr-a"));
  }
  if (!result.paired && !errorsKnownB) {
    result.notes.push_back(noErrorsNote(files.b, "--stderr-b"));
  }
  if (!errorsKnown) return result;

  const ImageEstimate a = estimateOf(result.a, files.a, files.standardErrorA);
  const ImageEstimate b = estimateOf(result.b, files.b, files.standardErrorB);
  addZMap(result, a, b);
  if (result.paired) return result;
  judgeUnpaired(result, a, b, settings);
  if (shareSeed(result.a, result.b)) result.notes.emplace_back(kSharedSeedNote);
  return result;
}

}  // namespace twintrace
