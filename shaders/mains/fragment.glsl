// Fragment stage: one pixel of a tile of a frame.
#include "mains/uniforms.glsl"

#include "integrator.glsl"
#include "mains/loop_check.glsl"

layout(location = 0) out vec4 frameSum;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Frame frame = Frame(filmWidth, bounceLimit, passCount, firstSampleIndex, seedValue);
  precise vec3 sum = renderPixel(tileX + pixel.x, tileY + pixel.y, frame);
  frameSum = vec4(sum, loopsHeld() ? 1.0f : 0.0f);
}
