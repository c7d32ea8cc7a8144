// Built once per instruction set, with TWINTRACE_KERNEL_BUILD naming the namespace and
// TWINTRACE_TILE_KERNEL the function.

#include "cpu/kernel/wide.h"

#include "common/base/flush_denormals.h"
#include "cpu/kernel/integrator.h"
#include "cpu/kernel_entry.h"

#include <new>

TWINTRACE_KERNEL_BEGIN

static_assert(kLanes == TWINTRACE_EXPECTED_LANES, "the compiler flags give another vector width");

// Ended lanes that are worth starting new samples for: below this the lanes still under way go on
// alone. Any value gives the same sums. Measured on cornell with 16 lanes.
inline constexpr int kRestartLanes = kLanes / 4;

/// Hands out the pixels of a tile, row by row.
class PixelQueue {
 public:
  explicit PixelQueue(const Tile& tile) : tile_(tile), x_(tile.x0), y_(tile.y0) {}
  bool empty() const { return y_ >= tile_.y1; }
  int x() const { return x_; }
  int y() const { return y_; }
  void pop() {
    if (++x_ < tile_.x1) return;
    x_ = tile_.x0;
    ++y_;
  }

 private:
  Tile tile_;
  int x_, y_;
};

/// The lanes' work: each holds a pixel and sums its samples in order; a lane whose pixel is done
/// takes the tile's next one.
struct LaneWork {
  WideInt x{0}, y{0}, pass{0};
  WideMask busy{false};
  Vec3<WideFloat> sum;
};

TWINTRACE_INLINE void storeSum(const FrameJob& job, const LaneWork& work, int lane) {
  const auto at = static_cast<std::size_t>(work.y.lane(lane)) * job.scene->width + work.x.lane(lane);
  float* out = job.sums + 3 * at;
  out[0] = work.sum.x.lane(lane);
  out[1] = work.sum.y.lane(lane);
  out[2] = work.sum.z.lane(lane);
}

TWINTRACE_INLINE void takePixel(LaneWork& work, PixelQueue& queue, int lane) {
  work.busy.value[lane] = !queue.empty();
  if (queue.empty()) return;
  work.x.value[lane] = queue.x();
  work.y.value[lane] = queue.y();
  work.pass.value[lane] = 0;
  work.sum.x.value[lane] = 0.0f;
  work.sum.y.value[lane] = 0.0f;
  work.sum.z.value[lane] = 0.0f;
  queue.pop();
}

template <class R>
PathState<R> chosenState(MaskOf<R> condition, const PathState<R>& a, const PathState<R>& b) {
  const auto pick = [&](const auto& u, const auto& v) { return select(condition, u, v); };
  const auto pick3 = [&](const Vec3<R>& u, const Vec3<R>& v) { return select(condition, u, v); };
  return {{pick(a.key.first, b.key.first), pick(a.key.second, b.key.second),
           pick(a.key.frame, b.key.frame)},
          {pick3(a.ray.origin, b.ray.origin), pick3(a.ray.direction, b.ray.direction),
           pick3(a.ray.inverse, b.ray.inverse), pick(a.ray.tmin, b.ray.tmin),
           pick(a.ray.tmax, b.ray.tmax)},
          pick3(a.throughput, b.throughput),
          pick3(a.radiance, b.radiance),
          pick(a.bounce, b.bounce),
          pick(a.alive, b.alive)};
}

/// Starts the next sample in every busy lane whose path has ended.
TWINTRACE_INLINE void restart(const SceneView& scene, const Frame& frame, const LaneWork& work,
                              PathState<WideFloat>& state) {
  const WideUint sample = WideUint(frame.firstSample) + toUnsigned(work.pass);
  const PathState<WideFloat> begun =
      beginSample<WideFloat>(scene, work.x, work.y, sample, frame);
  state = chosenState<WideFloat>(work.busy && !state.alive, begun, state);
}

/// Books the samples of lanes whose path has ended: adds them up, and stores finished pixels.
TWINTRACE_INLINE void finish(const FrameJob& job, WideMask ended, const PathState<WideFloat>& state,
                             LaneWork& work, PixelQueue& queue) {
  work.sum = select(ended, work.sum + state.radiance, work.sum);
  work.pass = select(ended, work.pass + WideInt(1), work.pass);
  const WideMask done = ended && work.pass >= WideInt(job.passes);
  if (!anyLane(done)) return;
  for (int lane = 0; lane < kLanes; ++lane) {
    if (!done.lane(lane)) continue;
    storeSum(job, work, lane);
    takePixel(work, queue, lane);
  }
}

/// Builds the state after a step in place: `next` must not be `state`.
template <class Step>
TWINTRACE_STEP void advance(const SceneView& scene, const Frame& frame,
                            const PathState<WideFloat>& state, PathState<WideFloat>* next,
                            Step step) {
  ::new (static_cast<void*>(next)) PathState<WideFloat>(step(scene, state, frame));
}

template <class Step>
TWINTRACE_STEP void renderTileWide(const FrameJob& job, const SceneView& scene, const Tile& tile,
                                   Step step) {
  const Frame frame{job.scene->width, job.options->bounces, job.passes, job.firstSample,
                    job.options->seed};
  PixelQueue queue(tile);
  LaneWork work;
  for (int lane = 0; lane < kLanes; ++lane) takePixel(work, queue, lane);
  WideMask waiting = work.busy;  // lanes between two samples
  // All lanes begin with a path, so that idle ones, too, compute with numbers.
  PathState<WideFloat> states[2] = {
      beginSample<WideFloat>(scene, work.x, work.y, WideUint(frame.firstSample), frame), {}};
  int now = 0;
  states[now].alive = WideMask(false);
  while (anyLane(work.busy)) {
    if (stdx::popcount(waiting.value) >= kRestartLanes || !anyLane(states[now].alive)) {
      restart(scene, frame, work, states[now]);
      waiting = WideMask(false);
    }
    advance(scene, frame, states[now], &states[1 - now], step);
    const WideMask ended = states[now].alive && !states[1 - now].alive;
    now = 1 - now;
    if (anyLane(ended)) {
      finish(job, ended, states[now], work, queue);
      waiting = (waiting || ended) && work.busy;
    }
  }
}

TWINTRACE_KERNEL_END

namespace twintrace {

void TWINTRACE_TILE_KERNEL(const FrameJob& job, const Tile& tile) {
  const FlushDenormals flush;
  const kernel::SceneView scene = kernel::viewScene(*job.scene, *job.options, job.hull);
  kernel::withStep<kernel::WideFloat>(scene.integrator, [&](auto step) {
    kernel::renderTileWide(job, scene, tile, step);
  });
}

}  // namespace twintrace
