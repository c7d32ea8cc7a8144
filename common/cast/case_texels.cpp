#include "common/cast/case_texels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "common/base/error.h"
#include "common/scene/layout.h"

namespace twintrace {
namespace {

static_assert(static_cast<int>(CaseKind::sphere) == layout::kCaseSphere &&
              static_cast<int>(CaseKind::box) == layout::kCaseBox &&
              static_cast<int>(CaseKind::orientedBox) == layout::kCaseOrientedBox &&
              static_cast<int>(CaseKind::plane) == layout::kCasePlane &&
              static_cast<int>(CaseKind::triangle) == layout::kCaseTriangle);

/// Whether a value is a coordinate or a length, and not part of a direction.
bool isLength(CaseKind kind, int value) {
  if (kind == CaseKind::plane) return value >= 3;
  if (kind == CaseKind::orientedBox) return value < 3 || value >= 12;
  return true;
}

float reachOf(std::span<const CasePrimitive> primitives) {
  float reach = 0.0f;
  for (const CasePrimitive& primitive : primitives) {
    for (int i = 0; i < valueCount(primitive.kind); ++i) {
      if (isLength(primitive.kind, i)) reach = std::max(reach, std::fabs(primitive.values[i]));
    }
  }
  return reach;
}

void addTexels(std::vector<glm::uvec4>& texels, const CasePrimitive& primitive) {
  const auto word = [&](int i) { return std::bit_cast<std::uint32_t>(primitive.values[i]); };
  const std::uint32_t fourth[] = {static_cast<std::uint32_t>(primitive.kind), word(12), word(13),
                                  word(14)};
  for (int i = 0; i < layout::kCaseTexels; ++i) {
    texels.emplace_back(word(3 * i), word(3 * i + 1), word(3 * i + 2), fourth[i]);
  }
}

}  // namespace

CaseTexels packCases(const CaseSet& cases) {
  constexpr std::size_t limit = std::numeric_limits<std::int32_t>::max() / layout::kCaseTexels;
  if (cases.primitives.size() > limit) {
    throw UsageError("found " + std::to_string(cases.primitives.size()) +
                     " primitives in cases, expected at most " + std::to_string(limit));
  }
  CaseTexels packed;
  packed.texels.reserve(cases.primitives.size() * layout::kCaseTexels);
  for (const CasePrimitive& primitive : cases.primitives) addTexels(packed.texels, primitive);
  packed.scenes.reserve(cases.scenes.size());
  for (const CaseScene& scene : cases.scenes) {
    packed.scenes.push_back(
        {static_cast<std::int32_t>(scene.first) * layout::kCaseTexels,
         static_cast<std::int32_t>(scene.count),
         reachOf(std::span(cases.primitives).subspan(scene.first, scene.count))});
  }
  return packed;
}

}  // namespace twintrace
