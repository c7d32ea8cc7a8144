#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/cast/case_set.h"
#include "common/cast/exact_hit.h"

namespace twintrace::exact {

/// Whether the decision survives every surface moving by 8 ulp(M) against the ray, as clean or
/// ambiguous. ulp(M) = 2^-23 M; M is the largest coordinate involved: of the origin, of the
/// primitive (sphere: |centre| + radius; oriented box: its corners; plane: its point) and of t *
/// direction.
///
/// The moves: a sphere's radius either way; each bound of a box by itself, kept in order, so that a
/// box without thickness stays one; a triangle's outline across the ray, so that whoever passes it
/// within that distance is ambiguous, as is every hit on one that the ray sees edge on; a plane
/// along its normal, and it turns by 8 * 2^-23, so that a ray closer than that to its direction is
/// ambiguous. A decision stands if the hit surface is surely there and surely within the ray's
/// interval, the entry surely before the interval if the exit was hit, and every other surface
/// surely absent, outside the interval or farther.
/// @param ray castable, without denormals
/// @param hit the exact answer
Clarity clarityOf(std::span<const CasePrimitive> primitives, const CastRay& ray,
                  const ExactHit& hit);

/// Unit normal at a hit as CaseEngine says; of a sphere of radius 0 against the ray.
/// @param axis,side of boxes: the slab and its bound (-1, 1) that was hit
glm::dvec3 normalOf(const CasePrimitive& primitive, const CastRay& ray, const ExactHit& hit,
                    int axis, int side);

/// Faces of a box that such moves make the hit one, crossed the same way, inwards or outwards; none
/// of what is no box.
/// @param hit with t, tUnit and leaving
/// @param axis slab of the face that was hit
std::vector<FaceBeside> facesBeside(const CasePrimitive& primitive, const CastRay& ray,
                                    const ExactHit& hit, int axis);

/// Change of t when the hit surface moves by 1 ulp(M) along its normal: ulp(M) / |normal .
/// direction|, for a sphere the change of the root itself, which stays finite at a tangent.
/// @param hit with t and normal
double tUnitOf(const CasePrimitive& primitive, const CastRay& ray, const ExactHit& hit);

}  // namespace twintrace::exact
