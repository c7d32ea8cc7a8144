#include "experiments/cast/jury_engines.h"

#include <utility>

#include "common/base/error.h"
#include "cpu/case_engine.h"
#include "cpu/embree_case_engine.h"
#include "gpu/case_engine.h"
#include "gpu/specialisation.h"

namespace twintrace {
namespace {

RenderOptions with(RenderOptions options, Intersector intersector) {
  options.intersector = intersector;
  options.intersectorGiven = true;
  return options;
}

RenderOptions with(RenderOptions options, Precision precision) {
  options.precision = precision;
  return options;
}

void add(JuryBench& bench, const std::string& name, Intersector intersector,
         const RenderOptions& options) {
  const bool robust = intersector == Intersector::robust;
  const std::string label = robust ? name : name + "/report";
  // The report's errors are known; they are listed only if they are asked for.
  const bool listed = robust || options.intersectorGiven;
  try {
    bench.engines.push_back(
        {label, robust, listed, openCaseEngine(name, with(options, intersector))});
  } catch (const DeviceError& error) {
    bench.notes.push_back("without " + label + ": " + error.what());
  }
}

}  // namespace

const std::vector<std::string>& castEngineNames() {
  static const std::vector<std::string> names = {"cpu", "cpu64", "gpu", "embree", "exact", "jury"};
  return names;
}

std::unique_ptr<CaseEngine> openCaseEngine(const std::string& name, const RenderOptions& options) {
  if (name == "embree") return makeEmbreeCaseEngine();
  if (name == "gpu") {
    const RenderOptions ofGpu = with(options, Precision::float32);
    return makeGpuCaseEngine(ofGpu, shaderLibrary(ofGpu));
  }
  const bool wide = name == "cpu64";
  return makeKernelCaseEngine(with(options, wide ? Precision::float64 : Precision::float32));
}

JuryBench openJury(const RenderOptions& options) {
  std::vector<Intersector> intersectors = {Intersector::robust, Intersector::report};
  if (options.intersectorGiven) intersectors = {options.intersector};
  JuryBench bench;
  for (const Intersector intersector : intersectors) {
    for (const char* name : {"gpu", "cpu"}) add(bench, name, intersector, options);
  }
  add(bench, "cpu64", intersectors.front(), options);
  bench.engines.push_back({"embree", false, true, openCaseEngine("embree", options)});
  return bench;
}

}  // namespace twintrace
