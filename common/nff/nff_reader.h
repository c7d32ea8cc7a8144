#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"
#include "common/nff/nff_file.h"
#include "common/nff/nff_surfaces.h"
#include "common/nff/nff_tokens.h"

namespace twintrace {

/// Reads one NFF file. An entity is its letter and the numbers after it, on as many lines as it
/// takes; after a fault, reading goes on at the next line that begins with an entity's letter.
class NffReader {
 public:
  NffReader(std::string_view text, const std::string& path) : tokens_(text), path_(path) {}

  /// @throws FileError with what is wrong
  NffFile read();

 private:
  void readEntity();
  void readView(const NffToken& at);
  bool readViewLine(const NffToken& word, NffView& view, std::vector<std::string>& missing);
  void checkView(const NffToken& at, const NffView& view);
  void readBackground();
  void readLight();
  void readFill();
  void readSphere();
  void readCone();
  void readPolygon(bool hasNormals);
  void recover();

  /// The next numbers; where one is missing, nothing and a fault.
  /// @param expected a text, or a function that makes it once it is needed
  template <std::size_t kCount, class Expected>
  std::optional<std::array<double, kCount>> numbers(const Expected& expected);
  template <class Expected>
  std::optional<double> number(const Expected& expected);
  std::optional<int> integer(int least, int most, std::string_view expected);
  std::optional<glm::vec3> color(std::string_view expected);

  void fault(const NffToken& at, std::string_view found, std::string_view expected);
  void faultHere(std::string_view expected);
  void checkFill(const NffToken& at);
  void throwFaults();

  NffTokens tokens_;
  std::string path_;
  NffFile file_;
  NffSurfaces surfaces_;
  std::vector<glm::vec3> corners_;
  std::vector<glm::vec3> normals_;
  std::vector<Diagnostic> faults_;
  std::size_t faultCount_ = 0;
  bool broken_ = false;  ///< the entity under way ends in a fault
};

}  // namespace twintrace
