#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/generate/parts.h"
#include "common/mesh/load_mesh.h"
#include "common/nff/nff_file.h"
#include "common/scene/shapes.h"

namespace twintrace {

/// The files that a scene's meshes are in. Each is read once, however many objects are parts of it.
class ShapeFiles {
 public:
  /// What a mesh shape stands for, without its placement.
  /// @param warnings gets what is odd but harmless
  /// @throws MeshError, or FileError for faults within an NFF file, for a file that is no use; a
  /// second time for the same file only MeshError
  Parts load(const MeshShape& shape, std::vector<std::string>& warnings);

 private:
  Parts loadNff(const MeshShape& shape, std::vector<std::string>& warnings);
  const NffFile& nffFile(const std::string& path, std::vector<std::string>& warnings);
  const MeshFile& meshFile(const std::string& path);

  std::map<std::string, std::unique_ptr<const NffFile>> nffFiles_;  ///< null for faulty ones
  std::map<std::string, std::unique_ptr<const MeshFile>> meshFiles_;
};

}  // namespace twintrace
