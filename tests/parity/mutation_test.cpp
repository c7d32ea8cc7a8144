// Evidence that the parity tests can fail: each case damages one shader function and sees its parity
// lost. Which expressions Mesa rewrites without `precise` is measured, so a case that no longer
// differs after an upgrade tells that the rewriting has changed.

#include "common/base/error.h"
#include "gpu/embedded_shaders.h"
#include "gpu/provider.h"
#include "tests/parity/parity.h"

namespace twintrace::parity {
namespace {

std::string shaderText(const std::string& file) {
  const auto found = ShaderLibrary().find(file);
  REQUIRE(found);
  return found->text;
}

/// Where a function's definition begins and ends in a shader's text, in its first overload.
std::pair<std::size_t, std::size_t> extentOf(const std::string& text, const std::string& name) {
  const std::size_t call = text.find(" " + name + "(");
  REQUIRE(call != std::string::npos);
  const std::size_t begin = text.rfind('\n', call) + 1;
  const std::size_t end = text.find("\n}\n", begin);
  REQUIRE(end != std::string::npos);
  return {begin, end};
}

/// The text with every `from` in the function replaced; at least one.
std::string replacedIn(const std::string& text, const std::string& name, const std::string& from,
                       const std::string& to) {
  const auto [begin, end] = extentOf(text, name);
  std::string body = text.substr(begin, end - begin);
  REQUIRE(body.find(from) != std::string::npos);
  for (std::size_t at = body.find(from); at != std::string::npos; at = body.find(from, at + to.size())) {
    body.replace(at, from.size(), to);
  }
  return text.substr(0, begin) + body + text.substr(end);
}

/// Expects the damaged library to lose the function's parity in a way that names it.
void checkNoticed(const std::string& signature, const ShaderLibrary& damaged) {
  const auto context = createContext(Provider::osmesa, 0);
  const ShaderFunction& function = functionOf(signature);
  const World world = plainWorld();
  const auto inputs = drawInputs(function, world, kRandomCount, kSeed);
  const auto twin = runTwin(function, world, inputs);
  const auto sound = runShader(*context, ShaderLibrary(), function, world, inputs);
  const auto shader = runShader(*context, damaged, function, world, inputs);
  const Difference before = differenceOf(function, twin, sound);
  const Difference after = differenceOf(function, twin, shader);
  INFO(signature << ": " << after.differing << " of " << after.records << " records differ");
  CHECK(before.differing == 0);
  CHECK(after.differing > 0);
  const std::string message =
      describe(function, world, after.first, inputs, {{"twin", twin}, {"shader", shader}});
  CHECK(message.starts_with(signature + " of shaders/" + function.file));
}

void checkReplacementNoticed(const std::string& signature, const std::string& from,
                             const std::string& to) {
  const ShaderFunction& function = functionOf(signature);
  const std::string text = replacedIn(shaderText(function.file), function.name, from, to);
  INFO("'" << from << "' to '" << to << "'");
  checkNoticed(signature, ShaderLibrary({}, {{function.file, {text, ""}}}));
}

/// All shaders without the qualifier.
ShaderLibrary withoutPrecise() {
  constexpr std::string_view kQualifier = "precise ";
  ShaderLibrary::Overrides overrides;
  for (const EmbeddedShader& shader : embeddedShaders()) {
    std::string text(shader.text);
    for (std::size_t at = text.find(kQualifier); at != std::string::npos; at = text.find(kQualifier, at)) {
      text.erase(at, kQualifier.size());
    }
    overrides[std::string(shader.path)] = {text, ""};
  }
  return ShaderLibrary({}, overrides);
}

}  // namespace

// Their own qualifiers alone hold these: whatever uses their results is outside.
TEST_CASE("without its precise, a function loses parity", "[parity][gl][mutation]") {
  for (const char* signature : {"log2Of(float)", "least(float, float)", "greatest(float, float)"}) {
    checkReplacementNoticed(signature, "precise ", "");
  }
}

// In most functions the driver makes up for a missing qualifier where the value goes on into a callee
// that has it (here `select`, at the end), so these expressions lose it together with their callees.
TEST_CASE("without precise, rewritten expressions lose parity", "[parity][gl][mutation]") {
  for (const char* signature :
       {"sinCosReduced(float, int)", "sine(float)",
        "sineHash(float, float)", "arcTangent2(float, float)", "pdfPowerHemisphere(float, float)",
        "sampleGgxNormal(float, float, float)", "intersectSphereReport(Ray, Sphere)",
        "evaluatePhong(vec3, vec3, vec3, float, vec3)"}) {
    checkNoticed(signature, withoutPrecise());
  }
}

TEST_CASE("a changed constant loses parity", "[parity][gl][mutation]") {
  checkReplacementNoticed("log2Of(float)", "2.0000714765e-1f", "2.0000716e-1f");
  checkReplacementNoticed("sinCosReduced(float, int)", "8.3321608736e-3f", "8.3321618e-3f");
  checkReplacementNoticed("pcgHash(uint)", "277803737u", "277803739u");
}

TEST_CASE("a changed order of operations loses parity", "[parity][gl][mutation]") {
  checkReplacementNoticed("dot3(vec3, vec3)", "(a.x * b.x + a.y * b.y) + a.z * b.z",
                          "a.x * b.x + (a.y * b.y + a.z * b.z)");
  checkReplacementNoticed("tangentToWorld(vec3, vec3)",
                          "(tangent * local.x + binormal * local.y) + n * local.z",
                          "tangent * local.x + (binormal * local.y + n * local.z)");
  checkReplacementNoticed("maskingGgx(float, float)", "(1.0f - squared) * (cosTheta * cosTheta)",
                          "((1.0f - squared) * cosTheta) * cosTheta");
}

}  // namespace twintrace::parity
