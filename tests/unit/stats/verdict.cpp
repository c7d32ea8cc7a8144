#include "common/stats/verdict.h"

#include "tests/catch.h"

using namespace twintrace;

namespace {

FamilyTest family(bool different) {
  FamilyTest test;
  test.different = different;
  return test;
}

Equivalence equivalence(bool equivalent) {
  Equivalence test;
  test.equivalent = equivalent;
  return test;
}

}  // namespace

TEST_CASE("pairedVerdict is decided by the bits", "[stats]") {
  CHECK(pairedVerdict(0) == Verdict::identical);
  CHECK(pairedVerdict(1) == Verdict::different);
}

TEST_CASE("unpairedVerdict asks the family test first", "[stats]") {
  CHECK(unpairedVerdict(family(true), equivalence(true)) == Verdict::different);
  CHECK(unpairedVerdict(family(true), equivalence(false)) == Verdict::different);
  CHECK(unpairedVerdict(family(false), equivalence(true)) == Verdict::equivalent);
  CHECK(unpairedVerdict(family(false), equivalence(false)) == Verdict::inconclusive);
}

TEST_CASE("verdicts have names and agree or not", "[stats]") {
  CHECK(verdictName(Verdict::identical) == "identical");
  CHECK(verdictName(Verdict::equivalent) == "equivalent");
  CHECK(verdictName(Verdict::different) == "different");
  CHECK(verdictName(Verdict::inconclusive) == "inconclusive");
  CHECK(agrees(Verdict::identical));
  CHECK(agrees(Verdict::equivalent));
  CHECK_FALSE(agrees(Verdict::different));
  CHECK_FALSE(agrees(Verdict::inconclusive));
}
