#pragma once

// Vectors and numbers of public interfaces to and from those of the kernel.

#include <glm/vec3.hpp>

#include "cpu/kernel/number.h"

namespace twintrace {

template <class R>
kernel::Vec3<R> toKernel(const glm::vec3& v) {
  return {R(v.x), R(v.y), R(v.z)};
}

template <class R>
float toFloat(R x) {
  return static_cast<float>(kernel::plainNumber(x));
}

template <class R>
glm::vec3 toFloats(const kernel::Vec3<R>& v) {
  return {toFloat(v.x), toFloat(v.y), toFloat(v.z)};
}

}  // namespace twintrace
