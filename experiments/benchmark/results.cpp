#include "experiments/benchmark/results.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "experiments/build_info.h"
#include "experiments/machine.h"

namespace twintrace {
namespace {

std::string verdict(const Ratio& ratio, const std::optional<double>& value) {
  if (!value) return fmt::format("{:>8} {:<7}", "-", "unknown");
  return fmt::format("{:8.2f} {:<7}", *value, ratio.holds(*value) ? "PASS" : "MISSED");
}

nlohmann::json contextJson() {
  const CpuFacts cpu = cpuFacts();
  const BuildInfo build = buildInfo();
  return {{"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
          {"executable", "twintrace_benchmark"},
          {"num_cpus", cpu.threads},
          {"cpu_model", cpu.model},
          {"instruction_set", cpu.usedInstructionSet},
          {"compiler", build.compiler},
          {"library_build_type", build.buildType == "Release" ? "release" : "debug"}};
}

nlohmann::json repeatJson(const SceneTimes& scene, const ArmTimes& arm, std::size_t repeat) {
  const double wall = arm.wallSeconds[repeat];
  const double cpu = arm.cpuSeconds[repeat];
  const std::string name = scene.scene + "/" + arm.arm;
  return {{"name", name},
          {"run_name", name},
          {"run_type", "iteration"},
          {"repetitions", arm.wallSeconds.size()},
          {"repetition_index", repeat},
          {"threads", scene.threads},
          {"iterations", arm.frames},
          {"real_time", 1e3 * wall / arm.frames},
          {"cpu_time", 1e3 * cpu / arm.frames},
          {"time_unit", "ms"},
          {"items_per_second", arm.samplesPerRepeat / wall}};
}

nlohmann::json ratioJson(const Ratio& ratio) {
  nlohmann::json json = {{"name", ratio.name},
                         {"bound", ratio.bound},
                         {"sense", ratio.atMost ? "at most" : "at least"},
                         {"wall", nullptr},
                         {"cpu", nullptr}};
  if (ratio.wall) json["wall"] = *ratio.wall;
  if (ratio.cpu) json["cpu"] = *ratio.cpu;
  return json;
}

}  // namespace

std::string ratesTable(const SceneTimes& times) {
  std::string table =
      fmt::format("{}: millions of samples per second\n  {:<30} {:>8} {:>9} {:>9}\n", times.scene,
                  "arm", "wall", "cpu time", "max/min");
  for (const ArmTimes& arm : times.arms) {
    if (!arm.measured()) {
      table += fmt::format("  {:<30} skipped: {}\n", arm.arm, arm.missing);
      continue;
    }
    const auto [least, most] = std::minmax_element(arm.wallSeconds.begin(), arm.wallSeconds.end());
    table += fmt::format("  {:<30} {:8.2f} {:9.2f} {:9.2f}\n", arm.arm,
                         bestRate(arm, Clock::wall, times.threads),
                         bestRate(arm, Clock::cpu, times.threads), *most / *least);
  }
  return table;
}

std::string ratiosTable(const std::vector<Ratio>& ratios) {
  std::string table =
      fmt::format("  {:<42} {:>8}  {:<16} {}\n", "ratio", "bound", "    wall", "cpu time");
  for (const Ratio& ratio : ratios) {
    table += fmt::format("  {:<42} {:>2} {:5.2f} {} {}\n", ratio.name,
                         ratio.atMost ? "<=" : ">=", ratio.bound, verdict(ratio, ratio.wall),
                         verdict(ratio, ratio.cpu));
  }
  return table;
}

nlohmann::json resultsJson(const std::vector<SceneTimes>& scenes,
                           const std::vector<Ratio>& ratios) {
  nlohmann::json json = {{"context", contextJson()}};
  nlohmann::json& benchmarks = json["benchmarks"] = nlohmann::json::array();
  for (const SceneTimes& scene : scenes) {
    for (const ArmTimes& arm : scene.arms) {
      for (std::size_t repeat = 0; repeat < arm.wallSeconds.size(); ++repeat) {
        benchmarks.push_back(repeatJson(scene, arm, repeat));
      }
    }
  }
  nlohmann::json& list = json["ratios"] = nlohmann::json::array();
  for (const Ratio& ratio : ratios) list.push_back(ratioJson(ratio));
  return json;
}

}  // namespace twintrace
