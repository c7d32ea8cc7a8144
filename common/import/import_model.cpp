#include "common/import/import_model.h"

#include <assimp/scene.h>
#include <assimp/version.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "common/base/wording.h"
#include "common/import/adapt.h"
#include "common/mesh/load_mesh.h"
#include "common/scene/layout.h"

namespace twintrace {
namespace {

constexpr int kHeight = 512;
constexpr double kWidestFilm = 8.0;  // by its height

glm::vec3 toGlm(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

/// Negative and undefined amounts mean nothing.
glm::vec3 toGlm(const aiColor3D& color) {
  const auto amount = [](float value) { return value > 0.0f && value <= 1e18f ? value : 0.0f; };
  return {amount(color.r), amount(color.g), amount(color.b)};
}

std::optional<glm::vec3> colorOf(const aiMaterial& material, const char* key, unsigned int type,
                                 unsigned int index) {
  aiColor3D color;
  if (material.Get(key, type, index, color) != aiReturn_SUCCESS) return std::nullopt;
  return toGlm(color);
}

std::optional<float> numberOf(const aiMaterial& material, const char* key, unsigned int type,
                              unsigned int index) {
  float value = 0.0f;
  if (material.Get(key, type, index, value) != aiReturn_SUCCESS) return std::nullopt;
  return std::isfinite(value) ? value : 0.0f;
}

/// glTF's metals and dielectrics; the few per cent that a dielectric reflects are left out.
void takeMetallic(const aiMaterial& from, float metallic, Material& material) {
  const glm::vec3 base = colorOf(from, AI_MATKEY_BASE_COLOR).value_or(glm::vec3(1.0f));
  const float metal = std::clamp(metallic, 0.0f, 1.0f);
  material.albedo = base * (1.0f - metal);
  material.specular = base * metal;
  material.roughness =
      std::clamp(numberOf(from, AI_MATKEY_ROUGHNESS_FACTOR).value_or(1.0f), 0.0f, 1.0f);
}

void takePhong(const aiMaterial& from, Material& material) {
  material.albedo = colorOf(from, AI_MATKEY_COLOR_DIFFUSE).value_or(glm::vec3(0.0f));
  material.specular = colorOf(from, AI_MATKEY_COLOR_SPECULAR).value_or(glm::vec3(0.0f));
  material.ambient = colorOf(from, AI_MATKEY_COLOR_AMBIENT).value_or(glm::vec3(0.0f));
  material.highlight = material.specular;
  material.exponent = std::max(numberOf(from, AI_MATKEY_SHININESS).value_or(0.0f), 0.0f);
  material.lobe = Lobe::phong;
  material.roughness = roughnessOfExponent(material.exponent);
}

Material materialOf(const aiMaterial& from) {
  Material material;
  material.name = from.GetName().C_Str();
  if (const auto metallic = numberOf(from, AI_MATKEY_METALLIC_FACTOR)) {
    takeMetallic(from, *metallic, material);
  } else {
    takePhong(from, material);
  }
  material.emission = colorOf(from, AI_MATKEY_COLOR_EMISSIVE).value_or(glm::vec3(0.0f));
  return material;
}

bool hasTextures(const aiMaterial& material) {
  for (int type = aiTextureType_DIFFUSE; type <= AI_TEXTURE_TYPE_MAX; ++type) {
    if (material.GetTextureCount(static_cast<aiTextureType>(type)) > 0) return true;
  }
  return false;
}

bool letsLightThrough(const aiMaterial& material) {
  return numberOf(material, AI_MATKEY_OPACITY).value_or(1.0f) < 1.0f ||
         numberOf(material, AI_MATKEY_TRANSMISSION_FACTOR).value_or(0.0f) > 0.0f;
}

/// A glTF camera's vertical angle, which assimp makes a horizontal one: until 5.2 by the ratio of
/// the sides, which is wrong (assimp issue 4435), and not at all where the file gives no ratio.
double verticalAngle(const aiCamera& camera) {
  const double angle = camera.mHorizontalFOV;
  if (!(camera.mAspect > 0.0f)) return angle;
  const bool before53 =
      aiGetVersionMajor() < 5 || (aiGetVersionMajor() == 5 && aiGetVersionMinor() < 3);
  if (before53) return angle / camera.mAspect;
  return 2.0 * std::atan(std::tan(angle / 2.0) / camera.mAspect);
}

class ModelImport {
 public:
  explicit ModelImport(const std::string& path) : path_(path), mesh_(path) {
    // Cameras and lights want their nodes, which reading the mesh does away with.
    file_ = importer_.ReadFile(path, 0);
    if (file_ == nullptr) throw MeshError("found " + quote(importer_.GetErrorString()));
    scene_.file = path;
  }

  ImportedScene run() {
    for (int part = 0; part < mesh_.partCount(); ++part) addPart(part);
    if (scene_.parts.empty() && !firstFault_.empty()) throw MeshError(firstFault_);
    if (scene_.parts.empty()) {
      throw MeshError("found no triangle in " + quote(path_) + ", expected at least one");
    }
    finishMaterials();
    addLights();
    addCamera();
    return std::move(scene_);
  }

 private:
  /// A part that is no use is left out, unless there is no other.
  void addPart(int number) {
    const auto index = static_cast<unsigned int>(number);
    if (!hasFaces(index)) return;
    const aiMaterial& from = *file_->mMaterials[index];
    ImportedPart part{materialOf(from), number, hasNormals(index)};
    try {
      addSurfaces(number, part.material.name);
    } catch (const MeshError& error) {
      if (firstFault_.empty()) firstFault_ = error.what();
      scene_.notes.push_back("left out: " + std::string(error.what()));
      return;
    }
    textured_ += hasTextures(from) ? 1 : 0;
    transmitting_ += letsLightThrough(from) ? 1 : 0;
    scene_.parts.push_back(std::move(part));
  }

  void addSurfaces(int number, const std::string& name) {
    Parts parts;
    LoadedMesh loaded = mesh_.load(false, number);
    parts.mesh = std::move(loaded.mesh);
    for (const std::string& warning : loaded.warnings) {
      scene_.notes.push_back(quote(name) + ": " + warning);
    }
    surroundings_.add(parts);
    scene_.triangleCount += static_cast<std::int64_t>(parts.mesh.triangles.size());
  }

  template <class Test>
  bool anyMesh(unsigned int material, const Test& test) const {
    return std::any_of(file_->mMeshes, file_->mMeshes + file_->mNumMeshes, [&](const aiMesh* mesh) {
      return mesh->mMaterialIndex == material && test(*mesh);
    });
  }

  bool hasFaces(unsigned int material) const {
    return anyMesh(material, [](const aiMesh& mesh) {
      return std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                         [](const aiFace& face) { return face.mNumIndices >= 3; });
    });
  }

  bool hasNormals(unsigned int material) const {
    return !anyMesh(material, [](const aiMesh& mesh) { return !mesh.HasNormals(); });
  }

  void finishMaterials() {
    std::vector<Material*> materials;
    std::vector<double> sums;
    for (ImportedPart& part : scene_.parts) {
      materials.push_back(&part.material);
      sums.push_back(fitEnergy(part.material));
    }
    makeNamesUnique(materials);
    if (const std::string note = energyNote(sums); !note.empty()) scene_.notes.push_back(note);
    if (textured_ > 0) {
      scene_.notes.push_back(counted(textured_, "material has textures, which are left out",
                                     "materials have textures, which are left out"));
    }
    if (transmitting_ > 0) {
      scene_.notes.push_back(counted(transmitting_,
                                     "material lets light through, here it is opaque",
                                     "materials let light through, here they are opaque"));
    }
  }

  aiMatrix4x4 placeOf(const aiString& node) const {
    aiMatrix4x4 place;
    for (const aiNode* at = file_->mRootNode->FindNode(node); at != nullptr; at = at->mParent) {
      place = at->mTransformation * place;
    }
    return place;
  }

  /// The first one; only glTF has any.
  void addCamera() {
    if (file_->mNumCameras == 0) {
      scene_.camera = framing(surroundings_);
      scene_.notes.emplace_back("no camera: this one sees all of it from the front");
      return;
    }
    const aiCamera& from = *file_->mCameras[0];
    const aiMatrix4x4 place = placeOf(from.mName);
    const aiMatrix3x3 turn(place);
    // A glTF camera is at its node's origin; assimp gives it the node's translation as well.
    const glm::vec3 eye(place.a4, place.b4, place.c4);
    const double distance =
        std::max(glm::length(surroundings_.center() - glm::dvec3(eye)), surroundings_.radius());
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(toGlm(turn * from.mLookAt)));
    scene_.camera.eye = eye;
    scene_.camera.target = glm::vec3(glm::dvec3(eye) + ahead * distance);
    scene_.camera.up = toGlm(turn * from.mUp);
    scene_.camera.fov = float(glm::degrees(verticalAngle(from)));
    if (from.mAspect > 0.0f) {
      const double width = kHeight * std::clamp(double(from.mAspect), 1.0 / kHeight, kWidestFilm);
      scene_.width = int(std::lround(width));
      scene_.height = kHeight;
    }
    if (file_->mNumCameras > 1) {
      scene_.notes.push_back(
          fmt::format("{} cameras, of which the first is taken", file_->mNumCameras));
    }
  }

  void addLights() {
    for (unsigned int i = 0; i < file_->mNumLights; ++i) addLight(*file_->mLights[i]);
    if (otherLights_ > 0) {
      scene_.notes.push_back(counted(otherLights_, "light is no point or sun and left out",
                                     "lights are no points or suns and left out"));
    }
    const bool shines = std::ranges::any_of(scene_.parts, [](const ImportedPart& part) {
      return part.material.emission != glm::vec3(0.0f);
    });
    if (!scene_.lights.empty() || shines) return;
    // Enough to see shapes: a white surface that faces the sun has radiance 1.1.
    scene_.background = glm::vec3(0.5f);
    scene_.lights.emplace_back(SunLight{{-0.5f, -1.0f, -0.7f}, glm::vec3(2.0f), 0.0f});
    scene_.notes.emplace_back("no light: a sun and a grey environment are added");
  }

  void addLight(const aiLight& from) {
    const aiMatrix4x4 place = placeOf(from.mName);
    const glm::vec3 amount = toGlm(from.mColorDiffuse);
    if (scene_.lights.size() == static_cast<std::size_t>(layout::kMaxLights)) {
      ++otherLights_;
    } else if (from.mType == aiLightSource_POINT) {
      scene_.lights.emplace_back(PointLight{toGlm(place * from.mPosition), amount});
    } else if (from.mType == aiLightSource_DIRECTIONAL) {
      const glm::vec3 direction = toGlm(aiMatrix3x3(place) * from.mDirection);
      scene_.lights.emplace_back(SunLight{direction, amount, 0.0f});
    } else {
      ++otherLights_;
    }
  }

  std::string path_;
  MeshFile mesh_;
  Assimp::Importer importer_;
  const aiScene* file_ = nullptr;  ///< the importer's
  ImportedScene scene_;
  Surroundings surroundings_;
  std::string firstFault_;  ///< of a part
  std::int64_t textured_ = 0;
  std::int64_t transmitting_ = 0;
  std::int64_t otherLights_ = 0;
};

}  // namespace

ImportedScene importModel(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw IoError("can't read " + path);
  try {
    return ModelImport(path).run();
  } catch (const MeshError& fault) {
    throw FileError(path, fault.what());
  }
}

}  // namespace twintrace
