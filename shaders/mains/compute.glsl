// Compute stage: one pixel of a tile of a frame per invocation.
#include "mains/uniforms.glsl"

#include "integrator.glsl"
#include "mains/loop_check.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) writeonly buffer FrameSums {
  float frameSums[];
};

void main() {
  int x = int(gl_GlobalInvocationID.x);
  int y = int(gl_GlobalInvocationID.y);
  if (x >= tileWidth || y >= tileHeight) {
    return;
  }
  Frame frame = Frame(filmWidth, bounceLimit, passCount, firstSampleIndex, seedValue);
  precise vec3 sum = renderPixel(tileX + x, tileY + y, frame);
  int at = 4 * (y * tileWidth + x);
  frameSums[at] = sum.x;
  frameSums[at + 1] = sum.y;
  frameSums[at + 2] = sum.z;
  frameSums[at + 3] = loopsHeld() ? 1.0f : 0.0f;
}
