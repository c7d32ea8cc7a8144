#include "common/scene/read_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <string>

#include "common/base/wording.h"
#include "common/generate/generators.h"
#include "common/scene/layout.h"

namespace twintrace {

namespace {

/// Slack of a sum that was authored as 1: both colours are rounded to float, each by at most 2^-25
/// since it is below 1.
constexpr double kSumSlack = 1.0 / (1 << 24);

void checkEnergy(TableReader& table, const Material& material) {
  constexpr std::array<std::string_view, 3> kChannels = {"red", "green", "blue"};
  for (int i = 0; i < 3; ++i) {
    const double sum = static_cast<double>(material.albedo[i]) + material.specular[i];
    if (sum <= 1 + kSumSlack) continue;
    table.faults().add(table.position(),
                       fmt::format("albedo + specular = {:.6g} in {} of material {}", sum,
                                   kChannels[static_cast<std::size_t>(i)], quote(material.name)),
                       "at most 1 (a surface can't reflect more than it receives)");
    return;
  }
}

Material readMaterial(TableReader& table, std::string name) {
  Material material;
  material.name = std::move(name);
  table.read("albedo", material.albedo, kNotNegative);
  table.read("specular", material.specular, kNotNegative);
  table.read("emission", material.emission, kNotNegative);
  table.read("ambient", material.ambient, kNotNegative);
  table.read("highlight", material.highlight, kNotNegative);
  table.read("exponent", material.exponent, kNotNegative);
  table.read("roughness", material.roughness, kUnitInterval);
  std::string lobe;
  if (table.readWord("lobe", lobe, {"ggx", "phong"}) && lobe == "phong") {
    material.lobe = Lobe::phong;
  }
  table.finish();
  checkEnergy(table, material);
  return material;
}

SphereShape readSphere(TableReader& table) {
  SphereShape sphere;
  table.read("center", sphere.center, kAnyNumber, Need::required);
  table.read("radius", sphere.radius, kPositiveLength, Need::required);
  return sphere;
}

bool isZero(const glm::vec3& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

void readCenterAndSize(TableReader& table, BoxShape& box) {
  glm::vec3 center(box.center);
  glm::vec3 size(box.size);
  table.read("center", center, kAnyNumber, Need::required);
  const bool hasSize = table.read("size", size, kNotNegative, Need::required);
  box.center = center;
  box.size = size;
  if (hasSize && isZero(size)) {
    table.faults().add(table.positionOf("size"), "size [0, 0, 0]",
                       "a size above 0 on at least one axis");
  }
}

bool inOrder(const glm::vec3& minimum, const glm::vec3& maximum) {
  return minimum.x <= maximum.x && minimum.y <= maximum.y && minimum.z <= maximum.z;
}

void readMinAndMax(TableReader& table, BoxShape& box) {
  glm::vec3 minimum{0.0f};
  glm::vec3 maximum{0.0f};
  const bool hasMinimum = table.read("min", minimum, kAnyNumber, Need::required);
  const bool hasMaximum = table.read("max", maximum, kAnyNumber, Need::required);
  if (!hasMinimum || !hasMaximum) return;
  if (!inOrder(minimum, maximum) || minimum == maximum) {
    table.faults().add(table.positionOf("max"), "max below min on an axis, or equal on all",
                       "max >= min on each axis, and above it on at least one");
    return;
  }
  box.center = (glm::dvec3(minimum) + glm::dvec3(maximum)) * 0.5;
  box.size = glm::dvec3(maximum) - glm::dvec3(minimum);
}

/// Keys of the other way to give a box; they must not pass as unknown, since they are known ones.
void rejectMixture(TableReader& table) {
  for (const std::string_view key : {"center", "size"}) {
    if (table.find(key, "", Need::optional) == nullptr) continue;
    table.faults().add(table.keyPositionOf(key), quote(key) + " beside 'min' or 'max'",
                       "either 'center' and 'size' or 'min' and 'max'");
  }
}

BoxShape readBox(TableReader& table) {
  BoxShape box;
  if (table.has("min") || table.has("max")) {
    rejectMixture(table);
    readMinAndMax(table, box);
  } else {
    readCenterAndSize(table, box);
    table.find("min", "", Need::optional);
    table.find("max", "", Need::optional);
  }
  glm::vec3 rotation{0.0f};
  if (table.read("rotation", rotation, kAnyNumber)) box.rotation = rotation;
  return box;
}

PlaneShape readPlane(TableReader& table) {
  PlaneShape plane;
  table.read("point", plane.point, kAnyNumber, Need::required);
  table.readDirection("normal", plane.normal, Need::required);
  return plane;
}

Placement readPlacement(TableReader& table) {
  Placement placement;
  table.read("scale", placement.scale, kPositiveLength);
  table.read("rotation", placement.rotation, kAnyNumber);
  table.read("translation", placement.translation, kAnyNumber);
  return placement;
}

MeshShape readMesh(TableReader& table, const FileCheck& check) {
  MeshShape mesh;
  std::string file;
  if (table.read("file", file, "the name of a mesh file (OBJ, PLY, glTF or NFF)", Need::required)) {
    const std::filesystem::path folder = std::filesystem::path(table.faults().path()).parent_path();
    mesh.file = (folder / file).string();
    if (!check(mesh.file)) {
      table.faults().add(table.positionOf("file"), "no file " + quote(file),
                         "a readable mesh file");
    }
  }
  std::int64_t part = 0;
  if (table.read("part", part, 0, std::numeric_limits<int>::max())) {
    mesh.part = static_cast<int>(part);
  }
  mesh.placement = readPlacement(table);
  table.read("smooth", mesh.smooth);
  return mesh;
}

std::vector<std::string> generatorNames() {
  std::vector<std::string> names;
  for (const Generator& generator : generators()) names.emplace_back(generator.name);
  return names;
}

GeneratedShape readGenerated(TableReader& table) {
  GeneratedShape shape;
  std::int64_t size = 0;
  if (table.readWord("generator", shape.generator, generatorNames(), Need::required)) {
    const Generator& generator = *findGenerator(shape.generator);
    table.read("size", size, generator.smallest, generator.largest, Need::required);
  } else {
    table.find("size", "an integer", Need::optional);
  }
  shape.size = static_cast<int>(size);
  std::int64_t seed = shape.seed;
  table.read("seed", seed, 0, std::numeric_limits<std::uint32_t>::max());
  shape.seed = static_cast<std::uint32_t>(seed);
  shape.placement = readPlacement(table);
  return shape;
}

void readShape(TableReader& table, const std::string& shape, const FileCheck& check,
               Object& object) {
  if (shape == "sphere") object.shape = readSphere(table);
  if (shape == "box") object.shape = readBox(table);
  if (shape == "plane") object.shape = readPlane(table);
  if (shape == "mesh") object.shape = readMesh(table, check);
  if (shape == "generate") object.shape = readGenerated(table);
}

/// Materials by name, for objects.
struct MaterialIndex {
  std::map<std::string, int> indices;
  std::vector<std::string> names;
};

MaterialIndex indexMaterials(const Scene& scene) {
  MaterialIndex index;
  for (const Material& material : scene.materials) {
    index.indices[material.name] = static_cast<int>(index.names.size());
    index.names.push_back(material.name);
  }
  return index;
}

std::string expectedMaterial(const MaterialIndex& index, const std::string& name) {
  if (index.names.empty()) return "a material, of which the file has none ([materials.NAME])";
  const std::string_view many = index.names.size() > 1 ? "one of the materials " : "the material ";
  return std::string(many) + oneOf(index.names) + didYouMean(name, index.names);
}

void readObjectMaterial(TableReader& table, const MaterialIndex& index, Object& object) {
  std::string name;
  if (!table.read("material", name, "the name of a material", Need::required)) return;
  const auto found = index.indices.find(name);
  if (found == index.indices.end()) {
    table.faults().add(table.positionOf("material"), "material " + quote(name),
                       expectedMaterial(index, name));
    return;
  }
  object.material = found->second;
}

/// Where each object's name was given first.
using NameLines = std::map<std::string, toml::source_position>;

void checkUnique(TableReader& table, const Object& object, NameLines& lines) {
  const toml::source_position at = table.positionOf("name");
  const auto [first, isNew] = lines.emplace(object.name, at);
  if (isNew) return;
  table.faults().add(at,
                     fmt::format("a second object named {} (the first is in line {})",
                                 quote(object.name), first->second.line),
                     "a name of its own");
}

/// A generator alone keeps to the limit by its largest size; many together must too.
void checkGenerated(TableReader& table, const Object& object, std::int64_t& generated) {
  const auto* shape = std::get_if<GeneratedShape>(&object.shape);
  if (shape == nullptr || shape->generator.empty()) return;
  const bool fitted = generated <= kMaxGenerated;
  generated += findGenerator(shape->generator)->primitives(shape->size);
  if (!fitted || generated <= kMaxGenerated) return;
  table.faults().add(table.positionOf("size"),
                     fmt::format("{} generated primitives up to here", generated),
                     fmt::format("at most {}", kMaxGenerated));
}

Object readObject(TableReader& table, const MaterialIndex& materials, const FileCheck& check,
                  std::size_t index) {
  Object object;
  const toml::source_position at = table.position();
  object.location = {table.faults().path(), static_cast<int>(at.line), static_cast<int>(at.column)};
  std::string shape;
  const bool known = table.readWord("shape", shape, {"sphere", "box", "plane", "mesh", "generate"},
                                    Need::required);
  if (!table.read("name", object.name, "a name without control characters")) {
    object.name = fmt::format("{}-{}", shape, index);
  }
  readObjectMaterial(table, materials, object);
  readShape(table, shape, check, object);
  // Which keys belong here is unknown without a shape.
  if (known) table.finish();
  return object;
}

PointLight readPointLight(TableReader& table) {
  PointLight light;
  table.read("position", light.position, kAnyNumber, Need::required);
  table.read("intensity", light.intensity, kNotNegative, Need::required);
  return light;
}

SphereLight readSphereLight(TableReader& table) {
  SphereLight light;
  table.read("position", light.position, kAnyNumber, Need::required);
  table.read("radius", light.radius, kPositiveLength, Need::required);
  table.read("intensity", light.intensity, kNotNegative, Need::required);
  return light;
}

SunLight readSunLight(TableReader& table) {
  SunLight light;
  table.readDirection("direction", light.direction, Need::required);
  table.read("irradiance", light.irradiance, kNotNegative, Need::required);
  table.read("angle", light.angle, kHalfTurn);
  return light;
}

Light readLight(TableReader& table) {
  Light light;
  std::string kind;
  if (!table.readWord("kind", kind, {"point", "sphere", "sun"}, Need::required)) return light;
  if (kind == "point") light = readPointLight(table);
  if (kind == "sphere") light = readSphereLight(table);
  if (kind == "sun") light = readSunLight(table);
  table.finish();
  return light;
}

}  // namespace

void readMaterials(TableReader& document, std::vector<Material>& materials) {
  const toml::table* content = document.readTable("materials");
  if (content == nullptr) return;
  for (const auto& [key, node] : *content) {
    const std::string name(key.str());
    if (!node.is_table()) {
      document.faults().add(node.source().begin, describe(node) + " for material " + quote(name),
                            "a table, headed [materials.NAME]");
      continue;
    }
    TableReader table(*node.as_table(), key.source().begin, document.faults());
    materials.push_back(readMaterial(table, name));
  }
}

void readObjects(TableReader& document, const FileCheck& check, Scene& scene) {
  const MaterialIndex materials = indexMaterials(scene);
  NameLines lines;
  std::int64_t generated = 0;
  for (const toml::table* content : document.readTables("objects")) {
    TableReader table(*content, content->source().begin, document.faults());
    scene.objects.push_back(readObject(table, materials, check, scene.objects.size()));
    checkUnique(table, scene.objects.back(), lines);
    checkGenerated(table, scene.objects.back(), generated);
  }
}

void readLights(TableReader& document, std::vector<Light>& lights) {
  const std::vector<const toml::table*> tables = document.readTables("lights");
  constexpr auto kLimit = static_cast<std::size_t>(layout::kMaxLights);
  if (tables.size() > kLimit) {
    document.faults().add(tables[kLimit]->source().begin, fmt::format("{} lights", tables.size()),
                          fmt::format("at most {} lights", kLimit));
  }
  for (const toml::table* content : tables) {
    TableReader table(*content, content->source().begin, document.faults());
    lights.push_back(readLight(table));
  }
}

}  // namespace twintrace
