#include "experiments/passport/passport.h"

#include <bit>
#include <cmath>

#include "experiments/passport/exact_builtin.h"
#include "gpu/buffers.h"
#include "gpu/builtins.h"
#include "gpu/compute_records.h"
#include "gpu/passport_cache.h"
#include "gpu/program.h"
#include "gpu/provider.h"

namespace twintrace {
namespace {

constexpr std::size_t kRecords = 8192;
constexpr std::uint32_t kSeed = 2;  // other inputs than those of the digest

/// Numbers come as bits through uniforms, so that no compiler knows them.
constexpr const char* kFragmentMain = R"glsl(
uniform uint denormalBits;  // 2^-127
uniform uint smallBits;     // 2^-70
layout(location = 0) out vec4 answer;

void main() {
  precise float raised = uintBitsToFloat(denormalBits) * 18446744073709551616.0;
  precise float small = uintBitsToFloat(smallBits);
  precise float lowered = small * small;
  answer = vec4(raised == 0.0 ? 0.0 : 1.0, floatBitsToUint(lowered) == 0u ? 0.0 : 1.0, 0.0, 0.0);
}
)glsl";

std::vector<PassportFact> fragmentFacts(Context& context) {
  ShaderRequest request;
  request.main = "denormals.glsl";
  request.virtualFiles[request.main] = kFragmentMain;
  Program program(context, Stage::fragment, assembleShader(ShaderLibrary(), request));
  program.set("denormalBits", std::uint32_t{0x00400000u});
  program.set("smallBits", std::uint32_t{0x1c800000u});
  FloatTarget target(context, 1, 1);
  target.draw(program);
  float answer[4];
  target.read(answer);
  const auto value = [](float kept) { return kept == 0.0f ? "flushed to zero" : "kept"; };
  return {{"denormal inputs, fragment", value(answer[0]), answer[0] != 0.0f},
          {"denormal results, fragment", value(answer[1]), answer[1] != 0.0f}};
}

double ulpOf(double x) {
  const int exponent = x == 0 ? -126 : std::max(std::ilogb(x), -126);
  return std::ldexp(1.0, exponent - 23);
}

BuiltinAccuracy accuracy(const Builtin& builtin, std::span<const std::uint32_t> inputs,
                         std::span<const std::uint32_t> found) {
  const ExactBuiltin& exact = exactBuiltin(builtin.name);
  BuiltinAccuracy result;
  result.name = builtin.name;
  result.allowance = exact.allowance;
  result.hasBound = exact.allowedUlp != nullptr;
  result.withinBound = result.hasBound;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::uint32_t* words = &inputs[kRecordWords * i];
    const auto a = std::bit_cast<float>(words[0]);
    const auto b = std::bit_cast<float>(words[1]);
    const auto c = std::bit_cast<float>(words[2]);
    const double expected = exact.value(a, b, c);
    const double error = std::fabs(double{std::bit_cast<float>(found[i])} - expected);
    const double ulp = error / ulpOf(expected);
    result.maxAbsolute = std::fmax(result.maxAbsolute, error);
    // Written so that a NaN counts as beyond any bound.
    if (result.hasBound && !(ulp <= exact.allowedUlp(a, b, c))) result.withinBound = false;
    if (i > 0 && ulp <= result.maxUlp) continue;
    result.maxUlp = ulp;
    std::copy_n(words, kRecordWords, result.inputs);
    result.found = found[i];
    result.exact = expected;
  }
  return result;
}

std::vector<BuiltinAccuracy> measureBuiltins(Context& context) {
  RecordProgram program;
  program.ownInputs = true;
  std::vector<std::uint32_t> inputs;
  for (const Builtin& builtin : builtins()) {
    program.expressions.emplace_back(builtin.expression);
    const auto some = builtinInputs(builtin, kRecords, kSeed);
    inputs.insert(inputs.end(), some.begin(), some.end());
  }
  program.precise = false;
  const auto found = runRecords(context, recordSource(ShaderLibrary(), program), program, inputs);
  std::vector<BuiltinAccuracy> all;
  for (std::size_t i = 0; i < builtins().size(); ++i) {
    all.push_back(
        accuracy(builtins()[i],
                 std::span(inputs).subspan(i * kRecords * kRecordWords, kRecords * kRecordWords),
                 std::span(found).subspan(i * kRecords, kRecords)));
  }
  return all;
}

}  // namespace

Passport measureFullPassport(const RenderOptions& options) {
  const auto context = createContext(options.provider, options.threads);
  const Context::Current current = context->use();
  Passport passport;
  passport.source = context->source();
  passport.device = measurePassport(*context, shaderLibrary(options));
  passport.fragment = fragmentFacts(*context);
  passport.builtins = measureBuiltins(*context);
  return passport;
}

DevicePassport devicePassport(const RenderOptions& options) {
  const auto context = createContext(options.provider, options.threads);
  const Context::Current current = context->use();
  return passportOf(*context, shaderLibrary(options));
}

}  // namespace twintrace
