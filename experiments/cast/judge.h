#pragma once

#include <cstdint>

#include "common/cast/exact_hit.h"
#include "common/cast/families.h"
#include "common/trace/ray_caster.h"

namespace twintrace {

/// What is wrong with an engine's answer, the gravest first.
enum class Finding : std::uint8_t {
  agrees,
  notStarted,  ///< the first cast of a bounce missed, so there is nothing to judge
  notANumber,  ///< t or normal not finite, or no such primitive
  falseMiss,
  falseHit,
  wrongPrimitive,
  wrongDistance,  ///< off by more than kMostDistanceError: another surface, or none
  wrongNormal,    ///< off by more than kMostNormalError
  selfHit,        ///< a bounce hits the surface that it leaves
  leak            ///< a bounce misses the plate above its surface, or starts in it
};

/// Its name in tables and files, such as `false-miss`.
const char* findingName(Finding finding);

/// Units of tUnit: what a sound float algorithm leaves. At a box's edge the distance and the normal
/// may be those of either face.
inline constexpr double kMostDistanceError = 5.0;

/// Radians. Ten times what a unit normal of a sphere seen from 1e3 radii loses by rounding o + t d.
inline constexpr double kMostNormalError = 1e-3;

/// The judgement of one answer.
struct Judgement {
  Finding finding = Finding::agrees;
  bool counts = false;       ///< nothing excuses it: the ray is clean, or the surface closed
  bool comparable = false;   ///< both hit the same primitive, so that the rest says something
  double distanceError = 0;  ///< |t - exact t| / tUnit; 0 if both round to the same float
  std::uint32_t ulp = 0;     ///< of t
  bool normalOff = false;    ///< by more than kMostNormalError, whatever the finding
};

/// Judges a hit by the exact answer. A false miss of a closed surface is never excused.
Judgement judgeHit(const ExactHit& exact, const CastHit& answer, int primitiveCount, bool closed);

/// Judges the second hit of a bounce, `escape` or `plate`. A plate is met from the surface's side; met
/// from within, the bounce began in it.
/// @param first the ray that bounced
Judgement judgeBounce(const CastHit& answer, const CastRay& first, Expectation expectation);

/// Whether two answers are the same in each bit that counts.
bool sameAnswer(const CastHit& a, const CastHit& b);

}  // namespace twintrace
