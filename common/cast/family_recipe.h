#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "common/cast/case_random.h"
#include "common/cast/families.h"

namespace twintrace {

/// One ray with all that it sees.
struct Case {
  std::vector<CasePrimitive> primitives;
  CastRay ray;
  Bounce bounce{0.0f};
};

/// How a family is drawn.
struct FamilyRecipe {
  Family family;
  /// Fills in the case; primitives are there already if the recipe has a scene of its own.
  std::function<void(CaseRandom&, Case&)> draw;
  /// Draws primitives that several rays share, for scenes of many; else empty.
  std::function<std::vector<CasePrimitive>(CaseRandom&)> scene;
};

/// Rays that share a scene drawn by FamilyRecipe::scene.
inline constexpr std::uint32_t kRaysPerScene = 256;

std::vector<FamilyRecipe> sphereFamilies();
std::vector<FamilyRecipe> boxFamilies();
std::vector<FamilyRecipe> orientedFamilies();
std::vector<FamilyRecipe> planeFamilies();
std::vector<FamilyRecipe> triangleFamilies();
std::vector<FamilyRecipe> sceneFamilies();
std::vector<FamilyRecipe> bounceFamilies();

CasePrimitive sphereOf(const glm::dvec3& centre, double radius);
CasePrimitive boxOf(const glm::dvec3& low, const glm::dvec3& high);
CasePrimitive orientedBoxOf(const glm::dvec3& centre, const glm::dmat3& axes,
                            const glm::dvec3& halfSizes);
CasePrimitive planeOf(const glm::dvec3& normal, const glm::dvec3& point);
CasePrimitive triangleOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// A ray in float over [0, largest float], rounded from double.
CastRay rayOf(const glm::dvec3& origin, const glm::dvec3& direction);

/// A ray to a target as float directions are made: towards it from the rounded origin, unit.
CastRay rayTowards(const glm::dvec3& origin, const glm::dvec3& target);

/// The same case turned and moved. Boxes become oriented boxes.
Case moved(const Case& given, const glm::dmat3& rotation, const glm::dvec3& offset);

}  // namespace twintrace
