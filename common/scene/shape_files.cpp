#include "common/scene/shape_files.h"

#include <fmt/format.h>

#include "common/base/error.h"
#include "common/base/wording.h"

namespace twintrace {
namespace {

void append(Mesh& mesh, const Mesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  for (const Corners& c : more.triangles) {
    mesh.triangles.push_back({first + c[0], first + c[1], first + c[2]});
  }
}

void append(Parts& parts, const Parts& more) {
  parts.spheres.insert(parts.spheres.end(), more.spheres.begin(), more.spheres.end());
  append(parts.mesh, more.mesh);
}

}  // namespace

Parts ShapeFiles::load(const MeshShape& shape, std::vector<std::string>& warnings) {
  if (isNffName(shape.file)) return loadNff(shape, warnings);
  LoadedMesh loaded = meshFile(shape.file).load(shape.smooth, shape.part);
  for (const std::string& warning : loaded.warnings) {
    warnings.push_back(fmt::format("{}: {}", shape.file, warning));
  }
  Parts parts;
  parts.mesh = std::move(loaded.mesh);
  return parts;
}

Parts ShapeFiles::loadNff(const MeshShape& shape, std::vector<std::string>& warnings) {
  const NffFile& file = nffFile(shape.file, warnings);
  const int count = static_cast<int>(file.parts.size());
  if (shape.part && *shape.part >= count) throw MeshError(noPart(*shape.part, shape.file, count));
  Parts parts;
  for (int i = 0; i < count; ++i) {
    if (shape.part.value_or(i) == i) append(parts, file.parts[static_cast<std::size_t>(i)].parts);
  }
  if (!shape.smooth) parts.mesh.normals.clear();
  if (!parts.spheres.empty() || !parts.mesh.triangles.empty()) return parts;
  throw MeshError("found no surface in " + quote(shape.file) + ", expected at least one");
}

const NffFile& ShapeFiles::nffFile(const std::string& path, std::vector<std::string>& warnings) {
  const auto [entry, isNew] = nffFiles_.try_emplace(path);
  if (isNew) {
    try {
      entry->second = std::make_unique<const NffFile>(readNff(path));
    } catch (const IoError&) {
      throw MeshError("found mesh file " + quote(path) +
                      " that can't be read, expected a sound one");
    }
    for (const std::string& warning : entry->second->warnings) {
      warnings.push_back(fmt::format("{}: {}", path, warning));
    }
  }
  if (entry->second == nullptr) {
    throw MeshError("found faulty mesh file " + quote(path) + " again, expected a sound one");
  }
  return *entry->second;
}

const MeshFile& ShapeFiles::meshFile(const std::string& path) {
  auto& file = meshFiles_[path];
  if (file == nullptr) file = std::make_unique<const MeshFile>(path);
  return *file;
}

}  // namespace twintrace
