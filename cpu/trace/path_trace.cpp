#include "cpu/trace/path_trace.h"

#include "cpu/hull_walk.h"
#include "cpu/trace/entry.h"

namespace twintrace {

CpuPathTracer::CpuPathTracer(std::shared_ptr<const FlatScene> scene, const RenderOptions& options)
    : scene_(std::move(scene)),
      options_(options),
      hull_(makeHullQuery(*scene_, options)),
      program_(tracedKernelProgram()) {}

CallTrace CpuPathTracer::trace(const PixelPosition& pixel, std::uint32_t sample) const {
  return runTracedKernel({scene_.get(), &options_, hull_.get(), pixel.x, pixel.y, sample});
}

}  // namespace twintrace
