// The cost model, the heat map and what is written of a measurement.

#include <limits>

#include "experiments/hulls/heat_map.h"
#include "experiments/hulls/hull_page.h"
#include "experiments/hulls/hull_results.h"
#include "tests/catch.h"

using namespace twintrace;
using Catch::Matchers::Contains;

namespace {

HullRun runOf(const std::string& strategy, std::int64_t hullTests, std::int64_t primitiveTests,
              double seconds) {
  HullRun run;
  run.scene = "made-up";
  run.facts.strategy = strategy;
  run.facts.primitives = 100;
  run.facts.buildSeconds = strategy == "none" ? 0.0 : 0.5;
  run.engine = "cpu";
  run.rays = 1000;
  run.hits = 400;
  run.totals.hullTests = hullTests;
  run.totals.primitiveTests = primitiveTests;
  run.seconds = {2.0 * seconds, seconds, 3.0 * seconds};
  return run;
}

/// Runs whose times follow 20 ns + 5 ns a hull test + 8 ns a primitive test.
std::vector<HullRun> lawfulRuns() {
  std::vector<HullRun> runs;
  const auto add = [&](const std::string& strategy, double hullTests, double primitiveTests) {
    const double nanoseconds = 20.0 + 5.0 * hullTests + 8.0 * primitiveTests;
    runs.push_back(runOf(strategy, static_cast<std::int64_t>(1000 * hullTests),
                         static_cast<std::int64_t>(1000 * primitiveTests), 1e-6 * nanoseconds));
  };
  add("none", 0, 100);
  add("none", 0, 30);
  add("bvh", 12, 2);
  add("bvh", 30, 5);
  add("bvh-median", 40, 3);
  return runs;
}

}  // namespace

TEST_CASE("a run's best and median time are those of its repeats", "[hulls]") {
  HullRun run = runOf("bvh", 1, 1, 1.0);
  CHECK(run.bestSeconds() == 1.0);
  CHECK(run.medianSeconds() == 2.0);
  run.seconds = {4.0, 1.0, 2.0, 3.0};
  CHECK(run.medianSeconds() == 2.5);
  run.seconds = {};
  CHECK(run.medianSeconds() == 0.0);
}

TEST_CASE("the cost model finds the law that times follow", "[hulls]") {
  const auto costs = fitCosts(lawfulRuns());
  REQUIRE(costs.size() == 1);
  CHECK(costs[0].volume == "aabb");
  CHECK(costs[0].fixed == Approx(20.0));
  CHECK(costs[0].hullTest == Approx(5.0));
  CHECK(costs[0].primitiveTest == Approx(8.0));
  CHECK(costs[0].error < 1e-9);
  CHECK(costs[0].runs == 5);
  CHECK(predictedNanoseconds(costs[0], lawfulRuns()[2]) == Approx(96.0));
}

TEST_CASE("the cost model's error is the mean of the relative ones", "[hulls]") {
  auto runs = lawfulRuns();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (double& seconds : runs[i].seconds) seconds *= i % 2 == 0 ? 1.2 : 0.8;
  }
  const auto costs = fitCosts(runs);
  REQUIRE(costs.size() == 1);
  double sum = 0.0;
  for (const HullRun& run : runs) {
    sum += std::fabs(predictedNanoseconds(costs[0], run) / measuredNanoseconds(run) - 1.0);
  }
  CHECK(costs[0].error == Approx(sum / 5.0));
  CHECK(costs[0].error > 0.02);
}

TEST_CASE("too few runs fit no cost model", "[hulls]") {
  auto runs = lawfulRuns();
  runs.resize(3);
  CHECK(fitCosts(runs).empty());
  CHECK(fitCosts({}).empty());
  // Nor do runs that all do the same.
  const std::vector<HullRun> same(6, runOf("bvh", 10, 2, 1.0));
  CHECK(fitCosts(same).empty());
}

TEST_CASE("hulls pay from the ray on that makes up for their building", "[hulls]") {
  const HullRun sweep = runOf("none", 0, 100, 1.0);
  CHECK(breakEvenRays(runOf("bvh", 10, 2, 0.5), sweep) == Approx(1000.0));
  CHECK(breakEvenRays(runOf("bvh", 10, 2, 1.5), sweep) == std::numeric_limits<double>::infinity());
  const std::vector<HullRun> runs = {sweep, runOf("bvh", 10, 2, 0.5), runOf("sphere", 9, 9, 1.5)};
  CHECK(sweepOf(runs[1], runs) == &runs[0]);
  const std::string table = hullTable(runs);
  CHECK_THAT(table, Contains("1000") && Contains("never") && Contains("made-up"));
}

TEST_CASE("a strategy that an engine lacks is told in the table", "[hulls]") {
  HullRun run = runOf("bvh8", 0, 0, 1.0);
  run.seconds = {};
  run.missing = "no wide nodes there";
  CHECK_THAT(hullTable(std::vector<HullRun>{run}), Contains("bvh8") && Contains("skipped: no wide nodes there"));
}

TEST_CASE("the JSON has Google Benchmark's shape, each repeat by itself", "[hulls]") {
  const auto runs = lawfulRuns();
  const Json json = hullJson(runs, fitCosts(runs));
  CHECK(json["context"].contains("num_cpus"));
  REQUIRE(json["benchmarks"].size() == 15);
  const Json& first = json["benchmarks"][7];
  CHECK(first["name"] == "made-up/bvh/primary/cpu");
  CHECK(first["repetition_index"] == 1);
  CHECK(first["rays_per_second"].get<double>() == Approx(1e9 / 96.0));
  for (const char* key : {"real_time", "cpu_time", "time_unit", "rays", "hits", "hull_tests", "hull_hits",
                          "false_hull_hits", "primitive_tests", "nodes", "heap_pushes", "build_seconds",
                          "bytes_per_primitive"}) {
    CHECK(first.contains(key));
  }
  CHECK(json["costs"][0]["hull_test_ns"].get<double>() == Approx(5.0));
}

TEST_CASE("the CSV has as many fields in each line as names", "[hulls]") {
  const std::string csv = hullCsv(lawfulRuns());
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  std::istringstream lines(csv);
  std::string head;
  std::getline(lines, head);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) CHECK(commas(line) == commas(head));
  CHECK(count == 5);
}

TEST_CASE("the page plots every strategy, with no number that is none", "[hulls]") {
  auto runs = lawfulRuns();
  HullRun missing = runOf("bvh8", 0, 0, 1.0);
  missing.seconds = {};
  missing.missing = "a < b";
  runs.push_back(missing);
  const std::string page = hullPage(runs, fitCosts(runs));
  CHECK_THAT(page, Contains("made-up/bvh-median/primary/cpu") && Contains("a &lt; b") &&
                       Contains("cpu, primary rays") && Contains("<td>5.00</td>"));
  CHECK_THAT(page, !Contains("nan") && !Contains(">inf<"));
  const auto occurrences = [&](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = page.find(text); at != page.npos; at = page.find(text, at + 1)) ++count;
    return count;
  };
  CHECK(occurrences("<svg") == occurrences("</svg>"));
  CHECK(occurrences("<circle") == 5 + 3);  // of rates all that ran, of tests those with hulls
  CHECK_THAT(hullPage({}, {}), Contains("</html>"));
}

TEST_CASE("the heat map is black without tests and brightest at the most", "[hulls]") {
  std::vector<HullCounts> counts(4);
  counts[3].hullTests = 6;
  counts[3].primitiveTests = 4;
  counts[1].hullTests = 5;
  const DisplayImage map = drawHeatMap(2, 2, counts, "title");
  const auto brightness = [&](int column, int row) {
    // The picture begins below two lines of text; its pixels are 180 wide.
    const int x = 8 + 180 * column + 90;
    const int y = 56 + 180 * row + 90;
    const auto at = static_cast<std::size_t>(3 * (y * map.width + x));
    return map.rgb[at] + map.rgb[at + 1] + map.rgb[at + 2];
  };
  CHECK(brightness(0, 0) < 10);
  CHECK(brightness(0, 1) < 10);
  CHECK(brightness(1, 1) > 700);
  CHECK(brightness(1, 0) > brightness(0, 0) + 100);
  CHECK(brightness(1, 0) < brightness(1, 1) - 100);
}
