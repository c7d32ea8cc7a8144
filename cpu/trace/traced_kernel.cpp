// Built with the instrumented copy of cpu/kernel in the place of the original; see instrument.py.

#include "common/base/flush_denormals.h"
#include "cpu/kernel/integrator.h"
#include "cpu/trace/entry.h"
#include "traced_tables.h"

#include <sstream>
#include <string>

namespace twintrace {
namespace {

template <class R>
CallTrace run(const TraceJob& job) {
  const FlushDenormals flush;
  const kernel::SceneView scene = kernel::viewScene(*job.scene, *job.options, job.hull);
  const kernel::Frame frame{job.scene->width, job.options->bounces, 1, job.sample,
                            job.options->seed};
  kernel::TraceRecorder recorder;
  const kernel::TraceScope scope(recorder);
  kernel::PathState<R> state = kernel::beginSample<R>(scene, job.x, job.y, job.sample, frame);
  while (state.alive) state = kernel::stepSample(scene, state, frame);
  const auto number = [](R value) { return static_cast<float>(kernel::plainNumber(value)); };
  return {std::move(recorder.words),
          {number(state.radiance.x), number(state.radiance.y), number(state.radiance.z)},
          recorder.lost};
}

WordKind kindOf(char letter) {
  switch (letter) {
    case 'i':
      return WordKind::integer;
    case 'n':
      return WordKind::natural;
    case 't':
      return WordKind::truth;
    default:
      return WordKind::real;
  }
}

/// Calls `use` with the two words of each part of `first second;first second`.
template <class Use>
void eachPair(const char* text, Use use) {
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');) {
    const std::size_t blank = part.find(' ');
    use(part.substr(0, blank), part.substr(blank + 1));
  }
}

}  // namespace

CallTrace runTracedKernel(const TraceJob& job) {
  if (job.options->precision == Precision::float64) return run<double>(job);
  if (job.options->maths == Maths::native) return run<kernel::NativeFloat>(job);
  return run<float>(job);
}

TraceProgram tracedKernelProgram() {
  TraceProgram program;
  for (const TracedFunctionRow& row : kTracedFunctions) {
    TraceFunction function{row.name, row.result, {}, row.place};
    eachPair(row.parameters, [&](const std::string& type, const std::string& name) {
      function.parameters.push_back({type, name});
    });
    program.functions.push_back(std::move(function));
  }
  for (const TraceSiteRow& row : kTraceSites) {
    TraceSite site{row.kind, row.function, row.place, {}, row.text};
    eachPair(row.slots, [&](const std::string& kind, const std::string& path) {
      site.slots.push_back({path, kindOf(kind.front())});
    });
    program.sites.push_back(std::move(site));
  }
  return program;
}

}  // namespace twintrace
