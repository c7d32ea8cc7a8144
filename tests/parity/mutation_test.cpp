// Evidence that the parity tests can fail: each case damages one shader function and sees its parity
// lost. Which expressions Mesa rewrites without `precise` is measured, so a case that no longer
// differs after an upgrade tells that the rewriting has changed.

#include <algorithm>

#include "common/base/error.h"
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

/// Damages one function and expects its parity to be lost in a way that names it.
void checkNoticed(const std::string& signature, const std::string& from, const std::string& to) {
  const auto context = createContext(Provider::osmesa, 0);
  const ShaderFunction& function = functionOf(signature);
  const std::string text = replacedIn(shaderText(function.file), function.name, from, to);
  const ShaderLibrary damaged({}, {{function.file, {text, ""}}});
  const World world = plainWorld();
  const auto inputs = drawInputs(function, world, kRandomCount, kSeed);
  const auto twin = runTwin(function, world, inputs);
  const auto sound = runShader(*context, ShaderLibrary(), function, world, inputs);
  const auto shader = runShader(*context, damaged, function, world, inputs);
  const Difference before = differenceOf(function, twin, sound);
  const Difference after = differenceOf(function, twin, shader);
  INFO(signature << ": '" << from << "' to '" << to << "': " << after.differing << " of "
                 << after.records << " records differ");
  CHECK(before.differing == 0);
  CHECK(after.differing > 0);
  const std::string message =
      describe(function, world, after.first, inputs, {{"twin", twin}, {"shader", shader}});
  CHECK(message.starts_with(signature + " of shaders/" + function.file));
}

}  // namespace

TEST_CASE("without precise, parity is lost and the function named", "[parity][gl]") {
  const char* signature = GENERATE(
      "dot3(vec3, vec3)", "cross3(vec3, vec3)", "reflect3(vec3, vec3)", "sine(float)",
      "sinCosReduced(float, int)", "log2Of(float)", "exp2Of(float)", "arcTangent2(float, float)",
      "sineHash(float, float)", "tangentToWorld(vec3, vec3)", "distributionGgx(float, float)",
      "intersectSphereRobust(Ray, Sphere)", "intersectPlaneRobust(Ray, Plane)");
  checkNoticed(signature, "precise ", "");
}

TEST_CASE("a changed constant loses parity", "[parity][gl]") {
  checkNoticed("log2Of(float)", "2.0000714765e-1f", "2.0000716e-1f");
  checkNoticed("sinCosReduced(float, int)", "8.3321608736e-3f", "8.3321618e-3f");
  checkNoticed("pcgHash(uint)", "277803737u", "277803739u");
}

TEST_CASE("a changed order of operations loses parity", "[parity][gl]") {
  checkNoticed("dot3(vec3, vec3)", "(a.x * b.x + a.y * b.y) + a.z * b.z",
               "a.x * b.x + (a.y * b.y + a.z * b.z)");
  checkNoticed("tangentToWorld(vec3, vec3)", "(tangent * local.x + binormal * local.y) + n * local.z",
               "tangent * local.x + (binormal * local.y + n * local.z)");
  checkNoticed("maskingGgx(float, float)", "(cosTheta * cosTheta)", "cosTheta * cosTheta");
}

}  // namespace twintrace::parity
