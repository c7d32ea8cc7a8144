#include "experiments/probe/input_domains.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/hulls/hull_structure.h"

namespace twintrace::probe {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kTiny = std::numeric_limits<float>::min();
constexpr float kHuge = std::numeric_limits<float>::max();

constexpr float kSpecialFloats[] = {
    0.0f, -0.0f, kTiny, -kTiny, 1e-40f, -1e-45f, kInf, -kInf, kNan, kHuge, -kHuge, 1.0f, -1.0f, 0.5f,
    2.0f, 0.99999994f, 1.0000001f, -0.5f, 8388608.0f, 8388607.5f, -8388607.5f, 16777216.0f, 2.5f,
    1.57079633f, 3.14159265f, 0.70710678f, 1e-9f, 1e9f, -3.0f, 1e-20f, 1e20f};

}  // namespace

float anyFloat(Source& from) {
  if (from.special()) return from.oneOf(kSpecialFloats);
  switch (from.integer(0, 7)) {
    case 0:
      return std::bit_cast<float>(from.bits());
    case 1:
    case 2:
      return std::ldexp(from.uniform(-2.0, 2.0), from.integer(-20, 20));
    default:
      return from.uniform(-2.0, 2.0);
  }
}

namespace {

float unitInterval(Source& from) {
  constexpr float kEnds[] = {0.0f, 1.0f, 0.99999994f, 5.9604645e-8f, 0.25f, 0.5f, 0.75f, 0.125f,
                             kTiny, 1e-40f};
  if (from.special()) return from.oneOf(kEnds);
  return static_cast<float>(from.bits() >> 8) * 5.9604644775390625e-8f;
}

/// Finite at all times, since it becomes an integer.
float guessedMantissa(Source& from) { return from.uniform(0.5, 2.0); }

/// Values in [low, high] mostly, any float when special ones are due.
auto within(double low, double high) {
  return [=](Source& from) {
    return from.special() ? from.oneOf(kSpecialFloats) : from.uniform(low, high);
  };
}

float distance(Source& from) {
  if (from.special()) return from.oneOf(kSpecialFloats);
  return from.integer(0, 3) == 0 ? kHuge : from.uniform(0.0, 6.0);
}
float nearEnd(Source& from) { return from.special() ? from.oneOf(kSpecialFloats) : 0.0f; }
float farEnd(Source& from) { return from.special() ? from.oneOf(kSpecialFloats) : kHuge; }


}  // namespace

Vector anyVector(Source& from) {
  if (from.integer(0, 3) == 0) return {anyFloat(from), anyFloat(from), anyFloat(from)};
  const auto near = within(-2.0, 2.0);
  return {near(from), near(from), near(from)};
}

namespace {

// Round coordinates, so that points on faces, edges and centres come up.
float coordinate(Source& from) {
  constexpr float kRound[] = {0.0f, -0.0f, 0.5f, -0.5f, 1.0f, -1.0f, 0.50005f, 1e-5f, 1e6f, -1e6f,
                              kInf, kNan, kHuge, 1e-40f};
  return from.special() ? from.oneOf(kRound) : from.uniform(-2.0, 2.0);
}
Vector point(Source& from) { return {coordinate(from), coordinate(from), coordinate(from)}; }

Vector unitVector(Source& from) {
  double v[3];
  double squared = 0.0;
  do {
    for (double& x : v) x = 2.0 * from.real() - 1.0;
    squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  } while (squared > 1.0 || squared < 1e-6);
  const double scale = 1.0 / std::sqrt(squared);
  return {static_cast<float>(v[0] * scale), static_cast<float>(v[1] * scale),
          static_cast<float>(v[2] * scale)};
}

// Axis-parallel, grazing, not unit, zero and not finite where special values are due.
Vector direction(Source& from) {
  constexpr float kParts[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-6f, -1e-6f, 0.70710678f, -0.70710678f,
                              1e-20f, 1e10f, 0.995f, kNan, kInf, 1e-40f};
  if (from.special()) {
    if (from.integer(0, 1) == 0) {
      Vector axis = {0.0f, 0.0f, 0.0f};
      axis[from.bits() % 3] = from.integer(0, 1) == 0 ? 1.0f : -1.0f;
      axis[from.bits() % 3] += from.integer(0, 3) == 0 ? 1e-6f : 0.0f;
      return axis;
    }
    return {from.oneOf(kParts), from.oneOf(kParts), from.oneOf(kParts)};
  }
  return unitVector(from);
}

Vector colour(Source& from) {
  const auto channel = [](Source& f) {
    constexpr float kEnds[] = {0.0f, 1.0f, -0.0f, kTiny, 1e-40f, kInf, kNan, kHuge};
    return f.special() ? f.oneOf(kEnds) : f.uniform(0.0, 2.0);
  };
  return {channel(from), channel(from), channel(from)};
}

/// A box corner on one side of the origin, mostly.
auto corner(double low, double high) {
  return [=](Source& from) -> Vector {
    const auto part = within(low, high);
    return {part(from), part(from), part(from)};
  };
}

}  // namespace

int anyInteger(Source& from) {
  constexpr int kSpecial[] = {0, 1, -1, 2, std::numeric_limits<int>::max(),
                              std::numeric_limits<int>::min()};
  return from.special() ? kSpecial[from.bits() % 6] : static_cast<int>(from.bits());
}

std::uint32_t anyNatural(Source& from) {
  constexpr std::uint32_t kSpecial[] = {0u, 1u, 255u, 256u, 0x7fffffffu, 0x80000000u, 0xffffffffu};
  return from.special() ? kSpecial[from.bits() % 7] : from.bits();
}

namespace {

IntDomain between(int low, int high) {
  return {[=](Source& from) { return from.integer(low, high); }, {}};
}
IntDomain within(const std::function<IntRange(const World&)>& bounds) {
  const auto draw = [=](Source& from) {
    const IntRange range = bounds(from.world);
    return from.integer(range.least, range.most);
  };
  return {draw, bounds};
}
/// Below one of the scene's counts.
IntDomain below(int SceneIndex::*count) {
  return within([=](const World& world) { return IntRange{0, world.scene.index.*count - 1}; });
}
IntRange primitives(const World& world) { return {0, world.scene.index.primitiveCount() - 1}; }
/// Texels at which a hull's record may begin, whatever its volume: none has more than this many.
constexpr int kMostRecordTexels = 16;
IntRange hullRecords(const World& world) {
  if (world.scene.hulls == nullptr) return {0, 0};
  return {0, static_cast<int>(world.scene.hulls->texels.size()) - kMostRecordTexels};
}
IntRange hullNodes(const World& world) {
  return {0, world.scene.hulls == nullptr ? 0 : world.scene.hulls->nodeCount - 1};
}
IntRange bounded(const World& world) { return {0, world.scene.index.boundedCount() - 1}; }
IntRange texels(const World& world) { return {0, static_cast<int>(world.scene.texels.size()) - 1}; }

int anyPrimitive(Source& from) {
  const IntRange range = primitives(from.world);
  return from.integer(0, 7) == 0 ? layout::kNoPrimitive : from.integer(range.least, range.most);
}
/// As a hit has it, whose primitive is read.
IntDomain maybePrimitive() { return {anyPrimitive, primitives, true}; }

/// One of the first of the world's cases, so that a few more lie behind it.
IntDomain caseTexel() {
  const auto first = [](const World& world) {
    return static_cast<int>(world.scene.texels.size()) - kWorldCases * layout::kCaseTexels;
  };
  return {[=](Source& from) {
            return first(from.world) + from.integer(0, kWorldCases / 3) * layout::kCaseTexels;
          },
          [=](const World& world) {
            return IntRange{std::max(first(world), 0),
                            first(world) + kWorldCases / 3 * layout::kCaseTexels};
          }};
}
/// How many cases to read from there on.
IntDomain caseCount() {
  return within([](const World&) { return IntRange{0, kWorldCases / 3}; });
}

}  // namespace

const Domains<float>& floatDomains() {
  static const Domains<float> domains = {
      {"u", unitInterval},
      {"v", unitInterval},
      {"lobeChoice", unitInterval},
      {"specularChance", unitInterval},
      {"alpha", unitInterval},
      {"inverse", unitInterval},
      {"phongInverse", unitInterval},
      {"phongScale", within(1.0, 1.5)},
      {"guess", guessedMantissa},
      {"exponent", within(0.0, 200.0)},
      {"phongExponent", within(1.0, 1000.0)},
      {"cosTheta", within(-0.2, 1.0)},
      {"height", within(0.0, 2.0)},
      {"radius", within(0.0, 1.5)},
      {"t", distance},
      {"distance", distance},
      {"tmin", nearEnd},
      {"tmax", farEnd},
      {"reach", within(0.0, 3.0)},
      {"castCase.scale", within(0.5, 2.0)},
      {"intersectCase.scale", within(0.5, 2.0)},
      {"caseSurface.scale", within(0.5, 2.0)},
      {"offset", within(0.0, 1e-5)},
      {"angle", within(-0.8, 0.8)},
      {"sinCosReduced.angle", within(-0.8, 0.8)},
      {"environmentBilinear.column", within(-1.0, 17.0)},
      {"environmentBilinear.row", within(-1.0, 9.0)},
  };
  return domains;
}

const Domains<Vector>& vectorDomains() {
  static const Domains<Vector> domains = {
      {"direction", direction},
      {"d", direction},
      {"n", direction},
      {"i", direction},
      {"normal", direction},
      {"facing", direction},
      {"axisX", direction},
      {"axisY", direction},
      {"axisZ", direction},
      {"local", direction},
      {"origin", point},
      {"center", point},
      {"position", point},
      {"point", point},
      {"p", point},
      {"halfSize", corner(0.0, 1.5)},
      {"reportBoxNormal.halfSize", point},
      {"minimum", corner(-1.5, 0.2)},
      {"maximum", corner(-0.2, 1.5)},
      {"throughput", colour},
      {"radiance", colour},
      {"weight", colour},
      {"albedo", colour},
      {"albedoWeight", colour},
      {"specular", colour},
      {"specularWeight", colour},
      {"reflectance", colour},
      {"highlight", colour},
      {"ambient", colour},
      {"colour", colour},
      {"value", colour},
      {"light", colour},
  };
  return domains;
}

const std::map<std::string, IntDomain, std::less<>>& intDomains() {
  static const std::map<std::string, IntDomain, std::less<>> domains = {
      {"sinCosReduced.quarters", between(-8, 8)},
      {"wrapColumn.width", between(1, 64)},
      {"wrapColumn.x", between(-64, 128)},
      {"fetchEnvironmentPixel.x", below(&SceneIndex::environmentWidth)},
      {"fetchEnvironmentPixel.y", below(&SceneIndex::environmentHeight)},
      {"fetchSphere.index", below(&SceneIndex::sphereCount)},
      {"visitedSphere.index", below(&SceneIndex::sphereCount)},
      {"fetchBox.index", below(&SceneIndex::boxCount)},
      {"visitedBox.index", below(&SceneIndex::boxCount)},
      {"fetchOrientedBox.index", below(&SceneIndex::orientedBoxCount)},
      {"visitedOrientedBox.index", below(&SceneIndex::orientedBoxCount)},
      {"fetchTriangle.index", below(&SceneIndex::triangleCount)},
      {"visitedTriangle.index", below(&SceneIndex::triangleCount)},
      {"fetchSmoothIndex.triangle", below(&SceneIndex::triangleCount)},
      {"fetchNormals.index", below(&SceneIndex::smoothCount)},
      {"fetchPlane.index", below(&SceneIndex::planeCount)},
      {"visitedPlane.index", below(&SceneIndex::planeCount)},
      {"fetchLight.index", below(&SceneIndex::lightCount)},
      {"fetchTexel.index", within(texels)},
      {"intersectPrimitive.primitive", within(bounded)},
      {"record", within(hullRecords)},
      {"hullTexel", within(hullRecords)},
      {"node", within(hullNodes)},
      {"reference", within(bounded)},
      {"group", between(0, 4)},
      {"texel", caseTexel()},
      {"firstTexel", caseTexel()},
      {"count", caseCount()},
      {"surfaceInView.hit.primitive", within(primitives)},
      {"bounceInView.hit.primitive", within(primitives)},
      {"answerInView.hit.primitive", maybePrimitive()},
      {"surfaceAt.hit.primitive", maybePrimitive()},
      {"shadingNormal.hit.primitive", maybePrimitive()},
      {"powerOfTwo.exponent", between(-126, 127)},
      {"scaledByPower.exponent", between(-252, 254)},
      {"room", between(-94, 126)},
      {"shift", between(-221, 252)},
      {"fetchPrimitiveInfo.primitive", within(primitives)},
      {"primitive", {anyPrimitive, {}}},
      {"material", below(&SceneIndex::materialCount)},
      {"kind", between(layout::kLightPoint, layout::kLightSun)},
      {"lobe", between(layout::kLobeNone, layout::kLobePhong)},
      {"bounce", between(0, 8)},
      {"dimension", between(0, layout::kCounterStride - 1)},
      {"x", between(0, 47)},
      {"y", between(0, 31)},
      {"width", between(1, 4096)},
      {"Frame.width", between(48, 48)},
      {"Frame.bounces", between(0, 5)},
      {"Frame.passes", between(1, 2)},
  };
  return domains;
}

}  // namespace twintrace::probe
