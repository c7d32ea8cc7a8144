#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "common/base/error.h"
#include "common/scene/reader.h"
#include "experiments/benchmark/results.h"

namespace twintrace {
namespace {

constexpr std::string_view kPromisedScene = "cornell";
constexpr int kFilmSize = 256;  // pixels
constexpr int kPasses = 16;

struct Settings {
  MeasurePlan plan;
  std::vector<std::string> scenes = {TWINTRACE_SCENE_DIR "/cornell.toml",
                                     TWINTRACE_SCENE_DIR "/open.toml"};
  std::string json;
  std::string provider = "osmesa";
  int threads = 2;
};

void addOptions(CLI::App& app, Settings& settings) {
  app.add_option("--repeats", settings.plan.repeats, "times that each arm runs")
      ->check(CLI::Range(1, 1000));
  app.add_option("--frames", settings.plan.frames,
                 "frames per repeat, 0 = as many as take about 0.7 seconds")
      ->check(CLI::Range(0, 100000));
  app.add_option("--scene", settings.scenes, "scene file, may be given several times");
  app.add_option("--threads", settings.threads, "threads of each arm")->check(CLI::Range(1, 1024));
  app.add_option("--gl", settings.provider, "osmesa or egl")
      ->check(CLI::IsMember({"osmesa", "egl"}));
  app.add_option("--json", settings.json, "write every repeat in Google Benchmark's shape");
}

RenderOptions baseOptions(const Scene& scene, const Settings& settings) {
  RenderOptions options = scene.render;
  options.width = options.height = kFilmSize;
  options.passes = kPasses;
  options.threads = settings.threads;
  options.provider = settings.provider == "egl" ? Provider::egl : Provider::osmesa;
  return options;
}

SceneTimes measure(const Scene& scene, const Settings& settings) {
  const auto progress = [&](int repeat) {
    std::cerr << scene.name << ": repeat " << repeat + 1 << " of " << settings.plan.repeats << "\n";
  };
  return measureScene(scene, benchmarkArms(baseOptions(scene, settings)), settings.plan, progress);
}

void writeJson(const std::string& path, const nlohmann::json& json) {
  std::ofstream file(path);
  file << json.dump(2) << "\n";
  file.close();
  if (!file) throw IoError(path + ": can't be written");
}

/// @return 0 if every promise that could be tested is kept, else 1.
int run(const Settings& settings) {
  std::vector<SceneTimes> scenes;
  std::vector<Ratio> promised;
  bool missed = false;
  for (const std::string& path : settings.scenes) {
    if (!std::filesystem::exists(path)) {
      std::cout << path << ": skipped, there is no such file\n\n";
      continue;
    }
    scenes.push_back(measure(readScene(path), settings));
    std::cout << ratesTable(scenes.back()) << "\n";
    if (scenes.back().scene != kPromisedScene) continue;
    promised = promisedRatios(scenes.back(), bestInstructionSet());
    std::cout << ratiosTable(promised) << "\n";
    for (const Ratio& ratio : promised) missed |= ratio.wall && !ratio.holds(*ratio.wall);
  }
  if (!settings.json.empty()) writeJson(settings.json, resultsJson(scenes, promised));
  return missed ? 1 : 0;
}

}  // namespace
}  // namespace twintrace

int main(int argc, char** argv) {
  twintrace::Settings settings;
  CLI::App app("Measures how many samples per second each way to render a scene takes.");
  twintrace::addOptions(app, settings);
  CLI11_PARSE(app, argc, argv);
  try {
    return twintrace::run(settings);
  } catch (const std::exception& error) {
    std::cerr << "twintrace_benchmark: " << error.what() << "\n";
    return 2;
  }
}
