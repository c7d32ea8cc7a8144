#include "common/import/adapt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>

#include "common/base/wording.h"

namespace twintrace {

void Surroundings::add(const Parts& parts) {
  for (const SphereShape& sphere : parts.spheres) {
    const glm::dvec3 center(sphere.center);
    add(center - double(sphere.radius), center + double(sphere.radius));
  }
  for (const glm::vec3& position : parts.mesh.positions) add(position, position);
}

void Surroundings::add(const glm::dvec3& low, const glm::dvec3& high) {
  low_ = empty_ ? low : glm::min(low_, low);
  high_ = empty_ ? high : glm::max(high_, high);
  empty_ = false;
}

glm::dvec3 Surroundings::center() const {
  return (low_ + high_) * 0.5;
}

double Surroundings::radius() const {
  const double radius = glm::length(high_ - low_) * 0.5;
  return radius > 0.0 ? radius : 1.0;
}

Camera framing(const Surroundings& surroundings) {
  Camera camera;
  const glm::dvec3 towards = glm::normalize(glm::dvec3(0.45, 0.35, 1.0));
  const double distance = surroundings.radius() / std::sin(glm::radians(double(camera.fov)) / 2.0);
  camera.eye = glm::vec3(surroundings.center() + towards * distance);
  camera.target = glm::vec3(surroundings.center());
  return camera;
}

float roughnessOfExponent(double exponent) {
  const double share = std::log(std::clamp(exponent, 1.0, 1000.0)) / std::log(1000.0);
  return float(1.0 - std::sqrt(share));
}

double fitEnergy(Material& material) {
  // As in scenes: what adds up to 1 in decimals may round to more in floats, by at most this.
  constexpr double kSumSlack = 1.0 / (1 << 24);
  const glm::dvec3 sums = glm::dvec3(material.albedo) + glm::dvec3(material.specular);
  const double sum = std::max({sums.x, sums.y, sums.z});
  if (sum <= 1.0 + kSumSlack) return 1.0;
  // Nothing is rounded up, so that the colours' sum stays at most 1.
  const auto scaled = [&](const glm::vec3& color) {
    glm::vec3 result(glm::dvec3(color) / sum);
    for (int i = 0; i < 3; ++i) {
      if (double(result[i]) * sum > color[i]) result[i] = std::nextafter(result[i], 0.0f);
    }
    return result;
  };
  material.albedo = scaled(material.albedo);
  material.specular = scaled(material.specular);
  return sum;
}

std::string energyNote(std::span<const double> sums) {
  const auto count = std::ranges::count_if(sums, [](double sum) { return sum > 1.0; });
  if (count == 0) return "";
  return fmt::format("{} (diffuse and specular add up to {:.4g}) and {} scaled to add up to 1",
                     counted(count, "material reflects more than it receives",
                             "materials reflect more than they receive"),
                     *std::ranges::max_element(sums), count == 1 ? "is" : "are");
}

namespace {

/// Scene files are UTF-8 and their names without control characters.
std::string plainName(const std::string& name) {
  std::string plain;
  for (const char c : name) plain += c >= 0x20 && c < 0x7f ? c : '_';
  return plain.empty() ? "material" : plain;
}

}  // namespace

void makeNamesUnique(std::vector<Material*> materials) {
  std::set<std::string> names;
  for (Material* material : materials) {
    const std::string plain = plainName(material->name);
    material->name = plain;
    for (int i = 2; !names.insert(material->name).second; ++i) {
      material->name = fmt::format("{}-{}", plain, i);
    }
  }
}

}  // namespace twintrace
