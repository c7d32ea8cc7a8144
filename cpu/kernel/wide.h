#pragma once

// Wide number types: one lane per ray, of the width that this translation unit is compiled for
// (4 for SSE2, 8 for AVX2, 16 for AVX-512). std::experimental::simd was the fastest of the libraries
// measured (xsimd 8.1 and Highway 1.0.3 lost 5 to 25 %, and Highway has no SSE2). Minimum and
// maximum are the processor's own instruction, which drops a NaN exactly as least and greatest say.

#include <immintrin.h>

#include <experimental/simd>

#include "cpu/kernel/ray.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

namespace stdx = std::experimental;
using SimdFloat = stdx::native_simd<float>;
using SimdInt = stdx::rebind_simd_t<std::int32_t, SimdFloat>;
using SimdUint = stdx::rebind_simd_t<std::uint32_t, SimdFloat>;
using SimdMask = SimdFloat::mask_type;
using SimdDouble = stdx::rebind_simd_t<double, SimdFloat>;

inline constexpr int kLanes = static_cast<int>(SimdFloat::size());

struct WideMask {
  SimdMask value;

  TWINTRACE_INLINE WideMask() {}
  TWINTRACE_INLINE explicit WideMask(bool all) : value(all) {}
  TWINTRACE_INLINE WideMask(SimdMask v) : value(v) {}
  TWINTRACE_INLINE static WideMask ofInts(SimdInt::mask_type v) { return std::bit_cast<SimdMask>(v); }
  TWINTRACE_INLINE bool lane(int i) const { return value[i]; }

  friend TWINTRACE_INLINE WideMask operator&&(WideMask a, WideMask b) { return a.value && b.value; }
  friend TWINTRACE_INLINE WideMask operator||(WideMask a, WideMask b) { return a.value || b.value; }
  friend TWINTRACE_INLINE WideMask operator!=(WideMask a, WideMask b) { return a.value ^ b.value; }
  friend TWINTRACE_INLINE WideMask operator!(WideMask a) { return !a.value; }
};

struct WideFloat {
  SimdFloat value;

  TWINTRACE_INLINE WideFloat() {}
  TWINTRACE_INLINE WideFloat(float all) : value(all) {}
  TWINTRACE_INLINE WideFloat(SimdFloat v) : value(v) {}
  TWINTRACE_INLINE float lane(int i) const { return value[i]; }

  friend TWINTRACE_INLINE WideFloat operator+(WideFloat a, WideFloat b) { return a.value + b.value; }
  friend TWINTRACE_INLINE WideFloat operator-(WideFloat a, WideFloat b) { return a.value - b.value; }
  friend TWINTRACE_INLINE WideFloat operator*(WideFloat a, WideFloat b) { return a.value * b.value; }
  friend TWINTRACE_INLINE WideFloat operator/(WideFloat a, WideFloat b) { return a.value / b.value; }
  friend TWINTRACE_INLINE WideFloat operator-(WideFloat a) { return -a.value; }
  friend TWINTRACE_INLINE WideMask operator<(WideFloat a, WideFloat b) { return a.value < b.value; }
  friend TWINTRACE_INLINE WideMask operator>(WideFloat a, WideFloat b) { return a.value > b.value; }
  friend TWINTRACE_INLINE WideMask operator<=(WideFloat a, WideFloat b) { return a.value <= b.value; }
  friend TWINTRACE_INLINE WideMask operator>=(WideFloat a, WideFloat b) { return a.value >= b.value; }
  friend TWINTRACE_INLINE WideMask operator==(WideFloat a, WideFloat b) { return a.value == b.value; }
};

/// Where a mask of doubles holds, as a mask of floats.
TWINTRACE_INLINE WideMask narrowMask(SimdDouble::mask_type mask) {
  SimdDouble holds = 0.0;
  stdx::where(mask, holds) = 1.0;
  return stdx::static_simd_cast<SimdFloat>(holds) > 0.0f;
}

struct WideDouble {
  SimdDouble value;

  TWINTRACE_INLINE WideDouble() {}
  TWINTRACE_INLINE WideDouble(float all) : value(static_cast<double>(all)) {}
  TWINTRACE_INLINE WideDouble(SimdDouble v) : value(v) {}

  friend TWINTRACE_INLINE WideDouble operator+(WideDouble a, WideDouble b) { return a.value + b.value; }
  friend TWINTRACE_INLINE WideDouble operator-(WideDouble a, WideDouble b) { return a.value - b.value; }
  friend TWINTRACE_INLINE WideDouble operator*(WideDouble a, WideDouble b) { return a.value * b.value; }
  friend TWINTRACE_INLINE WideDouble operator/(WideDouble a, WideDouble b) { return a.value / b.value; }
  friend TWINTRACE_INLINE WideDouble operator-(WideDouble a) { return -a.value; }
  friend TWINTRACE_INLINE WideMask operator<(WideDouble a, WideDouble b) {
    return narrowMask(a.value < b.value);
  }
  friend TWINTRACE_INLINE WideMask operator>(WideDouble a, WideDouble b) {
    return narrowMask(a.value > b.value);
  }
  friend TWINTRACE_INLINE WideMask operator<=(WideDouble a, WideDouble b) {
    return narrowMask(a.value <= b.value);
  }
  friend TWINTRACE_INLINE WideMask operator>=(WideDouble a, WideDouble b) {
    return narrowMask(a.value >= b.value);
  }
};

struct WideInt {
  SimdInt value;

  TWINTRACE_INLINE WideInt() {}
  TWINTRACE_INLINE WideInt(std::int32_t all) : value(all) {}
  TWINTRACE_INLINE WideInt(SimdInt v) : value(v) {}
  TWINTRACE_INLINE std::int32_t lane(int i) const { return value[i]; }

  friend TWINTRACE_INLINE WideInt operator+(WideInt a, WideInt b) { return a.value + b.value; }
  friend TWINTRACE_INLINE WideInt operator-(WideInt a, WideInt b) { return a.value - b.value; }
  friend TWINTRACE_INLINE WideInt operator*(WideInt a, WideInt b) { return a.value * b.value; }
  friend TWINTRACE_INLINE WideInt operator&(WideInt a, WideInt b) { return a.value & b.value; }
  friend TWINTRACE_INLINE WideInt operator|(WideInt a, WideInt b) { return a.value | b.value; }
  friend TWINTRACE_INLINE WideInt operator<<(WideInt a, int n) { return a.value << n; }
  friend TWINTRACE_INLINE WideInt operator>>(WideInt a, int n) { return a.value >> n; }
  friend TWINTRACE_INLINE WideMask operator<(WideInt a, WideInt b) {
    return WideMask::ofInts(a.value < b.value);
  }
  friend TWINTRACE_INLINE WideMask operator>=(WideInt a, WideInt b) {
    return WideMask::ofInts(a.value >= b.value);
  }
  friend TWINTRACE_INLINE WideMask operator==(WideInt a, WideInt b) {
    return WideMask::ofInts(a.value == b.value);
  }
  friend TWINTRACE_INLINE WideMask operator!=(WideInt a, WideInt b) {
    return WideMask::ofInts(a.value != b.value);
  }
};

struct WideUint {
  SimdUint value;

  TWINTRACE_INLINE WideUint() {}
  TWINTRACE_INLINE WideUint(std::uint32_t all) : value(all) {}
  TWINTRACE_INLINE WideUint(SimdUint v) : value(v) {}

  friend TWINTRACE_INLINE WideUint operator+(WideUint a, WideUint b) { return a.value + b.value; }
  friend TWINTRACE_INLINE WideUint operator*(WideUint a, WideUint b) { return a.value * b.value; }
  friend TWINTRACE_INLINE WideUint operator^(WideUint a, WideUint b) { return a.value ^ b.value; }
  friend TWINTRACE_INLINE WideUint operator>>(WideUint a, WideUint b) { return a.value >> b.value; }
  friend TWINTRACE_INLINE WideUint operator>>(WideUint a, unsigned n) {
    return a.value >> static_cast<int>(n);
  }
};

template <>
struct NumberTraits<WideFloat> {
  using Mask = WideMask;
  using Int = WideInt;
  using Uint = WideUint;
  using Noise = WideFloat;
  using Wider = WideDouble;
  static constexpr bool native = false;
};

TWINTRACE_INLINE bool anyLane(WideMask condition) { return stdx::any_of(condition.value); }

TWINTRACE_INLINE WideFloat select(WideMask condition, WideFloat a, WideFloat b) {
  stdx::where(condition.value, b.value) = a.value;
  return b;
}
TWINTRACE_INLINE WideInt select(WideMask condition, WideInt a, WideInt b) {
  stdx::where(std::bit_cast<SimdInt::mask_type>(condition.value), b.value) = a.value;
  return b;
}
TWINTRACE_INLINE WideUint select(WideMask condition, WideUint a, WideUint b) {
  stdx::where(std::bit_cast<SimdUint::mask_type>(condition.value), b.value) = a.value;
  return b;
}
TWINTRACE_INLINE WideMask select(WideMask condition, WideMask a, WideMask b) {
  return (condition && a) || (!condition && b);
}

// The instruction returns its second operand when either is NaN: (b, a) is `b < a ? b : a`.
#if defined(__AVX512F__)
TWINTRACE_INLINE WideFloat least(WideFloat a, WideFloat b) {
  return SimdFloat(_mm512_min_ps(static_cast<__m512>(b.value), static_cast<__m512>(a.value)));
}
TWINTRACE_INLINE WideFloat greatest(WideFloat a, WideFloat b) {
  return SimdFloat(_mm512_max_ps(static_cast<__m512>(b.value), static_cast<__m512>(a.value)));
}
#elif defined(__AVX2__)
TWINTRACE_INLINE WideFloat least(WideFloat a, WideFloat b) {
  return SimdFloat(_mm256_min_ps(static_cast<__m256>(b.value), static_cast<__m256>(a.value)));
}
TWINTRACE_INLINE WideFloat greatest(WideFloat a, WideFloat b) {
  return SimdFloat(_mm256_max_ps(static_cast<__m256>(b.value), static_cast<__m256>(a.value)));
}
#else
TWINTRACE_INLINE WideFloat least(WideFloat a, WideFloat b) {
  return SimdFloat(_mm_min_ps(static_cast<__m128>(b.value), static_cast<__m128>(a.value)));
}
TWINTRACE_INLINE WideFloat greatest(WideFloat a, WideFloat b) {
  return SimdFloat(_mm_max_ps(static_cast<__m128>(b.value), static_cast<__m128>(a.value)));
}
#endif

TWINTRACE_INLINE WideFloat absolute(WideFloat x) { return stdx::abs(x.value); }
TWINTRACE_INLINE WideFloat floorOf(WideFloat x) { return stdx::floor(x.value); }
TWINTRACE_INLINE WideFloat rootOf(WideFloat x) { return stdx::sqrt(x.value); }
TWINTRACE_INLINE WideDouble rootOf(WideDouble x) { return stdx::sqrt(x.value); }
TWINTRACE_INLINE WideDouble wider(WideFloat x) {
  return stdx::static_simd_cast<SimdDouble>(x.value);
}
TWINTRACE_INLINE WideFloat nearestFloat(WideDouble x) {
  return stdx::static_simd_cast<SimdFloat>(x.value);
}
TWINTRACE_INLINE WideInt toInt(WideFloat x) { return stdx::static_simd_cast<SimdInt>(x.value); }
TWINTRACE_INLINE WideInt bitsOf(WideFloat x) { return std::bit_cast<SimdInt>(x.value); }
TWINTRACE_INLINE WideFloat floatFromBits(WideInt bits) { return std::bit_cast<SimdFloat>(bits.value); }
TWINTRACE_INLINE WideInt toSigned(WideUint x) { return std::bit_cast<SimdInt>(x.value); }
TWINTRACE_INLINE WideUint toUnsigned(WideInt x) { return std::bit_cast<SimdUint>(x.value); }

template <class R>
TWINTRACE_INLINE R toNumber(WideInt x) {
  return R(stdx::static_simd_cast<SimdFloat>(x.value));
}

template <class R>
TWINTRACE_INLINE R numberFromBits(WideUint bits) {
  return R(std::bit_cast<SimdFloat>(bits.value));
}

/// Gives one record to the lanes of a mask.
template <std::size_t wordCount>
TWINTRACE_INLINE void deal(const std::uint32_t* source, WideMask lanes,
                           SimdUint (&words)[wordCount]) {
  const auto mask = std::bit_cast<SimdUint::mask_type>(lanes.value);
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((stdx::where(mask, words[i]) = SimdUint(source[i])), ...);
  }(std::make_index_sequence<wordCount>());
}

/// A record per lane, by broadcasting whole records to the lanes that want them: several times faster
/// than gathering word by word. Small tables are gone through in order, so that no step waits for the
/// one before; in large ones each distinct record that a lane asks for is dealt once.
template <class R, int texelCount>
TWINTRACE_INLINE TexelBlock<R, texelCount> fetchRecord(const SceneView& scene, int table, int stride,
                                                       WideInt index, int count) {
  SimdUint words[4 * texelCount] = {};
  const std::uint32_t* first = scene.words + std::size_t{4} * table;
  const std::size_t step = std::size_t{4} * stride;
  if (count <= kLanes) {
    for (int i = 0; i < count; ++i) deal(first + i * step, index == WideInt(i), words);
  } else {
    alignas(64) std::int32_t wanted[kLanes];
    index.value.copy_to(wanted, stdx::vector_aligned);
    WideMask missing(true);
    while (anyLane(missing)) {
      const std::int32_t record = wanted[stdx::find_first_set(missing.value)];
      const WideMask here = index == WideInt(record);
      deal(first + static_cast<std::size_t>(record) * step, here, words);
      missing = missing && !here;
    }
  }
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return TexelBlock<R, texelCount>{{WideUint(words[i])...}};
  }(std::make_index_sequence<4 * texelCount>());
}

/// The answers of the scene's hull structure, lane by lane.
inline Hit<WideFloat> queryHull(const SceneView& scene, const Ray<WideFloat>& ray) {
  Hit<WideFloat> hit{ray.tmax, WideInt(kNoPrimitive)};
  for (int i = 0; i < kLanes; ++i) {
    const HullQueryRay<float> query{
        {ray.origin.x.lane(i), ray.origin.y.lane(i), ray.origin.z.lane(i)},
        {ray.direction.x.lane(i), ray.direction.y.lane(i), ray.direction.z.lane(i)},
        ray.tmin.lane(i),
        ray.tmax.lane(i)};
    float t = 0.0f;
    const int primitive = scene.hull->closest(query, t);
    if (primitive == kNoPrimitive) continue;
    hit.t.value[i] = t;
    hit.primitive.value[i] = primitive;
  }
  return hit;
}

TWINTRACE_KERNEL_END
