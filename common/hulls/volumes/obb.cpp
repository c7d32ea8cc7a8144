#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "common/hulls/volumes/record.h"

namespace twintrace {
namespace {

constexpr int kSweeps = 12;

/// Turns a symmetric matrix about one pair of axes so that they no longer mix. Jacobi 1846.
void rotatePair(glm::dmat3& matrix, glm::dmat3& axes, int p, int q) {
  if (matrix[p][q] == 0.0) return;
  const double theta = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  glm::dmat3 turn(1.0);
  turn[p][p] = c;
  turn[q][q] = c;
  turn[p][q] = -s;
  turn[q][p] = s;
  matrix = glm::transpose(turn) * matrix * turn;
  axes = axes * turn;
}

/// The eigenvectors of a symmetric matrix, as columns.
glm::dmat3 eigenvectors(glm::dmat3 matrix) {
  glm::dmat3 axes(1.0);
  for (int i = 0; i < kSweeps; ++i) {
    rotatePair(matrix, axes, 0, 1);
    rotatePair(matrix, axes, 0, 2);
    rotatePair(matrix, axes, 1, 2);
  }
  return axes;
}

/// The axes along which the shapes' points spread most and least.
glm::dmat3 principalAxes(const ShapeRange& shapes) {
  glm::dvec3 sum(0.0);
  double count = 0.0;
  const auto forEachPoint = [&](const auto& visit) {
    for (const ConvexShape& shape : shapes) {
      for (int i = 0; i < shape.count; ++i) visit(shape.points[static_cast<std::size_t>(i)]);
    }
  };
  forEachPoint([&](const glm::dvec3& p) {
    sum += p;
    count += 1.0;
  });
  const glm::dvec3 mean = sum / count;
  glm::dmat3 spread(0.0);
  forEachPoint([&](const glm::dvec3& p) { spread += glm::outerProduct(p - mean, p - mean); });
  return eigenvectors(spread);
}

struct Fitted {
  glm::vec3 center;
  glm::mat3 axes;
  glm::vec3 half;

  double halfArea() const {
    return double(half.x) * half.y + double(half.y) * half.z + double(half.z) * half.x;
  }
};

/// The tightest box along the axes once these and its center are rounded to float.
Fitted along(const glm::dmat3& wanted, const ShapeRange& shapes) {
  Fitted box;
  box.axes = glm::mat3(wanted);
  const glm::dmat3 axes(box.axes);
  std::array<double, 3> low, high;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    low[at] = high[at] = -std::numeric_limits<double>::infinity();
    for (const ConvexShape& shape : shapes) {
      high[at] = std::max(high[at], shape.support(axes[i]));
      low[at] = std::max(low[at], shape.support(-axes[i]));
    }
  }
  const glm::dvec3 middle((high[0] - low[0]) / 2.0, (high[1] - low[1]) / 2.0,
                          (high[2] - low[2]) / 2.0);
  box.center = glm::vec3(glm::transpose(glm::inverse(axes)) * middle);
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double center = glm::dot(axes[i], glm::dvec3(box.center));
    box.half[i] = roundedUp(std::max(high[at] - center, low[at] + center));
  }
  return box;
}

void fit(const HullVolume&, const ShapeRange& shapes, std::span<glm::uvec4> record) {
  Fitted box = along(principalAxes(shapes), shapes);
  const Fitted aligned = along(glm::dmat3(1.0), shapes);
  if (!(box.halfArea() < aligned.halfArea())) box = aligned;
  record[0] = recordTexel(box.center);
  for (int i = 0; i < 3; ++i) record[static_cast<std::size_t>(1 + i)] = recordTexel(box.axes[i]);
  record[4] = recordTexel(box.half);
}

double area(const HullVolume&, std::span<const glm::uvec4> record) {
  const glm::dvec3 h = recordVector(record[4]);
  return 8.0 * (h.x * h.y + h.y * h.z + h.z * h.x);
}

double content(const HullVolume&, std::span<const glm::uvec4> record) {
  const glm::dvec3 h = recordVector(record[4]);
  return 8.0 * h.x * h.y * h.z;
}

}  // namespace

HullVolume obbVolume() {
  return {"obb", 5, 1, fit, area, content};
}

}  // namespace twintrace
