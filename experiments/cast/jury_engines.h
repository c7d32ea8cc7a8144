#pragma once

#include <string>
#include <vector>

#include "common/trace/options.h"
#include "experiments/cast/jury.h"

namespace twintrace {

/// Names for --engine.
const std::vector<std::string>& castEngineNames();

/// Opens one engine: cpu, cpu64, gpu or embree.
/// @throws DeviceError if there is none on this machine.
std::unique_ptr<CaseEngine> openCaseEngine(const std::string& name, const RenderOptions& options);

/// The engines of a jury, and what is missing.
struct JuryBench {
  std::vector<JuryEngine> engines;
  std::vector<std::string> notes;
};

/// Opens gpu and cpu with both intersectors, or only the one that the options name, cpu64 and
/// embree. Without a GL provider the jury goes on without the GPU, and a note says so.
JuryBench openJury(const RenderOptions& options);

}  // namespace twintrace
