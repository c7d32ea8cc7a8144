#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "experiments/comparison.h"

namespace twintrace {

/// Finds out before the work whether a file can be written afterwards; leaves nothing behind.
/// @throws IoError if its directory is missing or can't be written, or if the name is a
/// directory's.
void checkWritable(const std::string& path);

/// Makes a directory with its parents and checks that it can be written. @throws IoError if not.
void prepareDirectory(const std::string& path);

/// Devices such as /dev/null may be named more than once.
/// @throws UsageError if two of the names are the same file's.
void checkDistinct(const std::vector<std::string>& paths);

/// @throws UsageError unless the name ends in one of the extensions, such as ".exr".
void checkExtension(const std::string& path, const std::vector<std::string>& extensions);

/// Several outputs, of which each is written even if others fail.
class OutputAttempts {
 public:
  template <class Write>
  void attempt(const Write& write) {
    try {
      write();
    } catch (const IoError& error) {
      failures_.emplace_back(error.what());
    }
  }

  /// @throws IoError with a line for each output that failed, if any did.
  void finish() const;

 private:
  std::vector<std::string> failures_;
};

/// Writes a text file as a whole or not at all. @throws IoError if it can't be written.
void writeText(const std::string& path, const std::string& text);

/// All that compare writes into its directory.
inline constexpr std::array kComparisonFiles = {"compare.json", "passport.json", "a.exr", "b.exr",
                                                "diff.exr",     "a.png",         "b.png", "sheet.png"};

/// Writes a.exr, b.exr, a.png, b.png, diff.exr (difference a - b with the maps ulp, z and
/// diverge.bounce) and
/// sheet.png, on which `header` stands above the pictures.
void writeComparisonPictures(OutputAttempts& outputs, const std::string& directory,
                             const Comparison& comparison, const std::vector<std::string>& header,
                             const std::string& nameA, const std::string& nameB);

}  // namespace twintrace
