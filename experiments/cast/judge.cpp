#include "experiments/cast/judge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/base/finite.h"
#include "common/base/float_bits.h"
#include "common/cast/case_set.h"

namespace twintrace {
namespace {

bool isSound(const CastHit& answer, int primitiveCount) {
  if (answer.primitive < -1 || answer.primitive >= primitiveCount) return false;
  return !answer.valid() || (std::isfinite(answer.t) && isFinite(answer.normal));
}

/// The angle between the normals by its tangent, which loses no digits where it is small.
bool isNormalOff(const glm::dvec3& exact, const glm::vec3& answer) {
  const glm::dvec3 n(answer);
  const double across = glm::length(glm::cross(exact, n));
  const double along = glm::dot(exact, n);
  return !(across <= kMostNormalError * along);
}

/// Which face of a box was hit is not asked where two meet.
bool isNormalOff(const ExactHit& exact, const glm::vec3& answer) {
  if (!isNormalOff(exact.normal, answer)) return false;
  return std::none_of(exact.facesBeside.begin(), exact.facesBeside.end(),
                      [&](const FaceBeside& face) { return !isNormalOff(face.normal, answer); });
}

/// Beside an edge the other face's distance is as good, with its own rounding.
bool isDistanceOff(const ExactHit& exact, float t, double error) {
  if (error <= kMostDistanceError) return false;
  return std::none_of(exact.facesBeside.begin(), exact.facesBeside.end(),
                      [&](const FaceBeside& face) {
                        return std::fabs(double(t) - face.t) <= kMostDistanceError * face.tUnit;
                      });
}

/// A distance as an answer can have it: denormal numbers count as zero.
float asDistance(double t) {
  const auto rounded = static_cast<float>(t);
  return std::fabs(rounded) < std::numeric_limits<float>::min() ? 0.0f : rounded;
}

Finding judgePrimitive(const ExactHit& exact, const CastHit& answer) {
  if (exact.primitive < 0) return answer.valid() ? Finding::falseHit : Finding::agrees;
  if (!answer.valid()) return Finding::falseMiss;
  return answer.primitive == exact.primitive ? Finding::agrees : Finding::wrongPrimitive;
}

void compareSurfaces(Judgement& judgement, const ExactHit& exact, const CastHit& answer) {
  judgement.comparable = true;
  judgement.ulp = ulpDistance(asDistance(answer.t), asDistance(exact.t));
  const double difference = std::fabs(double(answer.t) - exact.t);
  // A t that is exact to rounding has no error, even where the unit vanishes.
  judgement.distanceError = judgement.ulp == 0 ? 0.0 : difference / exact.tUnit;
  judgement.normalOff = isNormalOff(exact, answer.normal);
  if (isDistanceOff(exact, answer.t, judgement.distanceError)) {
    judgement.finding = Finding::wrongDistance;
  } else if (judgement.normalOff) {
    judgement.finding = Finding::wrongNormal;
  }
}

}  // namespace

const char* findingName(Finding finding) {
  switch (finding) {
    case Finding::agrees:
      return "agrees";
    case Finding::notStarted:
      return "not-started";
    case Finding::notANumber:
      return "not-a-number";
    case Finding::falseMiss:
      return "false-miss";
    case Finding::falseHit:
      return "false-hit";
    case Finding::wrongPrimitive:
      return "wrong-primitive";
    case Finding::wrongDistance:
      return "wrong-distance";
    case Finding::wrongNormal:
      return "wrong-normal";
    case Finding::selfHit:
      return "self-hit";
    case Finding::leak:
      return "leak";
  }
  return "";
}

Judgement judgeHit(const ExactHit& exact, const CastHit& answer, int primitiveCount, bool closed) {
  Judgement judgement;
  judgement.counts = exact.clarity == Clarity::clean;
  if (!isSound(answer, primitiveCount)) {
    judgement.finding = Finding::notANumber;
    judgement.counts = true;
    return judgement;
  }
  judgement.finding = judgePrimitive(exact, answer);
  if (closed && judgement.finding == Finding::falseMiss) judgement.counts = true;
  if (exact.primitive >= 0 && answer.primitive == exact.primitive) {
    compareSurfaces(judgement, exact, answer);
  }
  return judgement;
}

Judgement judgeBounce(const CastHit& answer, const CastRay& first, Expectation expectation) {
  Judgement judgement;
  judgement.counts = true;
  if (answer.primitive == kBounceNotStarted) {
    judgement.finding = Finding::notStarted;
  } else if (!isSound(answer, 2)) {
    judgement.finding = Finding::notANumber;
  } else if (answer.primitive == 0) {
    judgement.finding = Finding::selfHit;
  } else if (expectation == Expectation::plate) {
    const bool below = answer.primitive > 0 && glm::dot(answer.normal, first.direction) > 0.0f;
    if (!below) judgement.finding = Finding::leak;
  }
  return judgement;
}

bool sameAnswer(const CastHit& a, const CastHit& b) {
  if (a.primitive != b.primitive) return false;
  if (!a.valid()) return true;
  return sameBits(a.t, b.t) && sameBits(a.normal.x, b.normal.x) &&
         sameBits(a.normal.y, b.normal.y) && sameBits(a.normal.z, b.normal.z);
}

}  // namespace twintrace
