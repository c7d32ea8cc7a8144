#include "experiments/explain/plain_sample.h"

#include "experiments/explain/explain_text.h"
#include "tests/catch.h"

namespace twintrace::test {
namespace {

using Radiance = std::array<float, 3>;

constexpr Radiance kOne = {1, 2, 3};
constexpr Radiance kOther = {1, 2, 4};

/// The notes for what two plain programs and their traced copies give.
std::string notes(const PlainSample& plain, const Radiance& tracedA, const Radiance& tracedB,
                  bool native = true) {
  SampleExplanation explanation;
  explanation.traceA.radiance = tracedA;
  explanation.traceB.radiance = tracedB;
  explanation.sameRadiance = tracedA == tracedB;
  std::string text;
  for (const std::string& note : traceNotes(plain, explanation, native)) text += note + "\n";
  return text;
}

}  // namespace

TEST_CASE("traceNotes says where the traced program no longer shows the difference", "[explain]") {
  const std::string text = notes({kOne, kOther}, kOne, kOne);
  CHECK_THAT(text, Catch::Contains("the traced ones no longer do"));
  CHECK_THAT(text, Catch::Contains("b: the traced program does not show what the plain one "
                                   "renders: 0x1p+0 0x1p+1 0x1p+2, as native maths may"));
}

TEST_CASE("traceNotes says where only the traced programs differ", "[explain]") {
  const std::string text = notes({kOne, kOne}, kOther, kOne, false);
  CHECK_THAT(text, Catch::Contains("the traced programs differ in this sample, the plain ones do"));
  CHECK_THAT(text, !Catch::Contains("native"));
}

TEST_CASE("traceNotes vouches for a trace in native maths", "[explain]") {
  CHECK(notes({kOne, kOther}, kOne, kOther) ==
        "native maths: the traced programs show what the plain ones render\n");
}

TEST_CASE("traceNotes is silent in strict maths where all is well", "[explain]") {
  CHECK(notes({kOne, kOther}, kOne, kOther, false).empty());
}

TEST_CASE("an explanation calls no sample identical that is rendered otherwise", "[explain]") {
  const FlatScene scene;
  ExplainedSample about;
  SampleExplanation explanation;
  CHECK(explanationJson(scene, about, explanation)["identical"] == true);
  about.renderedAlike = false;
  CHECK(explanationJson(scene, about, explanation)["identical"] == false);
  CHECK_THAT(explanationText(scene, about, explanation),
             Catch::Contains("different: the sample is the same only on the traced programs"));
}

}  // namespace twintrace::test
