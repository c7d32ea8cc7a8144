// Built once per instruction set, with TWINTRACE_KERNEL_BUILD naming the namespace and
// TWINTRACE_HULL_WALK the function.

#include "cpu/hull_walk.h"

#include <cstring>

#include "cpu/kernel/geometry.h"
#include "cpu/kernel/hulls/walk.h"
#include "cpu/kernel_vectors.h"
#include "hull_volumes.h"  // generated: every file of cpu/kernel/hulls/volumes

namespace twintrace {
namespace {

/// The volume's test as a type, for each volume.
#define TWINTRACE_VOLUME(name, enterVolume)                                                  \
  struct name##Volume {                                                                      \
    template <class R>                                                                       \
    static R enter(const kernel::SceneView& scene, const kernel::HullRay<R>& ray, int record) {\
      return kernel::enterVolume(scene, ray, record);                                         \
    }                                                                                        \
  };
TWINTRACE_HULL_VOLUMES(TWINTRACE_VOLUME)
#undef TWINTRACE_VOLUME

template <class R, class Number>
kernel::Ray<R> kernelRay(const HullQueryRay<Number>& ray) {
  const auto vector = [](const Number (&v)[3]) {
    return kernel::Vec3<R>(R(v[0]), R(v[1]), R(v[2]));
  };
  return kernel::makeRay(vector(ray.origin), vector(ray.direction), R(ray.tmin), R(ray.tmax));
}

/// The plain number that a kernel's number type computes with.
template <class R>
using PlainOf = decltype(kernel::plainNumber(R(0.0f)));

/// Planes, then a walk through hulls of one volume.
template <class R, class Volume>
class HullWalker : public HullQuery {
 public:
  HullWalker(const FlatScene& scene, const RenderOptions& options)
      : view_(kernel::viewScene(scene, options, nullptr)),
        arrangement_(scene.hulls->arrangement) {}

  using HullQuery::closest;
  using HullQuery::count;

  int closest(const HullQueryRay<PlainOf<R>>& ray, PlainOf<R>& t) const override {
    HullCounts none;
    const kernel::Hit<R> hit = walk<false>(kernelRay<R>(ray), none);
    if (hit.primitive != kernel::kNoPrimitive) t = kernel::plainNumber(hit.t);
    return hit.primitive;
  }
  void count(const HullQueryRay<PlainOf<R>>& ray, HullCounts& counts) const override {
    walk<true>(kernelRay<R>(ray), counts);
  }

 private:
  template <bool counting>
  kernel::Hit<R> walk(const kernel::Ray<R>& ray, HullCounts& counts) const {
    const kernel::Hit<R> planes = visitPlanes(view_, ray, {ray.tmax, kernel::kNoPrimitive});
    kernel::HullWalk<R, Volume, counting> hulls(view_, ray);
    const kernel::Hit<R> hit = visit(hulls, planes);
    if constexpr (counting) counts = counts + hulls.counts();
    return hit;
  }

  template <class Hulls>
  kernel::Hit<R> visit(Hulls& hulls, const kernel::Hit<R>& start) const {
    if (arrangement_ == HullArrangement::flat) return hulls.visitFlat(start);
    if (arrangement_ == HullArrangement::heap) return hulls.visitHeap(start);
    return hulls.visitTree(start);
  }

  kernel::SceneView view_;
  HullArrangement arrangement_;
};

/// Tests every primitive.
template <class R>
class Sweep : public HullQuery {
 public:
  Sweep(const FlatScene& scene, const RenderOptions& options)
      : view_(kernel::viewScene(scene, options, nullptr)) {}

  using HullQuery::closest;
  using HullQuery::count;

  int closest(const HullQueryRay<PlainOf<R>>& plain, PlainOf<R>& t) const override {
    const kernel::Ray<R> ray = kernelRay<R>(plain);
    const kernel::Hit<R> hit = visitGeometry(view_, ray, {ray.tmax, kernel::kNoPrimitive});
    if (hit.primitive != kernel::kNoPrimitive) t = kernel::plainNumber(hit.t);
    return hit.primitive;
  }
  void count(const HullQueryRay<PlainOf<R>>&, HullCounts& counts) const override {
    counts.primitiveTests += view_.index.boundedCount();
  }

 private:
  kernel::SceneView view_;
};

/// By hand: code of the standard library, compiled here, could take the place of its baseline copy.
template <std::size_t size>
bool isNamed(std::string_view name, const char (&expected)[size]) {
  return name.size() == size - 1 && std::memcmp(name.data(), expected, size - 1) == 0;
}

template <class R>
std::unique_ptr<HullQuery> makeWalker(const FlatScene& scene, const RenderOptions& options) {
  if (scene.hulls == nullptr) return std::make_unique<Sweep<R>>(scene, options);
  const std::string_view volume = scene.hulls->volume.name;
#define TWINTRACE_VOLUME(name, enterVolume) \
  if (isNamed(volume, #name)) return std::make_unique<HullWalker<R, name##Volume>>(scene, options);
  TWINTRACE_HULL_VOLUMES(TWINTRACE_VOLUME)
#undef TWINTRACE_VOLUME
  return nullptr;
}

}  // namespace

std::unique_ptr<HullQuery> TWINTRACE_HULL_WALK(const FlatScene& scene,
                                               const RenderOptions& options) {
  if (options.precision == Precision::float64) return makeWalker<double>(scene, options);
  if (options.maths == Maths::native) return makeWalker<kernel::NativeFloat>(scene, options);
  return makeWalker<float>(scene, options);
}

}  // namespace twintrace
