#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "common/scene/flat_scene.h"

namespace twintrace {

/// A primitive as hulls see it: the convex hull of a few points, grown by a radius. In double, from the
/// floats of its record, which count as exact.
struct ConvexShape {
  std::array<glm::dvec3, 8> points;
  int count = 0;
  double radius = 0.0;

  /// The largest n . p over the shape. @param n of any length
  double support(const glm::dvec3& n) const;
};

/// A primitive below `scene.index.boundedCount()`.
ConvexShape convexShape(const FlatScene& scene, int primitive);

/// The shapes of some primitives, one after the other.
class ShapeRange {
 public:
  class Iterator {
   public:
    Iterator(const FlatScene& scene, const std::uint32_t* at) : scene_(&scene), at_(at) {}
    ConvexShape operator*() const { return convexShape(*scene_, static_cast<int>(*at_)); }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return at_ != other.at_; }

   private:
    const FlatScene* scene_;
    const std::uint32_t* at_;
  };

  ShapeRange(const FlatScene& scene, std::span<const std::uint32_t> primitives)
      : scene_(scene), primitives_(primitives) {}

  Iterator begin() const { return {scene_, primitives_.data()}; }
  Iterator end() const { return {scene_, primitives_.data() + primitives_.size()}; }
  std::size_t size() const { return primitives_.size(); }

 private:
  const FlatScene& scene_;
  std::span<const std::uint32_t> primitives_;
};

/// An axis-aligned box in float.
struct Bounds {
  glm::vec3 low;
  glm::vec3 high;

  void add(const Bounds& other);
  void add(const glm::vec3& point);
  glm::vec3 center() const { return low * 0.5f + high * 0.5f; }
  /// Half the surface area; 0 for nothing at all.
  float halfArea() const;

  static Bounds nothing();
};

/// The bounds of a shape, rounded outward.
Bounds boundsOf(const ConvexShape& shape);

/// Floats on either side of a double, or the float that it is.
float roundedDown(double x);
float roundedUp(double x);

}  // namespace twintrace
