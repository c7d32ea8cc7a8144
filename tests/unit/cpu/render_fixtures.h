#pragma once

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/scene/flat_scene.h"
#include "common/scene/reader.h"
#include "cpu/tracer.h"

namespace twintrace::test {

inline Scene shippedScene(const std::string& name) {
  return readScene(std::filesystem::path(TWINTRACE_SOURCE_DIR) / "experiments" / "scenes" /
                   (name + ".toml"));
}

/// The scene's options for a square film and one integrator, which implies the intersector.
inline RenderOptions squareOptions(const Scene& scene, int size, Integrator integrator) {
  RenderOptions options = scene.render;
  options.width = size;
  options.height = size;
  options.integrator = integrator;
  options.intersector =
      integrator == Integrator::report ? Intersector::report : Intersector::robust;
  return options;
}

inline std::unique_ptr<Renderer> cpuRendererOf(const Scene& scene, const RenderOptions& options,
                                               const CpuTracerSettings& settings = {}) {
  return makeCpuRenderer(std::make_shared<const FlatScene>(flatten(scene, options)), options,
                         settings);
}

/// Sums of one frame from sample `firstSample` on, options.passes samples.
inline std::vector<float> frameSums(const Scene& scene, const RenderOptions& options,
                                    const CpuTracerSettings& settings = {},
                                    std::uint32_t firstSample = 0) {
  std::vector<float> sums(static_cast<std::size_t>(options.width) *
                          static_cast<std::size_t>(options.height) * 3);
  cpuRendererOf(scene, options, settings)->renderFrame(firstSample, options.passes, sums);
  return sums;
}

/// Mean of independent values and its standard error.
struct Estimate {
  double mean = 0.0;
  double error = 0.0;
};

inline Estimate estimateOf(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  Estimate estimate;
  for (const double value : values) estimate.mean += value / n;
  double squares = 0.0;
  for (const double value : values) squares += std::pow(value - estimate.mean, 2.0);
  estimate.error = std::sqrt(squares / (n - 1.0) / n);
  return estimate;
}

}  // namespace twintrace::test
