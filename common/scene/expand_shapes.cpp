#include "common/scene/expand_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/base/wording.h"
#include "common/generate/generators.h"
#include "common/mesh/load_mesh.h"
#include "common/scene/rotation.h"
#include "common/scene/shape_files.h"
#include "common/scene/toml_table.h"

namespace twintrace {
namespace {

/// A placement as a map of points.
class Placed {
 public:
  explicit Placed(const Placement& placement)
      : turn_(rotationMatrix(placement.rotation)),
        scale_(placement.scale),
        translation_(placement.translation) {}

  glm::vec3 point(const glm::dvec3& p) const {
    return glm::vec3(turn_ * (p * scale_) + translation_);
  }
  glm::vec3 direction(const glm::dvec3& d) const { return glm::vec3(turn_ * d); }
  glm::vec3 angles(const BoxShape& box) const {
    return rotationAngles(turn_ * rotationMatrix(box.rotation.value_or(glm::vec3(0.0f))));
  }
  double scale() const { return scale_; }

 private:
  glm::dmat3 turn_;
  double scale_;
  glm::dvec3 translation_;
};

Parts placed(Parts parts, const Placement& placement) {
  const Placed map(placement);
  for (SphereShape& sphere : parts.spheres) {
    sphere.center = map.point(sphere.center);
    sphere.radius = float(sphere.radius * map.scale());
  }
  for (BoxShape& box : parts.boxes) {
    box.center = map.point(box.center);
    box.size *= map.scale();
    if (placement.rotation != glm::vec3(0.0f)) box.rotation = map.angles(box);
  }
  for (glm::vec3& position : parts.mesh.positions) position = map.point(position);
  for (glm::vec3& normal : parts.mesh.normals) normal = map.direction(normal);
  return parts;
}

/// As of all numbers in scenes: squares of lengths stay within floats.
bool isUsable(const glm::dvec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kMaxMagnitude;
}

bool isUsable(const Parts& parts) {
  return std::ranges::all_of(parts.spheres,
                             [](const SphereShape& sphere) {
                               return isUsable(sphere.center) && sphere.radius <= kMaxMagnitude;
                             }) &&
         std::ranges::all_of(
             parts.boxes,
             [](const BoxShape& box) { return isUsable(box.center) && isUsable(box.size); }) &&
         std::ranges::all_of(parts.mesh.positions,
                             [](const glm::vec3& p) { return isUsable(glm::dvec3(p)); });
}

/// A sphere that is smaller has a radius whose square is zero to the tracers.
bool isTooSmall(const SphereShape& sphere) {
  return sphere.radius < kMinLength;
}

class Expansion {
 public:
  explicit Expansion(Scene& scene) : scene_(scene) {}

  void run() {
    for (Object& object : std::exchange(scene_.objects, {})) {
      if (auto* mesh = std::get_if<MeshShape>(&object.shape)) {
        readMesh(object, *mesh);
        scene_.objects.push_back(std::move(object));
      } else if (const auto* generated = std::get_if<GeneratedShape>(&object.shape)) {
        generate(object, *generated);
      } else {
        scene_.objects.push_back(std::move(object));
      }
    }
    checkNames();
    if (!faults_.empty()) throw FileError(std::move(faults_));
  }

 private:
  std::shared_ptr<const Parts> put(const Object& object, Parts parts, const Placement& placement) {
    auto result = std::make_shared<const Parts>(placed(std::move(parts), placement));
    if (!isUsable(*result)) {
      faults_.push_back(
          {object.location, fmt::format("found coordinates beyond 1e18 in object {} as scaled and "
                                        "moved, expected smaller ones",
                                        quote(object.name))});
    }
    if (std::ranges::any_of(result->spheres, isTooSmall)) {
      faults_.push_back({object.location,
                         fmt::format("found spheres with radii below 1e-18 in object {} as scaled, "
                                     "expected a larger scale",
                                     quote(object.name))});
    }
    return result;
  }

  /// Those of a generator's objects may be others' too.
  void checkNames() {
    std::map<std::string_view, const Object*> owners;
    for (const Object& object : scene_.objects) {
      const auto [owner, isNew] = owners.emplace(object.name, &object);
      if (isNew) continue;
      faults_.push_back(
          {object.location, fmt::format("found a second object named {} (the first is in line {}), "
                                        "expected a name of its own",
                                        quote(object.name), owner->second->location.line)});
    }
  }

  void readMesh(const Object& object, MeshShape& shape) {
    try {
      shape.parts = put(object, files_.load(shape, scene_.warnings), shape.placement);
    } catch (const MeshError& error) {
      faults_.push_back({object.location, error.what()});
    } catch (const FileError& error) {
      faults_.insert(faults_.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  }

  void generate(const Object& object, const GeneratedShape& shape) {
    std::vector<Parts> objects = findGenerator(shape.generator)->make(shape.size, shape.seed);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      Object made = object;
      if (objects.size() > 1) made.name = fmt::format("{}-{}", object.name, i);
      GeneratedShape& one = std::get<GeneratedShape>(made.shape);
      one.parts = put(object, std::move(objects[i]), shape.placement);
      scene_.objects.push_back(std::move(made));
    }
  }

  Scene& scene_;
  ShapeFiles files_;
  std::vector<Diagnostic> faults_;
};

}  // namespace

void expandShapes(Scene& scene) {
  Expansion(scene).run();
}

}  // namespace twintrace
