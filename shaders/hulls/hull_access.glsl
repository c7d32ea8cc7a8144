// The only reader of hulls: nodes out of their own texel array. A node is a hull's record and then its
// link. Layout: kHullNodeTexels texels a node, then the references, four in a texel.
#pragma once

#include "hulls/hull_ray.glsl"
#include "scene_access.glsl"

// What lies in a hull: nodes if `inner`, else references.
struct HullLink {
  int first;
  int count;
  bool inner;
};

uvec4 fetchHullTexel(int hullTexel) {
  return texelFetch(hullTexels, hullTexel);
}

HullLink fetchHullLink(int node) {
  int behind = (node + 1) * kHullNodeTexels;
  uvec4 texel = fetchHullTexel(behind - 1);
  return HullLink(int(texel.x), int(texel.y), texel.z != 0u);
}

// The primitive of a reference.
int fetchReference(int reference) {
  int at = kHullReferenceOffset + (reference >> 2);
  uvec4 texel = fetchHullTexel(at);
  int part = reference & 3;
  uint low = select((part & 1) != 0, texel.y, texel.x);
  uint high = select((part & 1) != 0, texel.w, texel.z);
  return int(select((part & 2) != 0, high, low));
}
