#include "common/nff/nff_surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "common/base/wording.h"
#include "common/nff/cone_mesh.h"

namespace twintrace {
namespace {

/// As in scenes: squares of smaller lengths are denormals, which the tracers flush to zero.
constexpr float kLeastRadius = 1e-18f;

auto order(const NffFill& f) {
  return std::make_tuple(f.color.x, f.color.y, f.color.z, f.diffuse, f.specular, f.shine,
                         f.transmittance, f.ior);
}

/// The direction of a vector, or another one where it has none.
glm::vec3 unitOr(const glm::vec3& vector, const glm::vec3& other) {
  const double length = glm::length(glm::dvec3(vector));
  return length > 0.0 ? glm::vec3(glm::dvec3(vector) / length) : other;
}

}  // namespace

bool NffSurfaces::FillOrder::operator()(const NffFill& a, const NffFill& b) const {
  return order(a) < order(b);
}

void NffSurfaces::setFill(const NffFill& fill) {
  const auto [found, isNew] = indices_.emplace(fill, parts_.size());
  if (isNew) {
    parts_.emplace_back();
    parts_.back().fill = fill;
  }
  current_ = &parts_[found->second];
}

void NffSurfaces::addSphere(const glm::vec3& center, float radius) {
  if (radius < 0.0f) ++oddities_.insides;
  if (std::abs(radius) < kLeastRadius) {
    ++oddities_.pointSpheres;
    return;
  }
  current_->parts.spheres.push_back({center, std::abs(radius)});
  ++primitiveCount_;
}

void NffSurfaces::addCone(const glm::vec3& base, float baseRadius, const glm::vec3& apex,
                          float apexRadius) {
  if (baseRadius < 0.0f || apexRadius < 0.0f) ++oddities_.insides;
  const double widest = std::max(std::abs(baseRadius), std::abs(apexRadius));
  if (base == apex || widest == 0.0) {
    ++oddities_.flatCones;
    return;
  }
  Mesh& mesh = current_->parts.mesh;
  const std::size_t before = mesh.triangles.size();
  twintrace::addCone(mesh, base, std::abs(baseRadius), apex, std::abs(apexRadius));
  current_->curved = true;
  primitiveCount_ += static_cast<std::int64_t>(mesh.triangles.size() - before);
  ++oddities_.cones;
  oddities_.chordError = std::max(oddities_.chordError, coneChordError(widest));
}

void NffSurfaces::addPolygon(std::span<const glm::vec3> corners,
                             std::span<const glm::vec3> normals) {
  Mesh& mesh = current_->parts.mesh;
  const std::size_t before = mesh.triangles.size();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const Cut cut = cutter_.cut(corners, first, mesh.triangles);
  if (cut == Cut::nothing) {
    ++oddities_.flatPolygons;
    return;
  }
  if (cut == Cut::crossed) ++oddities_.crossedPolygons;
  primitiveCount_ += static_cast<std::int64_t>(mesh.triangles.size() - before);
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  addNormals(corners, normals);
}

void NffSurfaces::addNormals(std::span<const glm::vec3> corners,
                             std::span<const glm::vec3> normals) {
  const glm::vec3 flat(glm::normalize(areaVector(corners)));
  std::vector<glm::vec3>& all = current_->parts.mesh.normals;
  if (normals.empty()) {
    all.insert(all.end(), corners.size(), flat);
    return;
  }
  current_->curved = true;
  for (const glm::vec3& normal : normals) all.push_back(unitOr(normal, flat));
}

std::vector<std::string> NffSurfaces::warnings() const {
  std::vector<std::string> texts;
  const auto say = [&](std::int64_t count, std::string_view one, std::string_view many) {
    if (count > 0) texts.push_back(counted(count, one, many));
  };
  say(oddities_.flatPolygons, "polygon without area is left out",
      "polygons without area are left out");
  say(oddities_.crossedPolygons, "polygon crosses itself and is covered in part",
      "polygons cross themselves and are covered in part");
  say(oddities_.pointSpheres, "sphere without extent is left out",
      "spheres without extent are left out");
  say(oddities_.flatCones, "cone without extent is left out", "cones without extent are left out");
  say(oddities_.insides, "sphere or cone is to be seen from inside alone, but is from both sides",
      "spheres and cones are to be seen from inside alone, but are from both sides");
  if (oddities_.cones > 0) {
    texts.push_back(fmt::format("{} of {} sides (chord error at most {:.3g})",
                                counted(oddities_.cones, "cone or cylinder becomes a mesh",
                                        "cones and cylinders become meshes"),
                                kConeSides, oddities_.chordError));
  }
  return texts;
}

void NffSurfaces::moveInto(NffFile& file) {
  file.warnings = warnings();
  file.parts = std::move(parts_);
}

}  // namespace twintrace
