// Native maths: the driver's own functions against the strict twins. There is nothing to be equal
// to; what is shown is how far they are, and that they stay finite where strict maths does.

#include <bit>
#include <cmath>

#include "common/base/error.h"
#include "gpu/provider.h"
#include "tests/parity/parity.h"

namespace twintrace::parity {
namespace {

bool isFinite(std::span<const std::uint32_t> words) {
  for (const std::uint32_t word : words) {
    if (!std::isfinite(std::bit_cast<float>(word))) return false;
  }
  return true;
}

/// Ordinary inputs only: with special ones, native maths may do as it likes.
std::vector<std::uint32_t> ordinaryInputs(const ShaderFunction& function, const World& world) {
  auto inputs = drawInputs(function, world, kRandomCount, kSeed);
  const std::size_t words = kRandomCount * static_cast<std::size_t>(inputWords(function));
  inputs.erase(inputs.begin(), inputs.end() - static_cast<std::ptrdiff_t>(words));
  return inputs;
}

void checkNative(Context& context, const std::string& signature) {
  const ShaderFunction& function = functionOf(signature);
  World world = plainWorld();
  world.options.maths = Maths::native;
  const auto inputs = ordinaryInputs(function, world);
  const auto strict = runTwin(function, world, inputs);
  const auto native = runShader(context, ShaderLibrary(), function, world, inputs);
  const Difference difference = differenceOf(function, strict, native);
  WARN(signature << ": " << difference.differing << " of " << difference.records
                 << " records differ from strict, at most " << difference.maxUlp << " ulp");
  const auto stride = static_cast<std::size_t>(outputWords(function));
  for (std::size_t at = 0; at < strict.size(); at += stride) {
    if (!isFinite(std::span(strict).subspan(at, stride))) continue;
    if (isFinite(std::span(native).subspan(at, stride))) continue;
    FAIL_CHECK(describe(function, world, at / stride, inputs,
                        {{"strict twin", strict}, {"native shader", native}}));
    return;
  }
}

}  // namespace

TEST_CASE("native maths is finite where strict maths is", "[parity][gl][native]") {
  const auto context = createContext(Provider::osmesa, 0);
  for (const char* signature :
       {"sinCosTurns(float)", "arcCosine(float)", "reflect3(vec3, vec3)", "normalize3(vec3)",
        "tangentToWorld(vec3, vec3)", "polarDirection(float, float)",
        "samplePowerHemisphere(float, float, float)", "sampleCosineHemisphere(float, float)",
        "sampleCone(float, float, float)", "sampleDisk(float, float)",
        "sampleGgxNormal(float, float, float)"}) {
    checkNative(*context, signature);
  }
}

}  // namespace twintrace::parity
