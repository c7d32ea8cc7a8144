#pragma once

#include "common/hulls/hull_counts.h"

namespace twintrace {

/// A ray's closed interval and direction, whose largest component is within [0.5, 2) as the intersectors
/// ask, in plain numbers: the border between code built for different instruction sets.
template <class Number>
struct HullQueryRay {
  Number origin[3];
  Number direction[3];
  Number tmin;
  Number tmax;
};

/// A closest-hit query through hulls; with the robust intersector the same answer as testing all
/// primitives with the kernel's. A query answers rays in the numbers of the options that it was made for.
class HullQuery {
 public:
  virtual ~HullQuery() = default;

  /// @param t the distance of the hit; untouched on a miss
  /// @return the primitive, or layout::kNoPrimitive
  /// @throws std::logic_error for rays in other numbers
  virtual int closest(const HullQueryRay<float>& ray, float& t) const;
  virtual int closest(const HullQueryRay<double>& ray, double& t) const;

  /// What the same query costs, added to `counts`; nothing where it is not known.
  virtual void count(const HullQueryRay<float>& ray, HullCounts& counts) const;
  virtual void count(const HullQueryRay<double>& ray, HullCounts& counts) const;
};

}  // namespace twintrace
