#include "experiments/probe/trial.h"

#include <array>
#include <bit>
#include <cmath>

#include "common/base/error.h"
#include "experiments/probe/inputs.h"
#include "experiments/probe/report.h"
#include "gpu/provider.h"
#include "tests/catch.h"

namespace twintrace::probe {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::Message;

constexpr TrialSettings kFew = {2000, 1, Maths::strict};

const ShaderFunction& named(const std::string& signature) {
  const auto found = chooseFunctions({signature});
  REQUIRE(found.size() == 1);
  return *found.front();
}

/// The library with the first `from` in a shader replaced.
ShaderLibrary damaged(const std::string& file, const std::string& from, const std::string& to) {
  std::string text = ShaderLibrary().find(file)->text;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  return ShaderLibrary({}, {{file, {text, ""}}});
}

}  // namespace

TEST_CASE("chooseFunctions takes names and signatures", "[probe]") {
  CHECK(chooseFunctions({}).size() == shaderFunctions().size());
  CHECK(chooseFunctions({"dot3"}).size() == 1);
  CHECK(chooseFunctions({"divide"}).size() == 2);
  CHECK(chooseFunctions({"divide(vec3,float)"}).size() == 1);
  CHECK(chooseFunctions({"dot3", "divide"}).size() == 3);
}

TEST_CASE("chooseFunctions suggests the nearest name", "[probe]") {
  CHECK_THROWS_AS(chooseFunctions({"dott3"}), UsageError);
  CHECK_THROWS_WITH(chooseFunctions({"dott3"}), Contains("did you mean 'dot3'?"));
}

TEST_CASE("double twins answer near the float twins", "[probe]") {
  const World world = plainWorld();
  // Absolute bounds that math.glsl states for each over the drawn range.
  const std::pair<const char*, double> bounds[] = {{"sinCosTurns(float)", 1.2e-7},
                                                   {"arcCosine(float)", 6e-7}};
  for (const auto& [signature, bound] : bounds) {
    const ShaderFunction& function = named(signature);
    auto inputs = drawInputs(function, world, 2000, 1);
    inputs.erase(inputs.begin(), inputs.begin() + static_cast<std::ptrdiff_t>(kSpecialCount));
    const auto single = runTwin(function, world, inputs);
    const auto wide = runTwin64(function, world, inputs);
    REQUIRE(single.size() == wide.size());
    double worst = 0;
    for (std::size_t i = 0; i < wide.size(); ++i) {
      worst = std::max(worst, std::abs(wide[i] - std::bit_cast<float>(single[i])));
    }
    INFO(signature << ": " << worst);
    CHECK(worst < bound);
    CHECK(worst > 0.0);
  }
}

TEST_CASE("double twins answer integers and truth values exactly", "[probe]") {
  const World world = plainWorld();
  for (const char* signature : {"pcgHash(uint)", "select(bool, int, int)", "anyLane(bool)"}) {
    const ShaderFunction& function = named(signature);
    const auto inputs = drawInputs(function, world, 200, 1);
    const auto single = runTwin(function, world, inputs);
    const auto wide = runTwin64(function, world, inputs);
    const Kind kind = outputKinds(function).front();
    for (std::size_t i = 0; i < wide.size(); ++i) REQUIRE(wordOf(kind, wide[i]) == single[i]);
  }
}

TEST_CASE("inputs around a record move its floats alone", "[probe]") {
  const ShaderFunction& function = named("sinCosReduced(float, int)");
  const std::uint32_t record[] = {std::bit_cast<std::uint32_t>(0.5f), 3u};
  const auto near = drawNear(function, record, 200, 1);
  REQUIRE(near.size() == 400);
  bool moved = false;
  for (std::size_t i = 0; i < 200; ++i) {
    CHECK(wordDistance(Kind::real, record[0], near[2 * i]) <= 64);
    CHECK(near[2 * i + 1] == 3u);
    moved = moved || near[2 * i] != record[0];
  }
  CHECK(moved);
}

TEST_CASE("inputs around a ray keep its inverse", "[probe]") {
  const ShaderFunction& function = named("pointAt(Ray, float)");
  const World world = plainWorld();
  const auto drawn = drawInputs(function, world, 1, 1);
  const auto words = static_cast<std::size_t>(inputWords(function));
  const std::span<const std::uint32_t> last = std::span(drawn).last(words);
  const auto near = drawNear(function, last, 20, 1);
  std::size_t inverse = 0;
  for (const Slot& slot : function.inputs) {
    if (std::string(slot.path).ends_with(".inverse")) break;
    inverse += static_cast<std::size_t>(slot.size);
  }
  for (std::size_t at = 0; at < near.size(); at += words) {
    for (std::size_t i = 0; i < 3; ++i) {
      const float direction = std::bit_cast<float>(near[at + inverse - 3 + i]);
      CHECK(std::bit_cast<float>(near[at + inverse + i]) == 1.0f / direction);
    }
  }
}

TEST_CASE("boundaries are for functions of one unrestricted float", "[probe]") {
  CHECK_FALSE(boundaryInputs(named("sine(float)")).empty());
  CHECK(boundaryInputs(named("sinCosTurns(float)")).empty());
  CHECK(boundaryInputs(named("divide(float, float)")).empty());
  CHECK(boundaryInputs(named("pcgHash(uint)")).empty());
}

TEST_CASE("tryFunction finds sound functions identical", "[probe][gl]") {
  const auto context = createContext(Provider::osmesa, 0);
  const FunctionTrial trial =
      tryFunction(*context, ShaderLibrary(), named("sine(float)"), kFew);
  CHECK(trial.verdict == Verdict::identical);
  CHECK(trial.differing == 0);
  CHECK(trial.records > kSpecialCount + kFew.samples + boundaryInputs(*trial.function).size());
  CHECK(trial.toTwin.ulps.total() == trial.records);
  CHECK(trial.toTwin.ulps.count(0) == trial.records);
  REQUIRE(trial.toTwin64);
  CHECK(trial.toTwin64->ulps.total() == trial.records);
  REQUIRE(trial.toReference);
  CHECK(trial.toReference->ulps.total() < trial.records);
  CHECK(trial.toReference->ulps.count(1) > 0);
}

TEST_CASE("tryFunction finds a planted fault and names the function", "[probe][gl]") {
  const auto context = createContext(Provider::osmesa, 0);
  const ShaderLibrary library =
      damaged("math.glsl", "(a.x * b.x + a.y * b.y) + a.z * b.z",
              "a.x * b.x + (a.y * b.y + a.z * b.z)");
  const FunctionTrial trial = tryFunction(*context, library, named("dot3(vec3, vec3)"), kFew);
  CHECK(trial.verdict == Verdict::differs);
  CHECK(trial.differing > 0);
  CHECK(trial.differing + trial.toTwin.ulps.count(0) == trial.records);
  REQUIRE(trial.toTwin.worst);
  CHECK(differ(*trial.function, trial.toTwin.worst->gpu, trial.toTwin.worst->twin));
  CHECK_THAT(trialsText({trial}), Contains("worst record of dot3(vec3, vec3) of shaders/math.glsl"));
}

TEST_CASE("tryFunction leaves out what native maths does not have", "[probe][gl]") {
  const auto context = createContext(Provider::osmesa, 0);
  const TrialSettings native = {2000, 1, Maths::native};
  CHECK(tryFunction(*context, ShaderLibrary(), named("sinCosReduced(float, int)"), native).verdict ==
        Verdict::notInNative);
  CHECK(tryFunction(*context, ShaderLibrary(), named("sine(float)"), native).verdict ==
        Verdict::differs);
}

TEST_CASE("parseInputs reads numbers and bits", "[probe]") {
  const std::vector<std::uint32_t> half = {0x3f000000u, 0xffffffffu};
  const ShaderFunction& function = named("sinCosReduced(float, int)");
  for (const char* text : {"0.5,-1", "0x1p-1,-1", "0x3f000000,0xffffffff"}) {
    INFO(text);
    CHECK(parseInputs(function, text) == half);
  }
  const std::vector<std::uint32_t> truth = {1u};
  CHECK(parseInputs(named("anyLane(bool)"), "true") == truth);
}

TEST_CASE("parseInputs names what is missing or wrong", "[probe]") {
  const ShaderFunction& function = named("divide(vec3, float)");
  CHECK_THROWS_WITH(parseInputs(function, "1,2,3"),
                    Contains("found 3 values, expected the 4 of divide(vec3, float): a.x,a.y,a.z,b"));
  CHECK_THROWS_WITH(parseInputs(function, "1,2,3,"), Contains("b: found ''"));
  CHECK_THROWS_WITH(parseInputs(function, "1,two,3,4"), Contains("a.y: found 'two'"));
  CHECK_THROWS_WITH(parseInputs(function, "1,2,3,0x1ffffffff"), Contains("b: found"));
}

TEST_CASE("checkInputs keeps functions from reading beyond the world", "[probe]") {
  const World world = plainWorld();
  const ShaderFunction& function = named("fetchSphere(int)");
  const auto check = [&](std::uint32_t index) { checkInputs(function, world, std::array{index}); };
  CHECK_NOTHROW(check(0u));
  CHECK_THROWS_WITH(check(1000000000u), Contains("index: found 1000000000, expected 0 to 1"));
  CHECK_THROWS_WITH(check(0xffffffffu), Contains("index: found -1"));
  CHECK_NOTHROW(checkInputs(named("powerOfTwo(int)"), world, std::array{0x7fffffffu}));
  std::vector<std::uint32_t> ray(12, 0u);
  const auto surface = [&](int primitive) {
    std::vector<std::uint32_t> words = ray;
    words.push_back(static_cast<std::uint32_t>(primitive));
    checkInputs(named("surfaceAt(Ray, Hit)"), world, words);
  };
  CHECK_NOTHROW(surface(0));
  CHECK_NOTHROW(surface(layout::kNoPrimitive));
  CHECK_THROWS_WITH(surface(-100000000), Contains("hit.primitive: found -100000000"));
}

TEST_CASE("replay gives all answers to one record", "[probe][gl]") {
  const auto context = createContext(Provider::osmesa, 0);
  const ShaderFunction& function = named("divide(float, float)");
  const Record record =
      replay(*context, ShaderLibrary(), function, plainWorld(), parseInputs(function, "1,3"));
  CHECK(std::bit_cast<float>(record.gpu[0]) == 1.0f / 3.0f);
  CHECK(record.gpu == record.twin);
  CHECK(record.twin64[0] == 1.0 / 3.0);
  CHECK(record.reference[0] == 1.0f / 3.0f);
}

}  // namespace twintrace::probe
