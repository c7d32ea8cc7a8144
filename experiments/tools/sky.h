#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "common/film/image.h"

namespace twintrace {

/// Size of experiments/scenes/sky.exr, pixels.
inline constexpr int kSkyWidth = 256;
inline constexpr int kSkyHeight = 128;

/// Towards the middle of the sun, unit to rounding: 40 degrees above the horizon.
inline const glm::dvec3 kSunDirection = glm::normalize(glm::dvec3(-0.70, 0.84, 0.71));

/// 0 up to low, 1 from high on, smooth between them.
inline double smoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

inline glm::dvec3 blend(const glm::dvec3& a, const glm::dvec3& b, double share) {
  return a * (1.0 - share) + b * share;
}

/// Radiance from a unit direction. The sun is a soft disk about 30 degrees wide and ten times as
/// bright as the sky around it: bright enough for shadows, large enough to be found by chance.
inline glm::dvec3 skyRadiance(const glm::dvec3& d) {
  const glm::dvec3 zenith(0.16, 0.30, 0.62);
  const glm::dvec3 horizon(0.78, 0.84, 0.90);
  const glm::dvec3 ground(0.20, 0.17, 0.14);
  const glm::dvec3 glow(1.00, 0.72, 0.40);
  const glm::dvec3 sun(10.0, 8.6, 6.6);
  const double rise = 1.0 - std::clamp(d.y, 0.0, 1.0);
  const double nearHorizon = rise * rise * rise;
  const glm::dvec3 above = blend(zenith, horizon, nearHorizon);
  const glm::dvec3 sky = blend(ground, above, smoothStep(-0.06, 0.0, d.y));
  const double towardsSun = glm::dot(d, kSunDirection);
  const double near = std::clamp(towardsSun, 0.0, 1.0);
  const double halo = near * near * near * near;
  return sky + glow * (halo * halo * smoothStep(-0.06, 0.0, d.y)) +
         sun * smoothStep(0.955, 0.975, towardsSun);
}

/// The nearest float with an 11-bit significand. Leaves room for the last bits in which math
/// libraries differ, and packs well.
inline float roundedForFile(double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return std::bit_cast<float>((bits + 0x1000u) & 0xffffe000u);
}

/// The sky of the scene `open` as an equirectangular picture; mapping: the scene format's.
inline Image makeSky() {
  Image image(kSkyWidth, kSkyHeight);
  auto* out = image.rgb.data();
  for (int y = 0; y < kSkyHeight; ++y) {
    const double polar = std::numbers::pi * (y + 0.5) / kSkyHeight;
    for (int x = 0; x < kSkyWidth; ++x) {
      const double azimuth = 2.0 * std::numbers::pi * ((x + 0.5) / kSkyWidth - 0.5);
      const glm::dvec3 d(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                         std::sin(polar) * std::sin(azimuth));
      const glm::dvec3 radiance = skyRadiance(d);
      for (int c = 0; c < 3; ++c) *out++ = roundedForFile(radiance[c]);
    }
  }
  return image;
}

}  // namespace twintrace
