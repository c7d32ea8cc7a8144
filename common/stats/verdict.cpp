#include "common/stats/verdict.h"

namespace twintrace {

std::string_view verdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::identical:
      return "identical";
    case Verdict::equivalent:
      return "equivalent";
    case Verdict::different:
      return "different";
    case Verdict::inconclusive:
      break;
  }
  return "inconclusive";
}

bool agrees(Verdict verdict) {
  return verdict == Verdict::identical || verdict == Verdict::equivalent;
}

Verdict pairedVerdict(std::int64_t differingPixels) {
  return differingPixels == 0 ? Verdict::identical : Verdict::different;
}

Verdict unpairedVerdict(const FamilyTest& family, const Equivalence& equivalence) {
  if (family.different) return Verdict::different;
  return equivalence.equivalent ? Verdict::equivalent : Verdict::inconclusive;
}

}  // namespace twintrace
