// Built once per instruction set, with TWINTRACE_KERNEL_BUILD naming the namespace and
// TWINTRACE_BVH8 the function. Nodes and primitives are tested eight at a time in float, widened so that
// nothing is lost; the kernel's own test decides.

#include "cpu/hull_walk.h"
#include "cpu/kernel/wide.h"

#include <array>
#include <bit>
#include <memory>

#include "common/base/error.h"
#include "cpu/bvh8_tree.h"
#include "cpu/kernel/geometry.h"
#include "cpu/kernel/hulls/hull_ray.h"
#include "cpu/kernel/primitive.h"

namespace twintrace {
namespace {

using kernel::WideFloat;
using kernel::WideMask;
using Ray = kernel::Ray<float>;
using Hit = kernel::Hit<float>;

constexpr int kParts = kBvh8Width / kernel::kLanes;
static_assert(kParts * kernel::kLanes == kBvh8Width);
/// Waiting nodes: seven for each level of the tree, whose depth topology.h bounds.
constexpr int kStack = 8 * 64;

/// A bit for each lane.
unsigned maskBits(WideMask mask) {
#if defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_ps(std::bit_cast<__m256>(mask.value)));
#else
  return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(mask.value)));
#endif
}

WideFloat load(const float* from) {
  return kernel::SimdFloat(from, kernel::stdx::element_aligned);
}

/// a * b - c, rounded once or twice: the slack covers either.
WideFloat scaledMinus(WideFloat a, WideFloat b, WideFloat c) {
#if defined(__FMA__)
  return kernel::SimdFloat(_mm256_fmsub_ps(static_cast<__m256>(a.value), static_cast<__m256>(b.value),
                                           static_cast<__m256>(c.value)));
#else
  return a * b - c;
#endif
}

/// What all tests of a ray share.
struct PreparedRay {
  Ray ray;
  float slack;
  WideFloat near[3], far[3], inverse[3];  ///< a bound's t is bound * inverse - near, or far
  int nearRow[3], farRow[3];  ///< of a node's bounds
  int turned[3];              ///< axes so that the direction's longest is the last
  unsigned octant;            ///< of Bvh8Node::order
  bool fromStart;             ///< no hits before t = 0
};

/// Directions are no closer to an axis' plane than this, so that all products are finite; over the
/// distances in a scene it moves a ray by much less than the slack.
constexpr float kLeastDirection = 1e-18f;

/// The kernel's makeRay, with the three divisions at once.
Ray makeRay(const HullQueryRay<float>& plain) {
  const float* d = plain.direction;
  const __m128 directions = _mm_setr_ps(d[0], d[1], d[2], 1.0f);
  alignas(16) float inverse[4];
  _mm_store_ps(inverse, _mm_div_ps(_mm_set1_ps(1.0f), directions));
  const auto orInfinity = [&](int i) { return d[i] == 0.0f ? kernel::kInfinity : inverse[i]; };
  return {{plain.origin[0], plain.origin[1], plain.origin[2]},
          {d[0], d[1], d[2]},
          {orInfinity(0), orInfinity(1), orInfinity(2)},
          plain.tmin,
          plain.tmax};
}

PreparedRay prepare(const kernel::SceneView& scene, const Ray& ray) {
  const float o[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const float d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
  const float exact[3] = {ray.inverse.x, ray.inverse.y, ray.inverse.z};
  PreparedRay result;
  result.ray = ray;
  result.slack = hullSlack(scene, ray);
  result.octant = 0;
  result.fromStart = ray.tmin >= 0.0f;
  for (int i = 0; i < 3; ++i) {
    const bool tiny = std::fabs(d[i]) < kLeastDirection;
    const float inverse = tiny ? std::copysign(1.0f / kLeastDirection, d[i]) : exact[i];
    const unsigned back = std::bit_cast<std::uint32_t>(inverse) >> 31;
    const float reach = back != 0 ? -result.slack : result.slack;
    result.inverse[i] = WideFloat(inverse);
    result.near[i] = WideFloat((o[i] + reach) * inverse);
    result.far[i] = WideFloat((o[i] - reach) * inverse);
    result.nearRow[i] = 2 * i + static_cast<int>(back);
    result.farRow[i] = 2 * i + 1 - static_cast<int>(back);
    result.octant |= back << i;
  }
  const auto size = [&](int i) { return std::fabs(d[i]); };
  const int last = size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
  const int next = last == 2 ? 0 : last + 1;
  result.turned[0] = next;
  result.turned[1] = next == 2 ? 0 : next + 1;
  result.turned[2] = last;
  return result;
}

/// Where a ray enters and leaves some of a node's boxes.
struct BoxIntervals {
  WideFloat entry;
  WideFloat exit;
};

BoxIntervals enterBoxes(const PreparedRay& ray, const Bvh8Node& node, float limit, int lane) {
  BoxIntervals result{WideFloat(ray.ray.tmin), WideFloat(limit)};
  for (int i = 0; i < 3; ++i) {
    const WideFloat near =
        scaledMinus(load(&node.bounds[ray.nearRow[i]][lane]), ray.inverse[i], ray.near[i]);
    const WideFloat far =
        scaledMinus(load(&node.bounds[ray.farRow[i]][lane]), ray.inverse[i], ray.far[i]);
    result.entry = greatest(result.entry, near);
    result.exit = least(result.exit, far);
  }
  return result;
}

/// 96 units of 2^-24. The kernel tests a triangle by its corners relative to the origin, rounded as here.
/// From there on a coordinate beside the ray is off by 7 u times the largest relative coordinate, which is
/// at most 3 M, M the largest number made of the corners below; so an edge function is off by 90 u M B, B
/// the largest coordinate beside the ray.
constexpr float kTriangleMargin = 0x1.8p-18f;
/// 16 units of 2^-24. The line's point nearest to a sphere's center is off by 5 u |f| here, f the origin
/// relative to the center, and by less than u r in the kernel, r the radius.
constexpr float kSphereMargin = 0x1p-20f;

/// Of a block's triangles those that the kernel's test may hit: their edge functions in float don't tell
/// that the ray passes outside, or before its beginning or behind `limit`. Woop, Benthin and Wald 2013.
TWINTRACE_INLINE unsigned maybeTriangles(const PreparedRay& ray, const Bvh8Block& block, float limit) {
  const float o[3] = {ray.ray.origin.x, ray.ray.origin.y, ray.ray.origin.z};
  const float inverse[3] = {ray.ray.inverse.x, ray.ray.inverse.y, ray.ray.inverse.z};
  const float d[3] = {ray.ray.direction.x, ray.ray.direction.y, ray.ray.direction.z};
  const auto [x, y, z] = std::array{ray.turned[0], ray.turned[1], ray.turned[2]};
  const WideFloat shearZ(inverse[z]);
  const WideFloat shearX(d[x]), shearY(d[y]);
  unsigned bits = 0;
  for (int part = 0; part < kParts; ++part) {
    const int lane = part * kernel::kLanes;
    // Corners beside the ray, with the sign turned, and how far along it, in t.
    WideFloat bx[3], by[3], bz[3];
    WideFloat beside(0.0f);
    for (int corner = 0; corner < 3; ++corner) {
      const auto& rows = &block.values[3 * corner];
      bz[corner] = (load(&rows[z][lane]) - WideFloat(o[z])) * shearZ;
      bx[corner] = scaledMinus(bz[corner], shearX, load(&rows[x][lane]) - WideFloat(o[x]));
      by[corner] = scaledMinus(bz[corner], shearY, load(&rows[y][lane]) - WideFloat(o[y]));
      beside = greatest(greatest(beside, absolute(bx[corner])), absolute(by[corner]));
    }
    const WideFloat u = scaledMinus(bx[2], by[1], by[2] * bx[1]);
    const WideFloat v = scaledMinus(bx[0], by[2], by[0] * bx[2]);
    const WideFloat w = scaledMinus(bx[1], by[0], by[1] * bx[0]);
    const WideFloat depth = (absolute(bz[0]) + absolute(bz[1])) + absolute(bz[2]);
    const WideFloat reach = greatest(beside, depth * WideFloat(std::fabs(d[z])));
    const WideFloat margin = (beside * reach) * WideFloat(kTriangleMargin);
    const WideMask outside = least(least(u, v), w) < -margin && greatest(greatest(u, v), w) > margin;
    // t is weighted / whole; both with the sign of `whole`, which is sure where it is large.
    const WideFloat whole = (u + v) + w;
    const WideFloat weighted = (u * bz[0] + v * bz[1]) + w * bz[2];
    const WideFloat positive = select(whole < WideFloat(0.0f), -weighted, weighted);
    const WideFloat length = absolute(whole);
    const WideFloat doubt = margin * WideFloat(4.0f);
    const WideFloat spread = margin * depth;
    const WideMask before = positive < -spread;
    const WideFloat most = length * WideFloat(limit) + doubt * WideFloat(std::fabs(limit));
    const WideMask behind = positive - spread > most;
    const WideMask elsewhere = length > doubt && ((before && WideMask(ray.fromStart)) || behind);
    bits |= maskBits(!(outside || elsewhere)) << lane;
  }
  return bits & ((1u << block.count) - 1u);
}

/// The same for spheres.
unsigned maybeSpheres(const PreparedRay& ray, const Bvh8Block& block, float limit) {
  const kernel::Vec3<float>& d = ray.ray.direction;
  const kernel::Vec3<WideFloat> direction(d.x, d.y, d.z);
  const WideFloat inverse(kernel::divide(1.0f, kernel::dot3(d, d)));
  unsigned bits = 0;
  for (int part = 0; part < kParts; ++part) {
    const int lane = part * kernel::kLanes;
    const kernel::Vec3<WideFloat> from(
        WideFloat(ray.ray.origin.x) - load(&block.values[0][lane]),
        WideFloat(ray.ray.origin.y) - load(&block.values[1][lane]),
        WideFloat(ray.ray.origin.z) - load(&block.values[2][lane]));
    const WideFloat t = -dot3(from, direction) * inverse;
    const kernel::Vec3<WideFloat> nearest = from + direction * t;
    const WideFloat exact = load(&block.values[3][lane]);
    const WideFloat reach = ((absolute(from.x) + absolute(from.y)) + absolute(from.z)) + exact;
    const WideFloat radius = exact + reach * WideFloat(kSphereMargin);
    const WideFloat halfChordSquared = (radius * radius - dot3(nearest, nearest)) * inverse;
    const WideFloat halfChord = squareRoot(halfChordSquared);
    const WideMask outside = halfChordSquared < WideFloat(0.0f) ||
                             t - halfChord > WideFloat(limit) ||
                             t + halfChord < WideFloat(ray.ray.tmin);
    bits |= maskBits(!outside) << lane;
  }
  return bits & ((1u << block.count) - 1u);
}

#if defined(__AVX2__)
/// For each set of lanes the numbers of its members, from the lowest on.
constexpr std::array<std::uint64_t, 256> membersOfSets() {
  std::array<std::uint64_t, 256> sets{};
  for (unsigned set = 0; set < 256; ++set) {
    unsigned place = 0;
    for (std::uint64_t lane = 0; lane < 8; ++lane) {
      if ((set >> lane & 1u) != 0) sets[set] |= lane << (8 * place++);
    }
  }
  return sets;
}
constexpr std::array<std::uint64_t, 256> kMembers = membersOfSets();
#endif

/// Subtrees that wait for their turn. Two arrays: a pair that is written in halves and read whole would
/// wait for the writes.
class Waiting {
 public:
  /// Pushes the children of a node that the ray enters, about the nearest last. @return how many
  int pushChildren(const PreparedRay& ray, const Bvh8Node& node, float limit) {
#if defined(__AVX2__)
    const BoxIntervals boxes = enterBoxes(ray, node, limit, 0);
    const auto entry = static_cast<__m256>(boxes.entry.value);
    // Not "greater", which a NaN is not either.
    const auto unordered = static_cast<unsigned>(_mm256_movemask_ps(
        _mm256_cmp_ps(entry, static_cast<__m256>(boxes.exit.value), _CMP_NGT_UQ)));
    if ((unordered & (unordered - 1)) == 0) {
      if (unordered == 0) return 0;
      alignas(32) float entries[kBvh8Width];
      _mm256_store_ps(entries, entry);
      const int only = std::countr_zero(unordered);
      entries_[size_] = entries[only];
      children_[size_++] = node.child[only];
      return 1;
    }
    const __m256i order = _mm256_srlv_epi32(_mm256_set1_epi32(static_cast<int>(node.order[ray.octant])),
                                            _mm256_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28));
    const __m256 entries = _mm256_permutevar8x32_ps(entry, order);
    const __m256 exits = _mm256_permutevar8x32_ps(static_cast<__m256>(boxes.exit.value), order);
    const __m256i children = _mm256_permutevar8x32_epi32(
        _mm256_load_si256(reinterpret_cast<const __m256i*>(node.child)), order);
    const auto entered =
        static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(entries, exits, _CMP_NGT_UQ)));
    const __m256i members = _mm256_cvtepu8_epi32(
        _mm_cvtsi64_si128(static_cast<long long>(kMembers[entered])));
    _mm256_storeu_ps(&entries_[size_], _mm256_permutevar8x32_ps(entries, members));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(&children_[size_]),
                        _mm256_permutevar8x32_epi32(children, members));
    const int count = std::popcount(entered);
    size_ += static_cast<std::size_t>(count);
    return count;
#else
    std::array<float, kBvh8Width> entries;
    unsigned entered = 0;
    for (int part = 0; part < kParts; ++part) {
      const int lane = part * kernel::kLanes;
      const BoxIntervals boxes = enterBoxes(ray, node, limit, lane);
      boxes.entry.value.copy_to(&entries[static_cast<std::size_t>(lane)],
                                kernel::stdx::element_aligned);
      entered |= maskBits(!(boxes.entry > boxes.exit)) << lane;
    }
    for (int i = 0; i < kBvh8Width; ++i) {
      const unsigned child = node.order[ray.octant] >> (4 * i) & 7u;
      if ((entered >> child & 1u) == 0) continue;
      entries_[size_] = entries[child];
      children_[size_++] = node.child[child];
    }
    return std::popcount(entered);
#endif
  }

  /// The last that is entered at or before `limit`, if any. @return whether there is one
  bool pop(float limit, std::uint32_t& child) {
    while (size_ > 0) {
      if (entries_[--size_] > limit) continue;
      child = children_[size_];
      return true;
    }
    return false;
  }

 private:
  std::size_t size_ = 0;
  std::array<std::uint32_t, kStack> children_;
  std::array<float, kStack> entries_;
};

class Bvh8Walk : public HullQuery {
 public:
  Bvh8Walk(const FlatScene& scene, const RenderOptions& options)
      : view_(kernel::viewScene(scene, options, nullptr)), tree_(widen(scene, *scene.hulls)) {}

  using HullQuery::closest;
  using HullQuery::count;

  int closest(const HullQueryRay<float>& plain, float& t) const override {
    HullCounts none;
    const Hit hit = walk<false>(plain, none);
    if (hit.primitive != kernel::kNoPrimitive) t = hit.t;
    return hit.primitive;
  }
  void count(const HullQueryRay<float>& plain, HullCounts& counts) const override {
    walk<true>(plain, counts);
  }

 private:
  template <bool counting>
  Hit walk(const HullQueryRay<float>& plain, HullCounts& counts) const {
    const Ray given = makeRay(plain);
    Hit best = visitPlanes(view_, given, Hit{given.tmax, kernel::kNoPrimitive});
    const PreparedRay ray = prepare(view_, given);
    Waiting waiting;
    std::uint32_t child = 0;
    do {
      if (Bvh8Child::isLeaf(child)) {
        best = visitBlocks<counting>(ray, child, best, counts);
        continue;
      }
      const int entered = waiting.pushChildren(ray, tree_.nodes[child], best.t);
      if constexpr (counting) {
        counts.nodes += 1;
        counts.hullTests += kBvh8Width;
        counts.hullHits += entered;
      }
    } while (waiting.pop(best.t, child));
    return best;
  }

  template <bool counting>
  Hit visitBlocks(const PreparedRay& ray, std::uint32_t leaf, const Hit& start,
                  HullCounts& counts) const {
    Hit best = start;
    const std::uint32_t first = Bvh8Child::first(leaf);
    for (std::uint32_t i = first; i < first + Bvh8Child::count(leaf); ++i) {
      const Bvh8Block& block = tree_.blocks[i];
      unsigned bits = candidates(ray, block, best.t);
      if constexpr (counting) {
        counts.primitiveTests += std::popcount(bits);
        counts.falseHullHits += bits == 0 ? 1 : 0;
      }
      for (; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        const auto primitive = static_cast<int>(block.primitives[lane]);
        best = nearer(best, intersect(ray.ray, block, lane), primitive);
      }
    }
    return best;
  }

  /// The report's tests are not geometry only: they get every primitive of the leaf.
  unsigned candidates(const PreparedRay& ray, const Bvh8Block& block, float limit) const {
    if (!view_.intersectorReport && block.kind == Bvh8Kind::triangle) {
      return maybeTriangles(ray, block, limit);
    }
    if (!view_.intersectorReport && block.kind == Bvh8Kind::sphere) {
      return maybeSpheres(ray, block, limit);
    }
    return (1u << block.count) - 1u;
  }

  /// The kernel's own test of a block's primitive.
  float intersect(const Ray& ray, const Bvh8Block& block, std::size_t lane) const {
    const auto corner = [&](int i) {
      return kernel::Vec3<float>(block.values[3 * i][lane], block.values[3 * i + 1][lane],
                                 block.values[3 * i + 2][lane]);
    };
    if (block.kind == Bvh8Kind::triangle) {
      return intersectTriangle(view_, ray, kernel::Triangle<float>{corner(0), corner(1), corner(2)});
    }
    if (block.kind == Bvh8Kind::sphere) {
      return intersectSphere(view_, ray, kernel::Sphere<float>{corner(0), block.values[3][lane]});
    }
    return intersectPrimitive(view_, ray, static_cast<int>(block.primitives[lane]));
  }

  kernel::SceneView view_;
  Bvh8Tree tree_;
};

}  // namespace

std::unique_ptr<HullQuery> TWINTRACE_BVH8(const FlatScene& scene, const RenderOptions& options) {
  return std::make_unique<Bvh8Walk>(scene, options);
}

}  // namespace twintrace
