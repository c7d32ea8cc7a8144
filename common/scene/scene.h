#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/base/error.h"
#include "common/scene/shapes.h"
#include "common/trace/options.h"

namespace twintrace {

/// Pinhole or thin-lens camera; lengths in scene units.
struct Camera {
  glm::vec3 eye{0.0f, 0.0f, 5.0f};
  glm::vec3 target{0.0f};
  glm::vec3 up{0.0f, 1.0f, 0.0f};
  float fov = 40.0f;           ///< vertical, degrees, in (0, 180)
  float aperture = 0.0f;       ///< lens diameter; 0 = pinhole
  std::optional<float> focus;  ///< distance of the plane in focus; default |target - eye|
};

/// What a ray sees that leaves the scene: a constant, or an equirectangular image times strength.
struct Environment {
  glm::vec3 radiance{0.0f};
  std::string image;      ///< path as resolved against the scene file; empty = constant
  float strength = 1.0f;
  float rotation = 0.0f;  ///< degrees about y
};

enum class Lobe { ggx, phong };

/// Roughness below which a lobe is a mirror: narrower ones underflow in float.
inline constexpr float kMirrorRoughness = 1e-4f;


struct Material {
  std::string name;
  glm::vec3 albedo{0.0f};
  glm::vec3 specular{0.0f};
  glm::vec3 emission{0.0f};   ///< radiance, leaves both sides
  glm::vec3 ambient{0.0f};    ///< k_a of eq. 1
  glm::vec3 highlight{0.0f};  ///< k_s of eq. 1
  float exponent = 64.0f;     ///< alpha of eq. 1
  float roughness = 0.0f;     ///< 0 = mirror, else glossy by `lobe`
  Lobe lobe = Lobe::ggx;
};

struct Object {
  std::string name;
  std::variant<SphereShape, BoxShape, PlaneShape, MeshShape, GeneratedShape> shape;
  int material = 0;  ///< index into Scene::materials
  SourceLocation location = {};  ///< messages only
};

/// Local lights of eq. 1, invisible to rays.
struct PointLight {
  glm::vec3 position{0.0f};
  glm::vec3 intensity{1.0f};  ///< W/sr
};
struct SphereLight {
  glm::vec3 position{0.0f};
  float radius = 1.0f;
  glm::vec3 intensity{1.0f};  ///< W/sr; radiance = intensity / (pi radius^2)
};
struct SunLight {
  glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< the way its light travels
  glm::vec3 irradiance{1.0f};              ///< on a surface that faces the sun
  float angle = 0.0f;                      ///< angular diameter, degrees
};
using Light = std::variant<PointLight, SphereLight, SunLight>;

/// What the author wrote, checked and with defaults filled in. Built by readScene.
struct Scene {
  std::string name;
  std::string path;  ///< of the file; messages only, not part of the scene's identity
  Camera camera;
  RenderOptions render;  ///< [film] and [render] over the defaults
  Environment environment;
  std::vector<Material> materials;
  std::vector<Object> objects;
  std::vector<Light> lights;
  std::map<std::string, bool> forcedEffects;  ///< [effects]: name -> on or off
  std::vector<std::string> warnings;          ///< about files that it names
};

}  // namespace twintrace
