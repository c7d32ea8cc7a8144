#include "experiments/probe/statement_report.h"

#include <fmt/format.h>

#include "experiments/explain/statement_text.h"

namespace twintrace::probe {
namespace {

const SideNames kSides = {"gpu", "float"};

const Call& callOf(const StatementReplay& replay) {
  return replay.gpuTree.calls[static_cast<std::size_t>(replay.divergence->a)];
}

/// The driver may compile the instrumented text otherwise, most of all in native maths.
bool tracedAsPlain(const ShaderFunction& function, const Record& record,
                   const StatementReplay& replay) {
  return !differ(function, record.gpu, replay.gpu.outputs);
}

std::vector<std::string> notes(const ShaderFunction& function, const Record& record,
                               const StatementReplay& replay) {
  std::vector<std::string> found;
  const bool plainDiffers = differ(function, record.gpu, record.twin);
  if (!tracedAsPlain(function, record, replay)) {
    found.push_back(plainDiffers && !differ(function, replay.gpu.outputs, record.twin)
                        ? "the shader with its statements traced no longer shows the difference"
                        : "the shader with its statements traced does not answer as the plain one");
  }
  if (plainDiffers && !replay.divergence && found.empty()) {
    found.emplace_back("nothing that was traced differs");
  }
  if (replay.gpu.trace.lost > 0) {
    found.push_back(fmt::format("{} events found no room in the trace", replay.gpu.trace.lost));
  }
  return found;
}

}  // namespace

std::string statementsText(const ShaderFunction& function, const Record& record,
                           const StatementReplay& replay) {
  std::string text;
  for (const std::string& note : notes(function, record, replay)) text += "note: " + note + "\n";
  if (!replay.divergence) {
    const bool agree = !differ(function, record.gpu, record.twin);
    return text + (agree ? "the results agree: no statement is named\n" : "");
  }
  if (replay.culprit() != function.name) {
    const TracedValues& inputs = callOf(replay).inputs;
    text += fmt::format("the difference comes from a call of {} inside\n", replay.culprit());
    for (std::size_t i = 0; i < inputs.words.size(); ++i) {
      const TraceSlot& slot = inputs.site->slots[i];
      text += fmt::format("  {:<24} {:#010x} {}\n", slot.path, inputs.words[i],
                          wordText(slot.kind, inputs.words[i]));
    }
  }
  return text + statementText(replay.divergence->statement, kSides);
}

Json statementsJson(const ShaderFunction& function, const Record& record,
                    const StatementReplay& replay) {
  Json json = {{"traced_as_plain", tracedAsPlain(function, record, replay)},
               {"notes", notes(function, record, replay)},
               {"function", nullptr}};
  if (!replay.divergence) return json;
  const TracedValues& inputs = callOf(replay).inputs;
  json["function"] = replay.culprit();
  for (std::size_t i = 0; i < inputs.words.size(); ++i) {
    const TraceSlot& slot = inputs.site->slots[i];
    json["inputs"][slot.path] = wordJson(slot.kind, inputs.words[i]);
  }
  json["statement"] = statementJson(replay.divergence->statement, kSides);
  json["differing"] = differingJson(replay.divergence->statement, kSides);
  return json;
}

}  // namespace twintrace::probe
