#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace twintrace {

/// A ray with a closed interval; the direction need not be unit and t counts in its length.
struct CastRay {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f, 0.0f, 1.0f};
  float tmin = 0.0f;
  float tmax = std::numeric_limits<float>::max();
};

/// The closest hit of a ray, smallest t and then lowest primitive; a miss has primitive -1.
struct CastHit {
  float t = 0.0f;
  std::int32_t primitive = -1;          ///< index into FlatScene's primitives
  glm::vec3 normal{0.0f};               ///< unit, outward (sphere, box) or as authored (plane)

  bool valid() const { return primitive >= 0; }
};

/// An engine that answers closest-hit queries against one flat scene.
class RayCaster {
 public:
  virtual ~RayCaster() = default;

  /// Closest hit of each ray, in the same order.
  virtual std::vector<CastHit> cast(std::span<const CastRay> rays) = 0;

  /// The engine's name on the command line: cpu, gpu, embree, ...
  virtual std::string name() const = 0;
};

}  // namespace twintrace
