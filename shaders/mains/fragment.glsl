// Fragment stage: one pixel of a tile of a frame.
#include "mains/uniforms.glsl"

#include "integrator.glsl"

layout(location = 0) out vec4 frameSum;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Frame frame = Frame(filmWidth, bounceLimit, passCount, firstSampleIndex, seedValue);
  frameSum = vec4(renderPixel(tileX + pixel.x, tileY + pixel.y, frame), 1.0f);
}
