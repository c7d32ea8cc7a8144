#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "common/base/error.h"
#include "experiments/arm.h"
#include "experiments/build_info.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/scene_input.h"
#include "experiments/cli/shared_options.h"
#include "experiments/effect_ledger.h"
#include "experiments/machine.h"
#include "experiments/passport/passport_json.h"
#include "experiments/passport/passport_text.h"

namespace twintrace {
namespace {

Json programJson() {
  Json json = machineJson();
  const CpuFacts cpu = cpuFacts();
  json["instruction_sets"] = cpu.instructionSets;
  json["instruction_set_used"] = cpu.usedInstructionSet;
  json["lanes"] = cpu.lanes;
  json["gl"] = Json::array();
  for (const ProviderFacts& facts : providerFacts()) {
    Json provider = {{"provider", facts.name}, {"available", facts.available}};
    if (facts.available) {
      provider["renderer"] = facts.renderer;
      provider["version"] = facts.version;
      provider["source"] = facts.source;
    } else {
      provider["reason"] = facts.reason;
    }
    json["gl"].push_back(provider);
  }
  return json;
}

Json sceneJson(const Scene& scene, const RenderOptions& options) {
  const auto flat = flattenScene(scene, options);
  const SceneIndex& index = flat->index;
  Json effects = Json::object();
  for (const EffectEntry& entry : effectLedger(scene, options)) {
    effects[entry.name] = {{"compiled_in", entry.compiledIn}, {"reason", entry.reason}};
  }
  return {{"name", scene.name},
          {"hash", sceneHash(*flat)},
          {"width", flat->width},
          {"height", flat->height},
          {"objects", scene.objects.size()},
          {"primitives", index.primitiveCount()},
          {"spheres", index.sphereCount},
          {"boxes", index.boxCount},
          {"oriented_boxes", index.orientedBoxCount},
          {"triangles", index.triangleCount},
          {"planes", index.planeCount},
          {"materials", index.materialCount},
          {"lights", index.lightCount},
          {"environment_width", index.environmentWidth},
          {"environment_height", index.environmentHeight},
          {"bytes", flat->texels.size() * sizeof(flat->texels[0])},
          {"effects", effects}};
}

/// A driver's message may have several lines.
std::string onOneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string programText(const Json& json) {
  const auto word = [](const Json& value) { return value.get<std::string>(); };
  std::string sets;
  for (const Json& set : json["instruction_sets"]) sets += word(set) + " ";
  std::string text = fmt::format(
      "twintrace {}\nbuild       {}, {}, {}\ncpu         {}, {} threads\n"
      "lanes       {} of {} (found: {})\n",
      word(json["version"]), word(json["build"]["compiler"]), word(json["build"]["type"]),
      word(json["build"]["flags"]), word(json["cpu"]), json["hardware_threads"].get<unsigned>(),
      json["lanes"].get<int>(), word(json["instruction_set_used"]),
      sets.substr(0, sets.size() - 1));
  for (const Json& gl : json["gl"]) {
    const bool available = gl["available"].get<bool>();
    text += fmt::format("gl {:<8} {}\n", word(gl["provider"]),
                        available ? word(gl["renderer"]) + ", OpenGL " + word(gl["version"])
                                  : "none: " + onOneLine(word(gl["reason"])));
  }
  for (const auto& [name, version] : json["libraries"].items()) {
    text += fmt::format("{:<12}{}\n", name, word(version));
  }
  return text;
}

std::string sceneText(const Json& json) {
  std::string text = "\n";
  for (const auto& [key, value] : json.items()) {
    if (key == "effects") continue;
    text +=
        fmt::format("{:<19}{}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  for (const auto& [name, entry] : json["effects"].items()) {
    text += fmt::format("effect {:<17}{:<4} {}\n", name,
                        entry["compiled_in"].get<bool>() ? "in" : "out",
                        entry["reason"].get<std::string>());
  }
  return text;
}

class InfoCommand {
 public:
  explicit InfoCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "info", "describe program, machine and, if given, a scene");
    syntax.option("scene", scenePath_, "scene file").typeName("SCENE");
    syntax.flag("--passport", passport_, "measure the arithmetic of the GL in use");
    addAnswerOptions(syntax, answer_);
    addRenderOptions(syntax, given_);
    return syntax.app();
  }

  int run() const {
    if (scenePath_.empty() && !passport_ && !given_.empty()) {
      throw UsageError(
          "found options of rendering without a scene, expected a scene file or --passport");
    }
    checkAnswer(answer_);
    RenderOptions options;
    Json json;
    std::string text;
    if (!scenePath_.empty()) {
      const Scene scene = openScene(console_, scenePath_);
      options = scene.render;
      json = sceneJson(scene, applyOptions(options, given_));
      text = sceneText(json);
    }
    Json program = programJson();
    text = programText(program) + text;
    if (!json.is_null()) program["scene"] = json;
    if (passport_) {
      const Passport passport = measureFullPassport(applyOptions(options, given_));
      program["passport"] = passportJson(passport);
      text += "\n" + passportText(passport);
    }
    answer(console_, answer_, program, text);
    return kAgree;
  }

 private:
  Console console_;
  std::string scenePath_;
  bool passport_ = false;
  AnswerOptions answer_;
  GivenOptions given_;
};

}  // namespace

Command addInfoCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<InfoCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
