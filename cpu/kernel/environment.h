#pragma once

// Twin of shaders/environment.glsl: radiance from beyond the scene.

#include "cpu/kernel/math.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

template <class Int>
Int wrapColumn(Int x, int width) {
  const Int raised = select(x < Int(0), x + Int(width), x);
  return select(raised >= Int(width), raised - Int(width), raised);
}

/// Bilinear lookup at continuous image coordinates, pixel centres at 0.5; columns wrap, rows clamp.
template <class R>
Vec3<R> environmentBilinear(const SceneView& scene, R column, R row) {
  using Int = IntOf<R>;
  const int columns = scene.index.environmentWidth;
  const int rows = scene.index.environmentHeight;
  const R width = toNumber<R>(columns);
  const R height = toNumber<R>(rows);
  const R x = clampTo(column - R(0.5f), R(-1.0f), width);
  const R y = clampTo(row - R(0.5f), R(0.0f), height - R(1.0f));
  const R left = floorOf(x);
  const R top = floorOf(y);
  const R fx = x - left;
  const R fy = y - top;
  const Int x0 = wrapColumn(toInt(left), columns);
  const Int x1 = wrapColumn(toInt(left) + Int(1), columns);
  const Int y0 = toInt(top);
  const Int y1 = select(y0 + Int(1) < Int(rows), y0 + Int(1), y0);
  const R gx = R(1.0f) - fx;
  const R gy = R(1.0f) - fy;
  const Vec3<R> upper = fetchEnvironmentPixel<R>(scene, x0, y0) * gx +
                        fetchEnvironmentPixel<R>(scene, x1, y0) * fx;
  const Vec3<R> lower = fetchEnvironmentPixel<R>(scene, x0, y1) * gx +
                        fetchEnvironmentPixel<R>(scene, x1, y1) * fx;
  return upper * gy + lower * fy;
}

/// Radiance that arrives along a ray of unit direction d; equirectangular as in the scene format.
template <class R>
Vec3<R> environment(const SceneView& scene, const Vec3<R>& d) {
  if (scene.effectEnvironmentImage && scene.index.environmentWidth > 0) {
    const R turned =
        (R(0.5f) + arcTangent2(d.z, d.x) * constant<R>(kInverseTwoPi)) + fetchEnvironmentTurn<R>(scene);
    const R u = turned - floorOf(turned);
    const R v = arcCosine(d.y) * constant<R>(kInversePi);
    return environmentBilinear(scene, u * toNumber<R>(scene.index.environmentWidth),
                               v * toNumber<R>(scene.index.environmentHeight));
  }
  return fetchEnvironmentRadiance<R>(scene);
}

TWINTRACE_KERNEL_END
