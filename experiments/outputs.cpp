#include "experiments/outputs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "common/base/wording.h"
#include "common/film/atomic_file.h"
#include "common/film/sheet.h"

namespace twintrace {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failToWrite(const std::string& path, const std::string& reason) {
  throw IoError(path + ": cannot be written: " + reason);
}

std::vector<float> channelOf(const Image& image, std::size_t channel) {
  std::vector<float> values(image.pixelCount());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = image.rgb[3 * i + channel];
  return values;
}

ExrContent differenceContent(const Comparison& comparison) {
  ExrContent content;
  content.image = comparison.a.image;
  const std::vector<float>& b = comparison.b.image.rgb;
  for (std::size_t i = 0; i < b.size(); ++i) content.image.rgb[i] -= b[i];
  content.extra.push_back({"ulp", comparison.ulp});
  if (!comparison.divergeBounce.empty()) {
    content.extra.push_back({"diverge.bounce", comparison.divergeBounce});
  }
  if (!comparison.z.empty()) {
    content.extra.push_back({"z.R", channelOf(comparison.z, 0)});
    content.extra.push_back({"z.G", channelOf(comparison.z, 1)});
    content.extra.push_back({"z.B", channelOf(comparison.z, 2)});
  }
  return content;
}

}  // namespace

void checkWritable(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) failToWrite(path, "it is a directory");
  const fs::path directory = fs::path(path).parent_path();
  if (!directory.empty() && !fs::is_directory(directory, error)) {
    failToWrite(path, "there is no directory " + quote(directory.string()));
  }
  if (isDevice(path)) return;
  const AtomicFile trial(path);
  std::ofstream stream(trial.partialPath());
  stream << '\n';
  stream.close();
  if (!stream) failToWrite(path, "no file can be made in its directory");
}

void prepareDirectory(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) failToWrite(path, error.message());
  checkWritable((fs::path(path) / "compare.json").string());
}

void checkDistinct(const std::vector<std::string>& paths) {
  std::set<fs::path> files;
  for (const std::string& path : paths) {
    if (isDevice(path)) continue;
    std::error_code error;
    fs::path file = fs::weakly_canonical(fs::absolute(path), error);
    if (error) file = fs::path(path).lexically_normal();
    if (files.insert(file).second) continue;
    throw UsageError("found the output " + quote(path) + " twice, expected a file for each output");
  }
}

void checkExtension(const std::string& path, const std::vector<std::string>& extensions) {
  const std::string extension = fs::path(path).extension().string();
  if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) return;
  throw UsageError("found the output " + quote(path) + ", expected a name that ends in " +
                   oneOf(extensions));
}

void OutputAttempts::finish() const {
  if (failures_.empty()) return;
  std::string all;
  for (const std::string& failure : failures_) all += (all.empty() ? "" : "\n") + failure;
  throw IoError(all);
}

void writeText(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  std::ofstream stream(file.partialPath(), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) failToWrite(path, "the disk may be full");
  file.commit();
}

void writeComparisonPictures(OutputAttempts& outputs, const std::string& directory,
                             const Comparison& comparison, const std::vector<std::string>& header,
                             const std::string& nameA, const std::string& nameB) {
  const auto path = [&](const char* name) { return (fs::path(directory) / name).string(); };
  const ExrContent& a = comparison.a;
  const ExrContent& b = comparison.b;
  outputs.attempt([&] { writeExr(path("a.exr"), a); });
  outputs.attempt([&] { writeExr(path("b.exr"), b); });
  outputs.attempt([&] { writeExr(path("diff.exr"), differenceContent(comparison)); });
  outputs.attempt([&] { writePng(path("a.png"), a.image); });
  outputs.attempt([&] { writePng(path("b.png"), b.image); });
  outputs.attempt([&] {
    writeSheet(path("sheet.png"),
               {header, nameA, nameB, a.image, b.image, comparison.ulp, comparison.z});
  });
}

}  // namespace twintrace
