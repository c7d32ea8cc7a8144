#pragma once

#include <memory>

#include "common/cast/case_set.h"
#include "common/trace/options.h"

namespace twintrace {

/// The CPU kernel as a case engine, over all threads: `cpu` in float, `cpu64` in double, whose t and
/// normals are rounded to float at the end. Reads maths, precision, intersector and threads of the
/// options.
std::unique_ptr<CaseEngine> makeKernelCaseEngine(const RenderOptions& options);

}  // namespace twintrace
