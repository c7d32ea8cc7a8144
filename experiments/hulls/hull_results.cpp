#include "experiments/hulls/hull_results.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <limits>

#include "experiments/build_info.h"
#include "experiments/machine.h"

namespace twintrace {
namespace {

double perRay(std::int64_t count, const HullRun& run) {
  return run.rays == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(run.rays);
}

double raysPerSecond(const HullRun& run, double seconds) {
  return seconds > 0.0 ? static_cast<double>(run.rays) / seconds : 0.0;
}

double mostSeconds(const HullRun& run) {
  return run.seconds.empty() ? 0.0 : *std::ranges::max_element(run.seconds);
}

bool sameTable(const HullRun& a, const HullRun& b) {
  return a.scene == b.scene && a.kind == b.kind && a.engine == b.engine;
}

std::string breakEvenText(const HullRun& run, const HullRun* sweep) {
  if (sweep == nullptr || &run == sweep || run.seconds.empty()) return "-";
  const double rays = breakEvenRays(run, *sweep);
  return rays == std::numeric_limits<double>::infinity() ? "never" : fmt::format("{:.0f}", rays);
}

std::string tableRow(const HullRun& run, const HullRun* sweep) {
  if (!run.missing.empty()) {
    return fmt::format("  {:<16} skipped: {}\n", run.facts.strategy, run.missing);
  }
  return fmt::format(
      "  {:<16} {:9.3f} {:9.3f} {:9.3f} {:9.2f} {:9.2f} {:8.2f} {:9.2f} {:8.2f} {:7.2f} {:8.4f} {:8.1f} "
      "{:6.2f} {:>11} {:>9}\n",
      run.facts.strategy, 1e-6 * raysPerSecond(run, run.medianSeconds()),
      1e-6 * raysPerSecond(run, mostSeconds(run)), 1e-6 * raysPerSecond(run, run.bestSeconds()),
      perRay(run.totals.hullTests, run), perRay(run.totals.hullHits, run),
      perRay(run.totals.falseHullHits, run), perRay(run.totals.primitiveTests, run),
      perRay(run.totals.nodes, run), perRay(run.totals.heapPushes, run), run.facts.buildSeconds,
      run.facts.bytesPerPrimitive, run.facts.areaRatio, breakEvenText(run, sweep), run.differing);
}

std::string tableHead(const HullRun& run) {
  return fmt::format(
      "{}: {} primitives with bounds, {} {} rays, {} of them hit, engine {}\n"
      "  {:<16} {:>29} {:>9} {:>9} {:>8} {:>9} {:>8} {:>7} {:>8} {:>8} {:>6} {:>11} {:>9}\n"
      "  {:<16} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>9} {:>8} {:>7} {:>8} {:>8} {:>6} {:>11} {:>9}\n",
      run.scene, run.facts.primitives, run.rays, kRayKindNames[static_cast<std::size_t>(run.kind)],
      run.hits, run.engine, "", "million rays a second", "hull", "hull", "false", "primitive", "", "heap",
      "build", "bytes a", "area", "pays from", "differing", "strategy", "median", "min", "max", "tests",
      "hits", "hits", "tests", "nodes", "pushes", "seconds", "primit.", "ratio", "rays", "answers");
}

Json contextJson() {
  const CpuFacts cpu = cpuFacts();
  const BuildInfo build = buildInfo();
  return {{"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
          {"executable", "twintrace"},
          {"num_cpus", cpu.threads},
          {"cpu_model", cpu.model},
          {"instruction_set", cpu.usedInstructionSet},
          {"compiler", build.compiler},
          {"library_build_type", build.buildType == "Release" ? "release" : "debug"}};
}

Json repeatJson(const HullRun& run, std::size_t repeat) {
  const double seconds = run.seconds[repeat];
  return {{"name", runName(run)},
          {"run_name", runName(run)},
          {"run_type", "iteration"},
          {"repetitions", run.seconds.size()},
          {"repetition_index", repeat},
          {"threads", run.threads},
          {"iterations", 1},
          {"real_time", 1e3 * seconds},
          {"cpu_time", 1e3 * seconds},
          {"time_unit", "ms"},
          {"rays", run.rays},
          {"hits", run.hits},
          {"differing", run.differing},
          {"hull_tests", run.totals.hullTests},
          {"hull_hits", run.totals.hullHits},
          {"false_hull_hits", run.totals.falseHullHits},
          {"primitive_tests", run.totals.primitiveTests},
          {"nodes", run.totals.nodes},
          {"heap_pushes", run.totals.heapPushes},
          {"heap_overflows", run.totals.heapOverflows},
          {"primitives", run.facts.primitives},
          {"build_seconds", run.facts.buildSeconds},
          {"bytes_per_primitive", run.facts.bytesPerPrimitive},
          {"sah_cost", run.facts.sahCost},
          {"area_ratio", run.facts.areaRatio},
          {"volume_ratio", run.facts.volumeRatio},
          {"rays_per_second", raysPerSecond(run, seconds)}};
}

}  // namespace

std::string runName(const HullRun& run) {
  return fmt::format("{}/{}/{}/{}", run.scene, run.facts.strategy,
                     kRayKindNames[static_cast<std::size_t>(run.kind)], run.engine);
}

const HullRun* sweepOf(const HullRun& run, std::span<const HullRun> all) {
  const auto found = std::ranges::find_if(all, [&](const HullRun& other) {
    return sameTable(run, other) && other.facts.strategy == "none" && !other.seconds.empty();
  });
  return found == all.end() ? nullptr : &*found;
}

double breakEvenRays(const HullRun& run, const HullRun& sweep) {
  const double saved = sweep.bestSeconds() / static_cast<double>(sweep.rays) -
                       run.bestSeconds() / static_cast<double>(run.rays);
  if (!(saved > 0.0)) return std::numeric_limits<double>::infinity();
  return run.facts.buildSeconds / saved;
}

std::string hullTable(std::span<const HullRun> runs) {
  std::string text;
  std::vector<const HullRun*> done;
  for (const HullRun& first : runs) {
    const auto isShown = [&](const HullRun* other) { return sameTable(*other, first); };
    if (std::ranges::any_of(done, isShown)) continue;
    done.push_back(&first);
    text += tableHead(first);
    for (const HullRun& run : runs) {
      if (sameTable(run, first)) text += tableRow(run, sweepOf(run, runs));
    }
    text += "\n";
  }
  return text;
}

std::string costTable(std::span<const HullCost> costs) {
  std::string text;
  for (const HullCost& cost : costs) {
    text += fmt::format("engine {}, {}: {:.1f} ns a ray + {:.2f} ns a hull test + {:.2f} ns a primitive "
                        "test, off by {:.0f} % on average over {} runs\n",
                        cost.engine, cost.volume, cost.fixed, cost.hullTest, cost.primitiveTest,
                        1e2 * cost.error, cost.runs);
  }
  return text;
}

Json hullJson(std::span<const HullRun> runs, std::span<const HullCost> costs) {
  Json json = {{"context", contextJson()}};
  Json& benchmarks = json["benchmarks"] = Json::array();
  for (const HullRun& run : runs) {
    for (std::size_t i = 0; i < run.seconds.size(); ++i) {
      benchmarks.push_back(repeatJson(run, i));
    }
  }
  Json& list = json["costs"] = Json::array();
  for (const HullCost& cost : costs) {
    list.push_back({{"backend", cost.engine},
                    {"volume", cost.volume},
                    {"fixed_ns", cost.fixed},
                    {"hull_test_ns", cost.hullTest},
                    {"primitive_test_ns", cost.primitiveTest},
                    {"mean_relative_error", cost.error},
                    {"runs", cost.runs}});
  }
  return json;
}

std::string hullCsv(std::span<const HullRun> runs) {
  std::string text =
      "scene,strategy,rays_kind,engine,primitives,rays,hits,differing,median_seconds,least_seconds,"
      "most_seconds,hull_tests,hull_hits,false_hull_hits,primitive_tests,nodes,heap_pushes,"
      "heap_overflows,build_seconds,bytes_per_primitive,sah_cost,area_ratio,volume_ratio\n";
  for (const HullRun& run : runs) {
    const HullTotals& n = run.totals;
    const HullFacts& facts = run.facts;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                        run.scene, facts.strategy,
                        kRayKindNames[static_cast<std::size_t>(run.kind)], run.engine,
                        facts.primitives, run.rays, run.hits, run.differing, run.medianSeconds(),
                        run.bestSeconds(), mostSeconds(run), n.hullTests, n.hullHits,
                        n.falseHullHits, n.primitiveTests, n.nodes, n.heapPushes, n.heapOverflows,
                        facts.buildSeconds, facts.bytesPerPrimitive, facts.sahCost,
                        facts.areaRatio, facts.volumeRatio);
  }
  return text;
}

}  // namespace twintrace
