#include "common/cast/families.h"

#include <algorithm>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/cast/family_recipe.h"

namespace twintrace {
namespace {

std::vector<FamilyRecipe> allRecipes() {
  std::vector<FamilyRecipe> all;
  for (const auto& part : {sphereFamilies(), boxFamilies(), orientedFamilies(), planeFamilies(),
                           triangleFamilies(), sceneFamilies(), bounceFamilies()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

const std::vector<FamilyRecipe>& recipes() {
  static const std::vector<FamilyRecipe> all = allRecipes();
  return all;
}

std::vector<Family> familiesOf(const std::vector<FamilyRecipe>& all) {
  std::vector<Family> list;
  for (const FamilyRecipe& recipe : all) list.push_back(recipe.family);
  return list;
}

const FamilyRecipe& findRecipe(std::string_view name) {
  const auto found =
      std::find_if(recipes().begin(), recipes().end(),
                   [&](const FamilyRecipe& recipe) { return recipe.family.name == name; });
  if (found != recipes().end()) return *found;
  std::vector<std::string> names;
  for (const Family& family : families()) names.push_back(family.name);
  throw UsageError("found family " + quote(name) + ", expected all or a family's name" +
                   didYouMean(name, names));
}

/// FNV-1a, so that families of one seed are unlike each other.
std::uint64_t hashOf(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

void addScene(CaseSet& cases, const std::vector<CasePrimitive>& primitives) {
  CaseScene scene;
  scene.first = static_cast<std::uint32_t>(cases.primitives.size());
  scene.count = static_cast<std::uint32_t>(primitives.size());
  cases.primitives.insert(cases.primitives.end(), primitives.begin(), primitives.end());
  cases.scenes.push_back(scene);
}

void addRay(CaseSet& cases, const Case& drawn, bool bounces) {
  cases.rays.push_back({drawn.ray, static_cast<std::uint32_t>(cases.scenes.size() - 1)});
  if (bounces) cases.bounces.push_back(drawn.bounce);
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = familiesOf(recipes());
  return all;
}

const Family& findFamily(std::string_view name) {
  return findRecipe(name).family;
}

CaseSet drawFamily(std::string_view name, std::uint32_t count, std::uint64_t seed,
                   std::uint64_t first) {
  const FamilyRecipe& recipe = findRecipe(name);
  const std::uint64_t own = mixSeed(seed, hashOf(name));
  // Scenes have numbers of their own, or they would repeat those of their first ray.
  const std::uint64_t ofScenes = mixSeed(own, hashOf("scene"));
  CaseSet cases;
  Case shared;
  for (std::uint64_t i = first; i < first + count; ++i) {
    const bool newScene = !recipe.scene || i == first || i % kRaysPerScene == 0;
    if (recipe.scene && newScene) {
      CaseRandom random(mixSeed(ofScenes, i / kRaysPerScene));
      shared.primitives = recipe.scene(random);
    }
    CaseRandom random(mixSeed(own, i));
    Case drawn = recipe.scene ? std::move(shared) : Case{};
    recipe.draw(random, drawn);
    if (newScene) addScene(cases, drawn.primitives);
    addRay(cases, drawn, recipe.family.kind == FamilyKind::bounce);
    if (recipe.scene) shared = std::move(drawn);
  }
  return cases;
}

}  // namespace twintrace
