// Built with the instrumented copy of cpu/kernel in the place of the original, so that nothing of
// what it includes may show the kernel's types to the rest of the program.

#include "experiments/probe/twin_trace.h"

#include "common/base/flush_denormals.h"
#include "traced_calls.h"

#include <cassert>

namespace twintrace::probe {
namespace {

const kernel::TracedCall* findCall(std::string_view signature) {
  for (const kernel::TracedCall& call : kernel::kTracedCalls) {
    if (call.signature == signature) return &call;
  }
  return nullptr;
}

}  // namespace

CallTrace traceTwin(std::string_view signature, const FlatScene& scene,
                    const RenderOptions& options, const std::uint32_t* inputs,
                    std::uint32_t* outputs) {
  const kernel::TracedCall* twin = findCall(signature);
  assert(twin != nullptr);
  const FlushDenormals flush;
  const kernel::SceneView view = kernel::viewScene(scene, options, nullptr);
  kernel::TraceRecorder recorder;
  const kernel::TraceScope scope(recorder);
  twin->call(view, inputs, outputs);
  return {std::move(recorder.words), {}, recorder.lost};
}

}  // namespace twintrace::probe
