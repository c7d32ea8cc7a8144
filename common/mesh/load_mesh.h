#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/mesh/mesh.h"

namespace twintrace {

/// A mesh file that is no use; the message says what was found and what was expected.
class MeshError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct LoadedMesh {
  Mesh mesh;
  std::vector<std::string> warnings;  ///< what is odd but harmless
};

/// An OBJ, PLY or glTF file, in memory.
class MeshFile {
 public:
  /// @throws MeshError for a file that is none of these or broken
  explicit MeshFile(std::string path);
  ~MeshFile();

  /// Its materials, which the triangles of a part have in common.
  int partCount() const;

  /// The triangles, in place and in one mesh; polygons are cut up.
  /// @param smooth whether vertices need normals: the file's, or means of the triangles' around
  /// them
  /// @param part only the triangles with this material
  /// @throws MeshError if there is no such part, if there is no triangle, or for vertices that are
  /// not finite or beyond 1e18
  LoadedMesh load(bool smooth, std::optional<int> part) const;

 private:
  struct Content;
  std::string path_;
  std::unique_ptr<Content> content_;
};

/// All triangles of a file. @throws MeshError as above
LoadedMesh loadMesh(const std::string& path, bool smooth);

/// For messages: the part that a file of so many doesn't have.
std::string noPart(int part, const std::string& path, int count);

/// Normals by vertex, each the mean of those of the triangles around it, weighted by their areas;
/// +y where they have none.
void addNormals(Mesh& mesh);

}  // namespace twintrace
