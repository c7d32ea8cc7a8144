#include "experiments/probe/report.h"

#include <fmt/format.h>

#include <bit>

#include "experiments/probe/reference.h"

namespace twintrace::probe {
namespace {

std::string floatText(float value) {
  return fmt::format("{:a} ({:.9g})", value, value);
}

std::string wordText(Kind kind, std::uint32_t word) {
  switch (kind) {
    case Kind::real:
      return floatText(std::bit_cast<float>(word));
    case Kind::integer:
      return std::to_string(static_cast<std::int32_t>(word));
    case Kind::natural:
      return fmt::format("{:#010x}", word);
    case Kind::truth:
      return (word & 1u) != 0u ? "true" : "false";
  }
  return {};
}

std::string doubleText(Kind kind, double value) {
  return kind == Kind::real ? fmt::format("{:a} ({:.17g})", value, value)
                            : wordText(kind, wordOf(kind, value));
}

/// Calls `visit(name, kind, index)` for every word: `ray.direction.x`, its kind and its place.
template <class Visit>
void forEachWord(std::span<const Slot> slots, const Visit& visit) {
  std::size_t index = 0;
  for (const Slot& slot : slots) {
    for (int i = 0; i < slot.size; ++i) {
      const std::string name =
          slot.size == 1 ? slot.path : std::string(slot.path) + "." + "xyzw"[i];
      visit(name, slot.kind, index++);
    }
  }
}

Json histogramJson(const UlpHistogram& ulps) {
  Json json = Json::object();
  for (std::size_t bin = 0; bin < UlpHistogram::kBinCount; ++bin) {
    if (ulps.count(bin) != 0) json[UlpHistogram::label(bin)] = ulps.count(bin);
  }
  return json;
}

Json distancesJson(const ShaderFunction& function, const Distances& distances) {
  Json json = {{"records", distances.ulps.total()},
               {"max_ulp", distances.ulps.largest()},
               {"max_finite_ulp", distances.worstUlps},
               {"ulp", histogramJson(distances.ulps)}};
  if (distances.worst) json["worst"] = recordJson(function, *distances.worst);
  return json;
}

/// Share of records without any distance, what 99 % of them stay within, and the largest; behind it
/// the count of those that no distance describes.
std::string distancesText(const std::optional<Distances>& distances) {
  if (!distances) return fmt::format("{:>9} {:>9} {:>16}", "-", "-", "-");
  const UlpHistogram& ulps = distances->ulps;
  const double exact = 100.0 * static_cast<double>(ulps.count(0)) / static_cast<double>(ulps.total());
  const std::size_t other = ulps.count(UlpHistogram::kBinCount - 1);
  return fmt::format("{:>7.2f} % {:>9} {:>16}", exact, ulps.within(0.99),
                     fmt::format("{}{}", distances->worstUlps,
                                 other != 0 ? fmt::format(" +{}", other) : ""));
}

std::string lineText(const FunctionTrial& trial) {
  const std::string label = fmt::format("{:<44} {:<10}", trial.function->signature,
                                        verdictName(trial.verdict));
  if (trial.records == 0) return label + "\n";
  return fmt::format("{} {:>9} {:>7} {} {}\n", label, trial.records, trial.differing,
                     distancesText(trial.toTwin64), distancesText(trial.toReference));
}

std::string distanceNote(std::uint32_t ulps) {
  if (ulps == 0) return "";
  return ulps == 0xffffffffu ? "  [differs]" : fmt::format("  [{} ulp]", ulps);
}

}  // namespace

Json recordJson(const ShaderFunction& function, const Record& record) {
  Json json = {{"world", record.world}};
  json["words"] = fmt::format("{:#010x}", fmt::join(record.inputs, ","));
  forEachWord(function.inputs, [&](const std::string& name, Kind kind, std::size_t i) {
    json["inputs"][name] = wordText(kind, record.inputs[i]);
  });
  forEachWord(function.outputs, [&](const std::string& name, Kind kind, std::size_t i) {
    json["gpu"][name] = wordText(kind, record.gpu[i]);
    if (!record.twin.empty()) json["float"][name] = wordText(kind, record.twin[i]);
    if (!record.twin64.empty()) json["double"][name] = doubleText(kind, record.twin64[i]);
    if (!record.reference.empty()) json["correctly_rounded"][name] = floatText(record.reference[i]);
  });
  return json;
}

Json trialJson(const FunctionTrial& trial) {
  const ShaderFunction& function = *trial.function;
  Json json = {{"function", function.name},
               {"signature", function.signature},
               {"file", std::string("shaders/") + function.file},
               {"verdict", verdictName(trial.verdict)},
               {"records", trial.records},
               {"differing", trial.differing},
               {"seconds", trial.seconds}};
  if (trial.records == 0) return json;
  json["gpu_to_float"] = distancesJson(function, trial.toTwin);
  if (trial.toTwin64) json["gpu_to_double"] = distancesJson(function, *trial.toTwin64);
  if (trial.toReference) {
    json["gpu_to_correctly_rounded"] = distancesJson(function, *trial.toReference);
    json["gpu_to_correctly_rounded"]["meaning"] = referenceOf(function.signature)->meaning;
  }
  return json;
}

std::string recordText(const ShaderFunction& function, const Record& record) {
  std::string text = fmt::format("{} of shaders/{}, world {}\n", function.signature, function.file,
                                 record.world);
  forEachWord(function.inputs, [&](const std::string& name, Kind kind, std::size_t i) {
    text += fmt::format("  {:<24} {:#010x} {}\n", name, record.inputs[i],
                        wordText(kind, record.inputs[i]));
  });
  forEachWord(function.outputs, [&](const std::string& name, Kind kind, std::size_t i) {
    const auto line = [&](const char* who, const std::string& value, std::uint32_t word) {
      text += fmt::format("  {:<24} {:<8} {}{}\n", name, who, value,
                          distanceNote(wordDistance(kind, record.gpu[i], word)));
    };
    line("gpu", wordText(kind, record.gpu[i]), record.gpu[i]);
    if (!record.twin.empty()) line("float", wordText(kind, record.twin[i]), record.twin[i]);
    if (!record.twin64.empty()) {
      line("double", doubleText(kind, record.twin64[i]), wordOf(kind, record.twin64[i]));
    }
    if (!record.reference.empty()) {
      line("rounded", floatText(record.reference[i]),
           std::bit_cast<std::uint32_t>(record.reference[i]));
    }
  });
  return text;
}

std::string trialsText(const std::vector<FunctionTrial>& trials) {
  std::string text = fmt::format(
      "{0:<44} {0:<10} {0:>9} {0:>7} {1:^36} {2:^36}\n"
      "{3:<44} {4:<10} {5:>9} {6:>7} {7:>9} {8:>9} {9:>16} {7:>9} {8:>9} {9:>16}\n",
      "", "ulp to double", "ulp to correctly rounded", "function", "verdict", "records", "differ",
      "exact", "99 % in", "worst +no number");
  for (const FunctionTrial& trial : trials) text += lineText(trial);
  for (const FunctionTrial& trial : trials) {
    if (trial.verdict != Verdict::differs) continue;
    text += "\nworst record of " + recordText(*trial.function, *trial.toTwin.worst);
  }
  return text;
}

}  // namespace twintrace::probe
