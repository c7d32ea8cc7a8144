#include "common/mesh/load_mesh.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/geometric.hpp>
#include <span>

#include "common/base/wording.h"
#include "common/mesh/check_ply.h"

namespace twintrace {
namespace {

const std::vector<std::string> kEndings = {".obj", ".ply", ".gltf", ".glb"};
/// As of all numbers in scenes: squares of lengths stay within floats.
constexpr float kMaxCoordinate = 1e18f;

/// The ending in lower case. @throws MeshError if it is none that is known.
std::string endingOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  if (std::ranges::find(kEndings, ending) != kEndings.end()) return ending;
  std::vector<std::string> all = kEndings;
  all.emplace_back(".nff");
  throw MeshError("found mesh file " + quote(path) + ", expected one that ends in " + oneOf(all));
}

std::span<const aiMesh* const> meshesOf(const aiScene& scene) {
  return {scene.mMeshes, scene.mNumMeshes};
}

std::span<const aiFace> facesOf(const aiMesh& mesh) {
  return {mesh.mFaces, mesh.mNumFaces};
}

bool isUsable(const aiVector3D& p) {
  return std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate &&
         std::abs(p.z) <= kMaxCoordinate;
}

void checkVertices(const aiScene& scene, const std::string& path) {
  std::int64_t bad = 0;
  for (const aiMesh* mesh : meshesOf(scene)) {
    bad += std::ranges::count_if(std::span(mesh->mVertices, mesh->mNumVertices),
                                 std::not_fn(isUsable));
  }
  if (bad == 0) return;
  throw MeshError(
      fmt::format("found {} in {} with coordinates that are not finite or beyond 1e18, "
                  "expected finite ones",
                  counted(bad, "vertex", "vertices"), quote(path)));
}

std::span<const unsigned int> indicesOf(const aiFace& face) {
  return {face.mIndices, face.mNumIndices};
}

void checkIndices(const aiScene& scene, const std::string& path) {
  std::int64_t bad = 0;
  for (const aiMesh* mesh : meshesOf(scene)) {
    const auto isOutside = [&](unsigned int i) { return i >= mesh->mNumVertices; };
    bad += std::ranges::count_if(facesOf(*mesh), [&](const aiFace& face) {
      return face.mNumIndices == 0 || std::ranges::any_of(indicesOf(face), isOutside);
    });
  }
  if (bad == 0) return;
  throw MeshError(
      fmt::format("found {} in {} without vertices or with some that are not there, "
                  "expected indices of vertices that are",
                  counted(bad, "face", "faces"), quote(path)));
}

void checkFaces(const aiScene& scene, const std::string& path) {
  const auto isSurface = [](const aiFace& face) { return face.mNumIndices >= 3; };
  const auto hasSurface = [&](const aiMesh* mesh) {
    return std::ranges::any_of(facesOf(*mesh), isSurface);
  };
  if (std::ranges::any_of(meshesOf(scene), hasSurface)) return;
  throw MeshError("found no triangle in " + quote(path) + ", expected at least one");
}

const aiScene& orFault(const aiScene* scene, const Assimp::Importer& importer,
                       const std::string& path) {
  if (scene != nullptr) return *scene;
  throw MeshError(fmt::format("found mesh file {} that can't be read ({}), expected a sound one",
                              quote(path), importer.GetErrorString()));
}

/// In two steps, since the second one crashes on what the checks in between find.
const aiScene& readFile(Assimp::Importer& importer, const std::string& path) {
  const aiScene& asWritten = orFault(importer.ReadFile(path, 0), importer, path);
  checkFaces(asWritten, path);
  checkIndices(asWritten, path);
  checkVertices(asWritten, path);
  // Points and lines are no surfaces.
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  constexpr unsigned int kSteps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                  aiProcess_PreTransformVertices | aiProcess_SortByPType;
  const aiScene& inPlace = orFault(importer.ApplyPostProcessing(kSteps), importer, path);
  checkVertices(inPlace, path);
  return inPlace;
}

glm::vec3 toGlm(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

/// The meshes of a part, or all.
std::vector<const aiMesh*> meshesOf(const aiScene& scene, std::optional<int> part) {
  std::vector<const aiMesh*> meshes;
  for (const aiMesh* mesh : meshesOf(scene)) {
    if (!part || mesh->mMaterialIndex == static_cast<unsigned int>(*part)) meshes.push_back(mesh);
  }
  return meshes;
}

void append(Mesh& mesh, const aiMesh& part, bool normals, bool coordinates) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (unsigned int i = 0; i < part.mNumVertices; ++i) {
    mesh.positions.push_back(toGlm(part.mVertices[i]));
    if (normals) mesh.normals.push_back(toGlm(part.mNormals[i]));
    if (!coordinates) continue;
    const aiVector3D& uv = part.mTextureCoords[0][i];
    mesh.textureCoordinates.emplace_back(uv.x, uv.y);
  }
  for (const aiFace& face : facesOf(part)) {
    if (face.mNumIndices != 3) continue;
    mesh.triangles.push_back(
        {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

bool hasNoArea(const Mesh& mesh, const Corners& corners) {
  const glm::dvec3 a(mesh.positions[corners[0]]);
  const glm::dvec3 b(mesh.positions[corners[1]]);
  const glm::dvec3 c(mesh.positions[corners[2]]);
  return glm::cross(b - a, c - a) == glm::dvec3(0.0);
}

/// Drops triangles without area, which no ray can hit.
void dropDegenerate(LoadedMesh& loaded) {
  const auto dropped = std::erase_if(loaded.mesh.triangles, [&](const Corners& corners) {
    return hasNoArea(loaded.mesh, corners);
  });
  if (dropped == 0) return;
  loaded.warnings.push_back(counted(static_cast<std::int64_t>(dropped),
                                    "triangle without area is left out",
                                    "triangles without area are left out"));
}

/// Unit normals, and means where the file's are no directions.
void repairNormals(Mesh& mesh) {
  Mesh means = mesh;
  bool computed = false;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const double length = glm::length(glm::dvec3(mesh.normals[i]));
    if (length > 0.0 && std::isfinite(length)) {
      mesh.normals[i] = glm::vec3(glm::dvec3(mesh.normals[i]) / length);
      continue;
    }
    if (!computed) addNormals(means);
    computed = true;
    mesh.normals[i] = means.normals[i];
  }
}

}  // namespace

struct MeshFile::Content {
  Assimp::Importer importer;
  const aiScene* scene = nullptr;  ///< the importer's
};

MeshFile::MeshFile(std::string path)
    : path_(std::move(path)), content_(std::make_unique<Content>()) {
  if (endingOf(path_) == ".ply") checkPly(path_);
  content_->scene = &readFile(content_->importer, path_);
}

MeshFile::~MeshFile() = default;

int MeshFile::partCount() const {
  return static_cast<int>(content_->scene->mNumMaterials);
}

LoadedMesh MeshFile::load(bool smooth, std::optional<int> part) const {
  if (part && *part >= partCount()) throw MeshError(noPart(*part, path_, partCount()));
  const std::vector<const aiMesh*> meshes = meshesOf(*content_->scene, part);
  const auto hasNormals = [](const aiMesh* mesh) { return mesh->HasNormals(); };
  const auto hasCoordinates = [](const aiMesh* mesh) { return mesh->HasTextureCoords(0); };
  const bool normals = smooth && std::ranges::all_of(meshes, hasNormals);
  const bool coordinates = std::ranges::all_of(meshes, hasCoordinates);
  LoadedMesh loaded;
  for (const aiMesh* mesh : meshes) append(loaded.mesh, *mesh, normals, coordinates);
  dropDegenerate(loaded);
  if (loaded.mesh.triangles.empty()) {
    throw MeshError("found no triangle in " + (part ? fmt::format("part {} of ", *part) : "") +
                    quote(path_) + ", expected at least one");
  }
  if (normals) repairNormals(loaded.mesh);
  if (smooth && !normals) addNormals(loaded.mesh);
  return loaded;
}

LoadedMesh loadMesh(const std::string& path, bool smooth) {
  return MeshFile(path).load(smooth, std::nullopt);
}

std::string noPart(int part, const std::string& path, int count) {
  return fmt::format("found part {} of {}, which has {}, expected a number below {}", part,
                     quote(path), counted(count, "part", "parts"), count);
}

}  // namespace twintrace
