#pragma once

#include <cstdint>

#include "common/scene/flat_scene.h"
#include "cpu/hull_query.h"

namespace twintrace {

/// A rectangle of pixels, [x0, x1) x [y0, y1).
struct Tile {
  int x0, y0, x1, y1;
};

/// What all tiles of a frame share. Plain types only: this is the border between code built for
/// different instruction sets.
struct FrameJob {
  const FlatScene* scene = nullptr;
  const RenderOptions* options = nullptr;
  const HullQuery* hull = nullptr;  ///< null: test every primitive
  std::uint32_t firstSample = 0;
  int passes = 1;
  float* sums = nullptr;  ///< width * height * 3, row 0 on top
};

/// Renders a tile of a frame: per pixel the float sum of its samples in sample order.
using TileKernel = void (*)(const FrameJob& job, const Tile& tile);

/// The kernels that carry one ray at a time.
struct ScalarKernels {
  TileKernel strict;
  TileKernel native;
  TileKernel float64;
};

// The scalar text is compiled twice as well: AVX2 has the blend that `select` wants.
ScalarKernels scalarKernelsBaseline();
ScalarKernels scalarKernelsAvx2();
void renderTileSse2(const FrameJob& job, const Tile& tile);
void renderTileAvx2(const FrameJob& job, const Tile& tile);
void renderTileAvx512(const FrameJob& job, const Tile& tile);

}  // namespace twintrace
