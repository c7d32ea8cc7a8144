// Radiance from beyond the scene: a constant, or an equirectangular image.
#pragma once

#include "math.glsl"
#include "scene_access.glsl"

int wrapColumn(int x, int width) {
  int raised = select(x < 0, x + width, x);
  return select(raised >= width, raised - width, raised);
}

// Bilinear lookup at continuous image coordinates, pixel centres at 0.5; columns wrap, rows clamp.
vec3 environmentBilinear(float column, float row) {
  precise float width = float(kEnvironmentWidth);
  precise float height = float(kEnvironmentHeight);
  precise float fromFirstColumn = column - 0.5f;
  precise float fromFirstRow = row - 0.5f;
  precise float lastRow = height - 1.0f;
  precise float x = clampTo(fromFirstColumn, -1.0f, width);
  precise float y = clampTo(fromFirstRow, 0.0f, lastRow);
  precise float left = floor(x);
  precise float top = floor(y);
  precise float fx = x - left;
  precise float fy = y - top;
  int x0 = wrapColumn(int(left), kEnvironmentWidth);
  int x1 = wrapColumn(int(left) + 1, kEnvironmentWidth);
  int y0 = int(top);
  int y1 = select(y0 + 1 < kEnvironmentHeight, y0 + 1, y0);
  precise float gx = 1.0f - fx;
  precise float gy = 1.0f - fy;
  precise vec3 upper = fetchEnvironmentPixel(x0, y0) * gx + fetchEnvironmentPixel(x1, y0) * fx;
  precise vec3 lower = fetchEnvironmentPixel(x0, y1) * gx + fetchEnvironmentPixel(x1, y1) * fx;
  precise vec3 result = upper * gy + lower * fy;
  return result;
}

// Radiance that arrives along a ray of unit direction d: u = 0.5 + atan2(z, x) / 2 pi plus the
// rotation, v = acos(y) / pi, row 0 at +y.
vec3 environment(vec3 d) {
  if (kEffectEnvironmentImage && kEnvironmentWidth > 0) {
    precise float turned = (0.5f + arcTangent2(d.z, d.x) * kInverseTwoPi) + fetchEnvironmentTurn();
    precise float u = turned - floor(turned);
    precise float v = arcCosine(d.y) * kInversePi;
    precise float column = u * float(kEnvironmentWidth);
    precise float row = v * float(kEnvironmentHeight);
    precise vec3 looked = environmentBilinear(column, row);
    return looked;
  }
  return fetchEnvironmentRadiance();
}
