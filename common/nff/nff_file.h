#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/generate/parts.h"

namespace twintrace {

/// The camera of an NFF file.
struct NffView {
  glm::dvec3 from{0.0};
  glm::dvec3 at{0.0};
  glm::dvec3 up{0.0};
  double angle = 0.0;  ///< degrees, between the centres of the outermost rows or columns of pixels
  int width = 512;
  int height = 512;
};

struct NffLight {
  glm::vec3 position{0.0f};
  std::optional<glm::vec3> color;
};

/// How a surface looks.
struct NffFill {
  glm::vec3 color{0.0f};
  float diffuse = 0.0f;   ///< Kd, times the colour
  float specular = 0.0f;  ///< Ks, white
  float shine = 0.0f;     ///< exponent of the highlight's cosine
  float transmittance = 0.0f;
  float ior = 0.0f;

  bool operator==(const NffFill&) const = default;
};

/// All surfaces of one fill. Its mesh has normals at the vertices.
struct NffPart {
  NffFill fill;
  Parts parts;
  bool curved = false;  ///< whether these normals are more than those of flat polygons
};

/// What an NFF file says.
struct NffFile {
  std::optional<NffView> view;
  glm::vec3 background{0.0f};
  std::vector<NffLight> lights;
  std::vector<NffPart> parts;         ///< by fill, in the order in which the file names the fills
  std::vector<std::string> warnings;  ///< what is odd but harmless, or not quite as the file says
};

/// Whether a file's name ends in .nff.
bool isNffName(std::string_view path);

/// Reads a file in the Neutral File Format of Haines' Standard Procedural Databases (1987):
/// spheres, polygons, patches with normals; cones and cylinders become meshes.
/// @throws IoError if it can't be read; FileError with what is wrong in it
NffFile readNff(const std::string& path);

/// Reads the text of such a file.
/// @param path for messages
/// @throws FileError with what is wrong in it
NffFile parseNff(std::string_view text, const std::string& path);

}  // namespace twintrace
