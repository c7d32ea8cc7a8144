// Fragment stage: one ray of a case set per pixel, row by row.
#include "mains/cast_ray.glsl"

uniform int targetWidth;
layout(location = 0) out vec4 distanceAndNormal;
layout(location = 1) out vec4 primitive;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int index = pixel.y * targetWidth + pixel.x;
  if (index >= rayCount) {
    return;
  }
  precise CaseAnswer answer = castRay(index);
  distanceAndNormal = vec4(answer.t, answer.normal);
  primitive = vec4(float(answer.primitive));
}
