// Fragment stage: the closest hit of one ray per pixel, row by row.
#include "mains/query_ray.glsl"

uniform int targetWidth;
layout(location = 0) out vec4 hitAndTests;
layout(location = 1) out vec4 counts;
layout(location = 2) out vec4 heap;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int index = pixel.y * targetWidth + pixel.x;
  if (index >= rayCount) {
    return;
  }
  precise Hit hit = queryRay(index);
  hitAndTests = vec4(hit.t, float(hit.primitive), float(hullCounts.hullTests),
                     float(hullCounts.hullHits));
  counts = vec4(float(hullCounts.falseHullHits), float(hullCounts.primitiveTests),
                float(hullCounts.nodes), float(hullCounts.heapPushes));
  heap = vec4(float(hullCounts.heapOverflows));
}
