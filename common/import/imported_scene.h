#pragma once

#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace twintrace {

/// All surfaces of a file that share a material; an object of the scene.
struct ImportedPart {
  Material material;  ///< its name is the object's too
  int number = 0;     ///< `part` of the mesh
  bool smooth = false;
};

/// A scene made out of another program's file, to be written as a scene file. The surfaces stay
/// where they are.
struct ImportedScene {
  std::string file;  ///< with the surfaces
  int width = 512;
  int height = 512;
  Camera camera;
  std::string integrator;  ///< that the file is meant for; empty if it says nothing
  glm::vec3 background{0.0f};
  std::vector<ImportedPart> parts;
  std::vector<Light> lights;
  std::vector<std::string> notes;  ///< what is not quite as in the file
  std::int64_t sphereCount = 0;
  std::int64_t triangleCount = 0;
};

/// Reads an NFF, OBJ, PLY or glTF file with its camera, lights and materials, where it has them.
/// @throws IoError if it can't be read; FileError if it is no use
ImportedScene importScene(const std::string& path);

/// The scene file's text.
/// @param folder where it will be: the surfaces' file is named from there
std::string sceneText(const ImportedScene& scene, const std::string& folder);

}  // namespace twintrace
