#include "cpu/exact/arbiter.h"

#include <tbb/blocked_range.h>

#include <cmath>
#include <mutex>
#include <optional>

#include "common/base/finite.h"
#include "common/base/parallel_for.h"
#include "cpu/exact/clarity.h"
#include "cpu/exact/crossing.h"

namespace twintrace {
namespace {

constexpr std::size_t kGrain = 256;
constexpr float kLargest = std::numeric_limits<float>::max();

using exact::Crossing;
using exact::Dyadic;
using exact::FilterNumber;

float withoutDenormal(float x) {
  return std::fabs(x) < std::numeric_limits<float>::min() ? std::copysign(0.0f, x) : x;
}

glm::vec3 withoutDenormals(const glm::vec3& v) {
  return {withoutDenormal(v.x), withoutDenormal(v.y), withoutDenormal(v.z)};
}

CastRay withoutDenormals(const CastRay& ray) {
  return {withoutDenormals(ray.origin), withoutDenormals(ray.direction), withoutDenormal(ray.tmin),
          withoutDenormal(ray.tmax)};
}

/// Whether the ray can hit at all; false for NaN anywhere.
bool isCastable(const CastRay& ray) {
  return isFinite(ray.origin) && isFinite(ray.direction) && ray.direction != glm::vec3(0.0f) &&
         ray.tmin <= ray.tmax && ray.tmin <= kLargest && ray.tmax >= -kLargest;
}

/// A crossing of one primitive: as the filter has it, and exactly once somebody asked.
struct Candidate {
  int primitive = -1;
  Crossing<FilterNumber> filtered;
  std::optional<Crossing<Dyadic>> exact;
};

/// Decides one ray.
class Trial {
 public:
  Trial(std::span<const CasePrimitive> primitives, const CastRay& ray, ArbiterEffort& effort)
      : primitives_(primitives), ray_(ray), filterRay_(ray), effort_(effort) {}

  ExactHit decide() {
    bool tie = false;
    std::optional<Candidate> best;
    for (int i = 0; i < static_cast<int>(primitives_.size()); ++i) {
      std::optional<Candidate> candidate = cross(i);
      if (!candidate) continue;
      const int step = best ? order(*candidate, *best) : -1;
      if (step < 0) best = std::move(candidate);
      tie = step == 0 || (tie && step > 0);
    }
    ExactHit hit = best ? describe(*best) : ExactHit{};
    hit.clarity = tie ? Clarity::tie : exact::clarityOf(primitives_, ray_, hit);
    return hit;
  }

 private:
  std::optional<Candidate> cross(int primitive) {
    ++effort_.primitives;
    try {
      const auto crossing = exact::firstCrossing(primitives_[primitive], filterRay_);
      if (!crossing) return std::nullopt;
      return Candidate{primitive, *crossing, std::nullopt};
    } catch (const exact::Uncertain&) {
      ++effort_.exactPrimitives;
    }
    const auto crossing = crossExactly(primitive);
    if (!crossing) return std::nullopt;
    const Crossing<FilterNumber> filtered{exact::filtered(crossing->t), crossing->leaving,
                                          crossing->axis, crossing->side};
    return Candidate{primitive, filtered, crossing};
  }

  std::optional<Crossing<Dyadic>> crossExactly(int primitive) const {
    return exact::firstCrossing(primitives_[primitive], exact::Ray<Dyadic>(ray_));
  }

  const Crossing<Dyadic>& exactly(Candidate& candidate) const {
    if (!candidate.exact) candidate.exact = crossExactly(candidate.primitive);
    return *candidate.exact;
  }

  int order(Candidate& a, Candidate& b) {
    try {
      return compare(a.filtered.t, b.filtered.t);
    } catch (const exact::Uncertain&) {
      ++effort_.exactComparisons;
      return compare(exactly(a).t, exactly(b).t);
    }
  }

  double distance(Candidate& candidate) {
    if (const auto t = toDouble(candidate.filtered.t)) return *t;
    ++effort_.exactDistances;
    return toDouble(exactly(candidate).t);
  }

  ExactHit describe(Candidate& candidate) {
    ExactHit hit;
    const CasePrimitive& primitive = primitives_[candidate.primitive];
    const Crossing<FilterNumber>& crossing = candidate.filtered;
    hit.primitive = candidate.primitive;
    hit.leaving = crossing.leaving;
    hit.t = distance(candidate);
    hit.normal = exact::normalOf(primitive, ray_, hit, crossing.axis, crossing.side);
    hit.tUnit = exact::tUnitOf(primitive, ray_, hit);
    hit.facesBeside = exact::facesBeside(primitive, ray_, hit, crossing.axis);
    return hit;
  }

  std::span<const CasePrimitive> primitives_;
  CastRay ray_;
  exact::Ray<FilterNumber> filterRay_;
  ArbiterEffort& effort_;
};

}  // namespace

ArbiterEffort& ArbiterEffort::operator+=(const ArbiterEffort& other) {
  primitives += other.primitives;
  exactPrimitives += other.exactPrimitives;
  exactComparisons += other.exactComparisons;
  exactDistances += other.exactDistances;
  return *this;
}

std::vector<ExactHit> arbitrate(const CaseSet& cases, ArbiterEffort* effort) {
  std::vector<ExactHit> hits(cases.rays.size());
  std::mutex mutex;
  const tbb::blocked_range<std::size_t> all(0, hits.size(), kGrain);
  parallelFor(all, [&](const tbb::blocked_range<std::size_t>& part) {
    ArbiterEffort spent;
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      const CastRay ray = withoutDenormals(cases.rays[i].ray);
      if (!isCastable(ray)) continue;
      hits[i] = Trial(cases.primitivesOf(cases.rays[i]), ray, spent).decide();
    }
    const std::lock_guard lock(mutex);
    if (effort != nullptr) *effort += spent;
  });
  return hits;
}

}  // namespace twintrace
