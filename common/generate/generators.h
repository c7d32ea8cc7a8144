#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "common/generate/parts.h"

namespace twintrace {

/// Limit of design section 6, so that no size makes the program hang.
inline constexpr std::int64_t kMaxGenerated = 10'000'000;

/// A family of scenes of any complexity, each reproducible from its size and seed on every platform.
/// They fill about the cube from -1 to 1.
struct Generator {
  std::string_view name;  ///< in scene files
  std::string_view size;  ///< what the size means
  int smallest;
  int largest;  ///< size at which there are at most kMaxGenerated primitives
  std::int64_t (*primitives)(int size);
  /// Its objects: one, unless the generator is about several.
  std::vector<Parts> (*make)(int size, std::uint32_t seed);
};

const std::vector<Generator>& generators();

/// The generator of that name, or null.
const Generator* findGenerator(std::string_view name);

}  // namespace twintrace
