#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "common/generate/parts.h"
#include "common/scene/scene.h"

// What all importers do to make another format's scene one of ours.

namespace twintrace {

/// An axis-aligned box around surfaces, empty at first.
class Surroundings {
 public:
  void add(const Parts& parts);
  glm::dvec3 center() const;
  /// Half the diagonal; 1 if there is no extent.
  double radius() const;

 private:
  void add(const glm::dvec3& low, const glm::dvec3& high);

  bool empty_ = true;
  glm::dvec3 low_{0.0};
  glm::dvec3 high_{0.0};
};

/// A camera that sees all of it, from the front, the right and above.
Camera framing(const Surroundings& surroundings);

/// The roughness at which the lobe `phong` has an exponent (design of the lobe: 1000^((1 -
/// roughness)^2)); 1 below 1, 0 (a mirror) above 1000.
float roughnessOfExponent(double exponent);

/// Scales albedo and specular together so that no channel reflects more than it receives.
/// @return the largest sum before, at least 1
double fitEnergy(Material& material);

/// For a note: how many of so many materials were scaled, `sums` of all as from fitEnergy. Empty if
/// none.
std::string energyNote(std::span<const double> sums);

/// Gives each material a name that no other has and that a scene file can hold.
void makeNamesUnique(std::vector<Material*> materials);

}  // namespace twintrace
