#include "common/import/import_nff.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "common/base/wording.h"
#include "common/import/adapt.h"
#include "common/scene/layout.h"

namespace twintrace {
namespace {

bool isEmpty(const NffPart& part) {
  return part.parts.spheres.empty() && part.parts.mesh.triangles.empty();
}

/// The renderers that the format was made for take Kd times the colour, and Ks for white highlights
/// and for mirrored light alike.
Material materialOf(const NffFill& fill, int number) {
  Material material;
  material.name = fmt::format("fill-{}", number);
  material.albedo = fill.color * fill.diffuse;
  material.specular = glm::vec3(fill.specular);
  material.lobe = Lobe::phong;
  material.roughness = roughnessOfExponent(fill.shine);
  material.ambient = material.albedo;
  material.highlight = material.specular;
  material.exponent = fill.shine;
  return material;
}

void addParts(const NffFile& file, ImportedScene& scene) {
  std::vector<double> sums;
  std::int64_t transmitting = 0;
  for (std::size_t i = 0; i < file.parts.size(); ++i) {
    const NffPart& part = file.parts[i];
    if (isEmpty(part)) continue;
    ImportedPart imported{materialOf(part.fill, static_cast<int>(i)), static_cast<int>(i),
                          part.curved};
    sums.push_back(fitEnergy(imported.material));
    if (part.fill.transmittance > 0.0f) ++transmitting;
    scene.parts.push_back(std::move(imported));
    scene.sphereCount += static_cast<std::int64_t>(part.parts.spheres.size());
    scene.triangleCount += static_cast<std::int64_t>(part.parts.mesh.triangles.size());
  }
  if (const std::string note = energyNote(sums); !note.empty()) scene.notes.push_back(note);
  if (transmitting == 0) return;
  scene.notes.push_back(counted(transmitting, "fill lets light through (T), here it is opaque",
                                "fills let light through (T), here they are opaque"));
}

void takeView(const NffView& view, ImportedScene& scene) {
  scene.width = view.width;
  scene.height = view.height;
  scene.camera.eye = glm::vec3(view.from);
  scene.camera.target = glm::vec3(view.at);
  scene.camera.up = glm::vec3(view.up);
  scene.camera.fov = float(fovOfNff(view.angle, view.height));
  if (view.width == view.height) return;
  scene.notes.push_back(fmt::format(
      "{} x {} pixels: the angle is the vertical one, pixels are square", view.width, view.height));
}

/// Lights of NFF don't fade with distance, and have brightness 1 / sqrt(number of lights) where the
/// file gives none, as its renderers take it. Ours has that brightness at the point looked at: eq.
/// 1 has intensity / distance^2.
void addLights(const NffFile& file, ImportedScene& scene) {
  constexpr auto kLimit = static_cast<std::size_t>(layout::kMaxLights);
  const float brightness = float(1.0 / std::sqrt(double(file.lights.size())));
  for (const NffLight& light : file.lights) {
    if (scene.lights.size() == kLimit) break;
    const glm::dvec3 way = glm::dvec3(light.position) - glm::dvec3(scene.camera.target);
    const glm::vec3 color = light.color.value_or(glm::vec3(brightness));
    scene.lights.emplace_back(PointLight{light.position, color * float(glm::dot(way, way))});
  }
  if (!file.lights.empty()) {
    scene.notes.emplace_back(
        "lights fade with distance: they are as bright as in the file where the camera aims at");
  }
  if (file.lights.size() > kLimit) {
    scene.notes.push_back(fmt::format("{} lights, of which {} are left out", file.lights.size(),
                                      file.lights.size() - kLimit));
  }
}

Camera framed(const NffFile& file) {
  Surroundings surroundings;
  for (const NffPart& part : file.parts) surroundings.add(part.parts);
  return framing(surroundings);
}

}  // namespace

double fovOfNff(double angleDegrees, int pixels) {
  const double half = std::tan(glm::radians(angleDegrees) / 2.0) * pixels / (pixels - 1.0);
  return glm::degrees(2.0 * std::atan(half));
}

ImportedScene sceneOfNff(const NffFile& file, const std::string& path) {
  ImportedScene scene;
  scene.file = path;
  scene.integrator = "whitted";
  scene.background = file.background;
  scene.notes = file.warnings;
  addParts(file, scene);
  if (scene.parts.empty()) {
    throw FileError(path, "found no surface, expected at least one");
  }
  if (file.view) {
    takeView(*file.view, scene);
  } else {
    scene.camera = framed(file);
    scene.notes.emplace_back("no view: the camera sees all of it from the front");
  }
  addLights(file, scene);
  return scene;
}

ImportedScene importNff(const std::string& path) {
  return sceneOfNff(readNff(path), path);
}

}  // namespace twintrace
