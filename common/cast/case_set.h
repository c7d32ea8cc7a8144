#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "common/trace/ray_caster.h"

namespace twintrace {

/// Kinds of primitive in a case, numbered as in shaders/shared/layout.glsl.
enum class CaseKind : std::int32_t { sphere, box, orientedBox, plane, triangle };

/// One primitive as its float32 inputs, which every engine takes as exact.
///
/// Values by kind: sphere cx cy cz r; box xmin ymin zmin xmax ymax zmax; oriented box: centre, three
/// axes as given (neither unit nor orthogonal of need), three half sizes; plane nx ny nz px py pz;
/// triangle: three vertices, two-sided.
struct CasePrimitive {
  CaseKind kind = CaseKind::sphere;
  std::array<float, 15> values{};

  glm::vec3 vector(int first) const { return {values[first], values[first + 1], values[first + 2]}; }
};

/// Number of values of a kind of primitive.
int valueCount(CaseKind kind);

/// The primitive as all engines see it: denormal values are zero, swapped box bounds are put in order,
/// a radius and half sizes count by their absolute values.
CasePrimitive normalised(CasePrimitive primitive);

/// The ray as all engines see it: denormal components are zero.
CastRay normalised(CastRay ray);

/// A tiny scene: a range of a case set's primitives.
struct CaseScene {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// A ray of a case set, and the scene that it sees. Denormal components count as zero.
struct CaseRay {
  CastRay ray;
  std::uint32_t scene = 0;
};

/// What a ray does after its hit: it leaves the surface by the engine's own offset, on the side that it
/// came from, into the cosine-weighted direction of these two random numbers in [0, 1), and is cast
/// again over [0, largest float]. The answer is then that second hit; a ray whose first cast misses
/// has not started, and its answer's primitive is kBounceNotStarted.
using Bounce = glm::vec2;

/// Primitive of the answer to a bounce whose first cast missed.
inline constexpr std::int32_t kBounceNotStarted = -2;

/// Many tiny scenes with their rays, cast in one go.
struct CaseSet {
  std::vector<CasePrimitive> primitives;  ///< normalised
  std::vector<CaseScene> scenes;
  std::vector<CaseRay> rays;
  std::vector<Bounce> bounces;  ///< one per ray, or none at all: the answer is the first hit

  // Names from a file; empty where the index is the name.
  std::vector<std::string> primitiveNames;
  std::vector<std::string> sceneNames;
  std::vector<std::string> rayNames;

  std::span<const CasePrimitive> primitivesOf(const CaseRay& ray) const {
    const CaseScene& scene = scenes[ray.scene];
    return std::span(primitives).subspan(scene.first, scene.count);
  }
};

/// An engine that casts case sets.
///
/// Hits have the primitive's index within its scene, t in units of |direction|, and a unit normal:
/// outward for spheres and boxes, as authored for planes, and along (v1 - v0) x (v2 - v0) for
/// triangles. A ray with a NaN, or with an infinite origin or direction, or with a direction of zeros
/// misses, as does a hit beyond the largest float.
class CaseEngine {
 public:
  virtual ~CaseEngine() = default;

  /// The answer of each ray, in the same order.
  virtual std::vector<CastHit> cast(const CaseSet& cases) = 0;

  /// Its name on the command line: cpu, cpu64, gpu, embree.
  virtual std::string name() const = 0;

  /// Whether it can follow a bounce, and whether it has this kind of primitive.
  virtual bool canBounce() const { return true; }
  virtual bool has(CaseKind) const { return true; }
};

}  // namespace twintrace
