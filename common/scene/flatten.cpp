#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "common/base/error.h"
#include "common/film/image_io.h"
#include "common/generate/parts.h"
#include "common/hulls/hull_structure.h"
#include "common/scene/flat_scene.h"
#include "common/scene/layout.h"
#include "common/scene/rotation.h"

namespace twintrace {
namespace {

std::uint32_t bits(float value) {
  std::uint32_t word;
  std::memcpy(&word, &value, sizeof word);
  return word;
}

glm::uvec4 texel(glm::vec3 v, float w = 0.0f) { return {bits(v.x), bits(v.y), bits(v.z), bits(w)}; }

glm::uvec4 texel(glm::vec3 v, int w) {
  return {bits(v.x), bits(v.y), bits(v.z), static_cast<std::uint32_t>(w)};
}

FlatCamera flattenCamera(const Camera& camera, int width, int height) {
  const glm::dvec3 eye(camera.eye);
  const glm::dvec3 view = glm::dvec3(camera.target) - eye;
  const double focus = camera.focus ? *camera.focus : glm::length(view);
  const glm::dvec3 forward = glm::normalize(view);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double filmHeight = 2.0 * focus * std::tan(glm::radians(double(camera.fov)) / 2.0);
  const double step = filmHeight / height;
  FlatCamera flat;
  flat.origin = camera.eye;
  flat.corner = glm::vec3(forward * focus - right * (step * width / 2.0) + up * (filmHeight / 2.0));
  flat.stepX = glm::vec3(right * step);
  flat.stepY = glm::vec3(up * -step);
  flat.lensX = glm::vec3(right * (camera.aperture / 2.0));
  flat.lensY = glm::vec3(up * (camera.aperture / 2.0));
  if (!(glm::length(glm::dvec3(flat.corner)) < 1e18)) {
    throw UsageError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels reaches beyond 1e18 at the focus distance, expected less");
  }
  return flat;
}

// Records of one kind of primitive, with the object of each.
struct KindRecords {
  std::vector<glm::uvec4> texels;
  std::vector<int> objects;
};

struct PrimitiveRecords {
  KindRecords spheres, boxes, orientedBoxes, triangles, planes;
  std::vector<glm::uvec4> normals;  // of smooth triangles
};

void addShape(PrimitiveRecords& records, const SphereShape& sphere, int object) {
  records.spheres.texels.push_back(texel(sphere.center, sphere.radius));
  records.spheres.objects.push_back(object);
}

void addShape(PrimitiveRecords& records, const BoxShape& box, int object) {
  if (!box.isTurned()) {
    records.boxes.texels.push_back(texel(glm::vec3(box.center - box.size * 0.5)));
    records.boxes.texels.push_back(texel(glm::vec3(box.center + box.size * 0.5)));
    records.boxes.objects.push_back(object);
    return;
  }
  const glm::dmat3 axes = rotationMatrix(*box.rotation);
  auto& texels = records.orientedBoxes.texels;
  texels.push_back(texel(glm::vec3(box.center)));
  for (int axis = 0; axis < 3; ++axis) texels.push_back(texel(glm::vec3(axes[axis])));
  texels.push_back(texel(glm::vec3(box.size * 0.5)));
  records.orientedBoxes.objects.push_back(object);
}

void addShape(PrimitiveRecords& records, const PlaneShape& plane, int object) {
  records.planes.texels.push_back(texel(plane.point));
  records.planes.texels.push_back(texel(glm::vec3(glm::normalize(glm::dvec3(plane.normal)))));
  records.planes.objects.push_back(object);
}

void addMesh(PrimitiveRecords& records, const Mesh& mesh, bool smooth, int object) {
  auto& texels = records.triangles.texels;
  for (const Corners& corners : mesh.triangles) {
    int smoothRecord = 0;
    if (smooth) {
      for (const std::uint32_t i : corners) records.normals.push_back(texel(mesh.normals[i]));
      smoothRecord = int(records.normals.size()) / layout::kSmoothTexels;
    }
    texels.push_back(texel(mesh.positions[corners[0]], smoothRecord));
    texels.push_back(texel(mesh.positions[corners[1]]));
    texels.push_back(texel(mesh.positions[corners[2]]));
    records.triangles.objects.push_back(object);
  }
}

void addParts(PrimitiveRecords& records, const Parts& parts, bool smooth, int object) {
  for (const SphereShape& sphere : parts.spheres) addShape(records, sphere, object);
  for (const BoxShape& box : parts.boxes) addShape(records, box, object);
  addMesh(records, parts.mesh, smooth, object);
}

void addShape(PrimitiveRecords& records, const MeshShape& mesh, int object) {
  addParts(records, *mesh.parts, mesh.smooth, object);
}

void addShape(PrimitiveRecords& records, const GeneratedShape& generated, int object) {
  addParts(records, *generated.parts, false, object);
}

// Appends one kind's records and returns where they start.
int append(FlatScene& flat, const std::vector<glm::uvec4>& records) {
  const int offset = static_cast<int>(flat.texels.size());
  flat.texels.insert(flat.texels.end(), records.begin(), records.end());
  return offset;
}

double mean(glm::vec3 colour) { return (double(colour.r) + colour.g + colour.b) / 3.0; }

int lobeCode(const Material& material) {
  if (material.specular == glm::vec3(0.0f)) return layout::kLobeNone;
  if (material.roughness < kMirrorRoughness) return layout::kLobeMirror;
  return material.lobe == Lobe::ggx ? layout::kLobeGgx : layout::kLobePhong;
}

// Layout: fetchScattering, fetchReflectance and fetchLocalShading of
// shaders/scene_access.glsl. The chance of a lobe is its share of the mean reflectance (the report's
// ancestor); the report's exponent is 1000^((1 - roughness)^2).
std::vector<glm::uvec4> materialRecord(const Material& material) {
  const double diffuse = mean(material.albedo);
  const double specular = mean(material.specular);
  const double chance = specular > 0.0 ? specular / (specular + diffuse) : 0.0;
  const glm::dvec3 albedo(material.albedo);
  const glm::dvec3 reflectance(material.specular);
  const glm::vec3 albedoWeight(chance < 1.0 ? albedo / (1.0 - chance) : glm::dvec3(0.0));
  const glm::vec3 specularWeight(chance > 0.0 ? reflectance / chance : glm::dvec3(0.0));
  const double smoothness = 1.0 - material.roughness;
  const double exponent = std::pow(1000.0, smoothness * smoothness);
  const float alpha = material.roughness * material.roughness;
  const glm::vec3 lobe(alpha, (exponent + 2.0) / (exponent + 1.0), 1.0 / (exponent + 1.0));
  return {texel(albedoWeight, float(chance)),
          texel(specularWeight, lobeCode(material)),
          texel(lobe, float(exponent)),
          texel(material.albedo),
          texel(material.specular),
          texel(material.ambient),
          texel(material.highlight, material.exponent)};
}

glm::uvec4 lightKind(int kind) { return {static_cast<std::uint32_t>(kind), 0u, 0u, 0u}; }

std::vector<glm::uvec4> lightRecord(const PointLight& light) {
  return {texel(light.position), texel(light.intensity), lightKind(layout::kLightPoint)};
}

std::vector<glm::uvec4> lightRecord(const SphereLight& light) {
  const double area = M_PI * double(light.radius) * light.radius;
  return {texel(light.position, light.radius), texel(glm::vec3(glm::dvec3(light.intensity) / area)),
          lightKind(layout::kLightSphere)};
}

// The record's radiance is radiance times solid angle, so that a sun of angle 0 needs no case of its
// own: irradiance E = L pi sin^2(a), hence L 2 pi (1 - cos a) = 2 E / (1 + cos a).
std::vector<glm::uvec4> lightRecord(const SunLight& light) {
  const double angle = glm::radians(double(light.angle)) / 2.0;
  const double height = 2.0 * std::pow(std::sin(angle / 2.0), 2.0);
  const glm::vec3 value(glm::dvec3(light.irradiance) * (2.0 / (1.0 + std::cos(angle))));
  const glm::vec3 towards(-glm::normalize(glm::dvec3(light.direction)));
  return {texel(towards), texel(value, float(height)), lightKind(layout::kLightSun)};
}

// The mean of an equirectangular image over the sphere: rows count by the solid angle they cover.
glm::vec3 meanRadiance(const Image& image) {
  glm::dvec3 sum(0.0);
  double weight = 0.0;
  for (int y = 0; y < image.height; ++y) {
    const double row = std::sin(M_PI * (y + 0.5) / image.height);
    for (int x = 0; x < image.width; ++x) {
      const float* p = &image.rgb[3 * (std::size_t(y) * image.width + x)];
      sum += row * glm::dvec3(p[0], p[1], p[2]);
    }
    weight += row * image.width;
  }
  return glm::vec3(sum / weight);
}

// The eq. 1 ambient radiance L_a of an image is its mean.
void flattenEnvironment(const Environment& environment, FlatScene& flat) {
  flat.environmentRadiance = environment.radiance;
  if (environment.image.empty()) return;
  Image image = readLinearImage(environment.image);
  for (float& value : image.rgb) value *= environment.strength;
  flat.environmentRadiance = meanRadiance(image);
  const double turns = environment.rotation / 360.0;
  flat.environmentTurn = float(turns - std::floor(turns));
  flat.index.environmentWidth = image.width;
  flat.index.environmentHeight = image.height;
  flat.index.environmentOffset = static_cast<int>(flat.texels.size());
  flat.texels.reserve(flat.texels.size() + image.rgb.size() / 3);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    flat.texels.push_back(texel({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}));
  }
}

void flattenPrimitives(const Scene& scene, FlatScene& flat) {
  PrimitiveRecords records;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    flat.objectNames.push_back(object.name);
    std::visit([&](const auto& shape) { addShape(records, shape, int(i)); }, object.shape);
  }
  SceneIndex& index = flat.index;
  index.sphereCount = int(records.spheres.objects.size());
  index.boxCount = int(records.boxes.objects.size());
  index.orientedBoxCount = int(records.orientedBoxes.objects.size());
  index.triangleCount = int(records.triangles.objects.size());
  index.planeCount = int(records.planes.objects.size());
  index.sphereOffset = append(flat, records.spheres.texels);
  index.boxOffset = append(flat, records.boxes.texels);
  index.orientedBoxOffset = append(flat, records.orientedBoxes.texels);
  index.triangleOffset = append(flat, records.triangles.texels);
  index.smoothOffset = append(flat, records.normals);
  index.smoothCount = int(records.normals.size()) / layout::kSmoothTexels;
  index.planeOffset = append(flat, records.planes.texels);
  index.infoOffset = static_cast<int>(flat.texels.size());
  for (const KindRecords* kind :
       {&records.spheres, &records.boxes, &records.orientedBoxes, &records.triangles,
        &records.planes}) {
    for (const int object : kind->objects) {
      flat.primitiveObject.push_back(object);
      const int material = scene.objects[object].material;
      flat.texels.push_back(texel(scene.materials[material].emission, material));
    }
  }
  // A ray that misses everything reads record 0 and drops it: there must be one.
  if (flat.primitiveObject.empty()) flat.texels.emplace_back(0u);
}

void flattenMaterials(const Scene& scene, FlatScene& flat) {
  flat.index.materialOffset = static_cast<int>(flat.texels.size());
  flat.index.materialCount = static_cast<int>(scene.materials.size());
  for (const Material& material : scene.materials) append(flat, materialRecord(material));
  if (!scene.materials.empty()) return;
  append(flat, materialRecord(Material{}));
  flat.index.materialCount = 1;
}

void flattenLights(const Scene& scene, FlatScene& flat) {
  flat.index.lightOffset = static_cast<int>(flat.texels.size());
  flat.index.lightCount = static_cast<int>(scene.lights.size());
  for (const Light& light : scene.lights) {
    append(flat, std::visit([](const auto& l) { return lightRecord(l); }, light));
  }
}

}  // namespace

FlatScene flatten(const Scene& authored, const RenderOptions& options) {
  FlatScene flat;
  flat.effects = chosenEffects(authored, options);
  const Scene scene = withoutEffects(authored, flat.effects);
  flat.width = options.width;
  flat.height = options.height;
  if (flat.width < 1 || flat.height < 1 || std::int64_t{flat.width} * flat.height > kMaxPixels) {
    throw UsageError("film of " + std::to_string(flat.width) + " x " + std::to_string(flat.height) +
                     " pixels, expected 1 to 2^28 in all");
  }
  flat.camera = flattenCamera(scene.camera, flat.width, flat.height);
  flattenPrimitives(scene, flat);
  flattenMaterials(scene, flat);
  flattenLights(scene, flat);
  flattenEnvironment(scene.environment, flat);
  flat.hulls = chosenHulls(flat, options);
  return flat;
}

std::string sceneHash(const FlatScene& scene) {
  XXH3_state_t* state = XXH3_createState();
  XXH3_128bits_reset(state);
  const auto add = [&](const void* data, std::size_t size) {
    XXH3_128bits_update(state, data, size);
  };
  add(&scene.width, sizeof scene.width);
  add(&scene.height, sizeof scene.height);
  add(&scene.camera, sizeof scene.camera);
  add(&scene.index, sizeof scene.index);
  add(&scene.environmentRadiance, sizeof scene.environmentRadiance);
  add(&scene.environmentTurn, sizeof scene.environmentTurn);
  add(scene.texels.data(), scene.texels.size() * sizeof(glm::uvec4));
  const XXH128_hash_t hash = XXH3_128bits_digest(state);
  XXH3_freeState(state);
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text;
}

}  // namespace twintrace
