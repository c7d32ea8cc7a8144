// Built once per instruction set, with TWINTRACE_KERNEL_BUILD naming the namespace and
// TWINTRACE_SCALAR_KERNELS the function.

#include "common/base/flush_denormals.h"
#include "cpu/kernel/integrator.h"
#include "cpu/kernel_entry.h"

namespace twintrace {
namespace {

template <class R>
void renderTileScalar(const FrameJob& job, const Tile& tile) {
  const FlushDenormals flush;
  const kernel::SceneView scene = kernel::viewScene(*job.scene, *job.options, job.hull);
  const int width = job.scene->width;
  const kernel::Frame frame{width, job.options->bounces, job.passes, job.firstSample,
                            job.options->seed};
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const kernel::Vec3<R> sum = kernel::renderPixel<R>(scene, x, y, frame);
      float* out = job.sums + 3 * (static_cast<std::size_t>(y) * width + x);
      out[0] = static_cast<float>(kernel::plainNumber(sum.x));
      out[1] = static_cast<float>(kernel::plainNumber(sum.y));
      out[2] = static_cast<float>(kernel::plainNumber(sum.z));
    }
  }
}

}  // namespace

ScalarKernels TWINTRACE_SCALAR_KERNELS() {
  return {renderTileScalar<float>, renderTileScalar<kernel::NativeFloat>,
          renderTileScalar<double>};
}

}  // namespace twintrace
