#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/hulls/hull_counts.h"
#include "common/scene/layout.h"
#include "common/trace/ray_caster.h"

namespace twintrace {

/// The closest hit of a ray: t is the ray's end and the primitive layout::kNoPrimitive for a miss.
struct HullHit {
  float t = 0.0f;
  std::int32_t primitive = layout::kNoPrimitive;

  friend bool operator==(const HullHit&, const HullHit&) = default;
};

/// Closest hits of many rays through one scene's hulls, to be measured and counted.
class HullCaster {
 public:
  virtual ~HullCaster() = default;

  /// @param rays with finite components, a finite end, and the largest component of the direction within
  /// [0.5, 2), as the intersectors ask
  /// @param hits as many as rays; overwritten
  /// @return seconds of wall time until all are found, without transfer of rays and results.
  /// @throws DeviceError if the device fails.
  virtual double cast(std::span<const CastRay> rays, std::span<HullHit> hits) = 0;

  /// What each ray costs, by the instrumented variant.
  virtual std::vector<HullCounts> count(std::span<const CastRay> rays) = 0;
};

}  // namespace twintrace
