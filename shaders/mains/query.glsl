// Compute stage: the closest hit of one ray per invocation.
#include "mains/query_ray.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) writeonly buffer QueryAnswers {
  float queryAnswers[];
};

void main() {
  int index = int(gl_GlobalInvocationID.x);
  if (index >= rayCount) {
    return;
  }
  precise Hit hit = queryRay(index);
  int at = index * (kHullCounting ? 9 : 2);
  queryAnswers[at] = hit.t;
  queryAnswers[at + 1] = float(hit.primitive);
  if (kHullCounting) {
    queryAnswers[at + 2] = float(hullCounts.hullTests);
    queryAnswers[at + 3] = float(hullCounts.hullHits);
    queryAnswers[at + 4] = float(hullCounts.falseHullHits);
    queryAnswers[at + 5] = float(hullCounts.primitiveTests);
    queryAnswers[at + 6] = float(hullCounts.nodes);
    queryAnswers[at + 7] = float(hullCounts.heapPushes);
    queryAnswers[at + 8] = float(hullCounts.heapOverflows);
  }
}
