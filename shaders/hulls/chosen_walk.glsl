// How all primitives of a scene are visited. For scenes with hulls the host puts a file in this one's
// place that visits the planes and then walks through the hulls.
#pragma once

#include "geometry.glsl"

Hit visitScene(Ray ray, Hit start) {
  precise Hit result = visitGeometry(ray, start);
  return result;
}
