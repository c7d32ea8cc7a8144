#pragma once

namespace twintrace {

/// A closest-hit query by an acceleration structure outside the kernel; the same answer as testing
/// all primitives with the kernel's intersectors.
class HullQuery {
 public:
  virtual ~HullQuery() = default;
  /// @param t the distance of the hit; untouched on a miss
  /// @return the primitive, or layout::kNoPrimitive
  virtual int closest(const float origin[3], const float direction[3], float tmin, float tmax,
                      float& t) const = 0;
};

}  // namespace twintrace
