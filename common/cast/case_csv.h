#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/cast/case_set.h"
#include "common/cast/exact_hit.h"

namespace twintrace {

/// The scenes and rays of a Cases CSV, with their names.
struct CasesFile {
  CaseSet cases;
  std::size_t nanRays = 0;  ///< rays with a NaN; each of them misses
};

/// Reads records, one per line: `scene,NAME` and, for that scene, `sphere,ID,cx,cy,cz,r`;
/// `box,ID,xmin,ymin,zmin,xmax,ymax,zmax`; `obb,ID,` centre, three axes, three half sizes;
/// `plane,ID,nx,ny,nz,px,py,pz`; `tri,ID,` three vertices; then
/// `ray,ID,ox,oy,oz,dx,dy,dz,tmin,tmax`. Records before the first scene line belong to a scene
/// without a name. A scene's primitives come before its rays, so that no ray's scene depends on how
/// the file is read. Scene names are unique, as are the IDs of primitives and of rays in a scene.
/// Primitives need finite numbers; they are normalised. See csv_rows.h for what counts as a row and
/// a number.
/// @throws IoError if the file can't be read, FileError with all its faults
CasesFile readCases(const std::string& path);

/// The same from text. @param path for messages only
CasesFile parseCases(std::string_view text, const std::string& path);

/// Names as files have them; where a case set has none, the index: of primitives within their
/// scene, of rays and scenes within the set.
std::string sceneName(const CaseSet& cases, std::size_t scene);
std::string primitiveName(const CaseSet& cases, const CaseRay& ray, int primitive);
std::string rayName(const CaseSet& cases, std::size_t ray);

/// Some rays of a case set with their scenes, all under the names that they have in the set, to be
/// saved and cast again. Bounces are kept.
/// @param rays indices in rising order
CaseSet selectRays(const CaseSet& cases, std::span<const std::size_t> rays);

/// Writes a Cases CSV that reads back with the same bits. Bounces have no record and are left out;
/// in names, what the file could not hold becomes `_`.
void writeCases(std::ostream& out, const CaseSet& cases);

/// An answer to write; doubles hold those of every engine.
struct CaseAnswer {
  std::int32_t primitive = -1;  ///< within the ray's scene; -1 is a miss
  double t = 0.0;
  glm::dvec3 normal{0.0};
  std::optional<Clarity> clarity;  ///< where the arbiter was asked
};

/// Writes the header of the hits of cases.
void writeCaseHitsHeader(std::ostream& out);

/// Writes one line `scene,ray,engine,prim,t,nx,ny,nz,class`: prim is the primitive's ID, or -1 for
/// a miss, then t and normal are empty; class is clean, ambiguous, tie or empty.
void writeCaseHit(std::ostream& out, const CaseSet& cases, std::size_t ray, std::string_view engine,
                  const CaseAnswer& answer);

/// clean, ambiguous or tie.
std::string_view clarityName(Clarity clarity);

}  // namespace twintrace
