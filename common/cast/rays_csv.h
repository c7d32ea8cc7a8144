#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "common/trace/ray_caster.h"

namespace twintrace {

/// The rays of a Rays CSV.
struct RaysFile {
  std::vector<CastRay> rays;
  std::size_t nanRays = 0;  ///< rays with a NaN; each of them misses
};

/// Reads `ox,oy,oz,dx,dy,dz,tmin,tmax`, header first, then one ray per line. See csv_rows.h for
/// what counts as a row and a number.
/// @throws IoError if the file can't be read, FileError with all its faults
RaysFile readRays(const std::string& path);

/// The same from text. @param path for messages only
RaysFile parseRays(std::string_view text, const std::string& path);

/// An answer to write; doubles hold those of every engine.
struct RayAnswer {
  std::string_view object;      ///< name of what was hit
  std::int64_t primitive = -1;  ///< -1 is a miss
  double t = 0.0;
  glm::dvec3 normal{0.0};
};

/// Writes the header of a Hits CSV.
void writeRayHitsHeader(std::ostream& out);

/// Writes one line `ray,engine,hit,object,primitive,t,nx,ny,nz`: hit is 1 or 0, numbers are hex
/// floats; a miss has primitive -1 and nothing else.
void writeRayHit(std::ostream& out, std::size_t ray, std::string_view engine,
                 const RayAnswer& answer);

/// `t,nx,ny,nz` as hex floats, or four empty fields for a miss; the end of a line in both hits
/// files.
std::string distanceAndNormal(bool hit, double t, const glm::dvec3& normal);

}  // namespace twintrace
