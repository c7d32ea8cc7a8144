#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "experiments/arm.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/scene_input.h"
#include "experiments/cli/shared_options.h"
#include "experiments/pick.h"

namespace twintrace {
namespace {

std::array<float, 3> components(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

PixelPosition parsePixel(const std::string& text) {
  PixelPosition pixel;
  const char* end = text.data() + text.size();
  const auto x = std::from_chars(text.data(), end, pixel.x);
  if (x.ec == std::errc{} && x.ptr != end && *x.ptr == ',') {
    const auto y = std::from_chars(x.ptr + 1, end, pixel.y);
    if (y.ec == std::errc{} && y.ptr == end) return pixel;
  }
  throw UsageError("pixel: found " + quote(text) + ", expected X,Y");
}

class PickCommand {
 public:
  explicit PickCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "pick", "say what the centre of a pixel shows");
    syntax.option("scene", scenePath_, "scene file").required().typeName("SCENE");
    syntax.option("--pixel", pixel_, "column and row from the upper left, from 0")
        .required()
        .typeName("X,Y");
    addAnswerOptions(syntax, answer_);
    addRenderOptions(syntax, given_);
    return syntax.app();
  }

  int run() const {
    const Scene scene = openScene(console_, scenePath_);
    const RenderOptions options = applyOptions(scene.render, given_);
    const PixelPosition pixel = parsePixel(pixel_);
    checkAnswer(answer_);
    const auto picked = pickPixel(scene, flattenScene(scene, options), options, pixel);
    answer(console_, answer_, toJson(pixel, picked), toText(pixel, picked));
    return kAgree;
  }

 private:
  static Json toJson(const PixelPosition& pixel, const std::optional<Picked>& picked) {
    Json json = {{"x", pixel.x}, {"y", pixel.y}, {"hit", picked.has_value()}};
    if (!picked) return json;
    json["object"] = picked->object;
    json["primitive"] = picked->primitive;
    json["material"] = picked->material;
    json["t"] = picked->t;
    json["position"] = components(picked->position);
    json["normal"] = components(picked->normal);
    return json;
  }

  static std::string toText(const PixelPosition& pixel, const std::optional<Picked>& picked) {
    if (!picked) return fmt::format("pixel {},{} shows no object\n", pixel.x, pixel.y);
    const glm::vec3& p = picked->position;
    const glm::vec3& n = picked->normal;
    return fmt::format(
        "object    {}\nprimitive {}\nmaterial  {}\nt         {}\nposition  {} {} {}\n"
        "normal    {} {} {}\n",
        picked->object, picked->primitive, picked->material, picked->t, p.x, p.y, p.z, n.x, n.y,
        n.z);
  }

  Console console_;
  std::string scenePath_;
  std::string pixel_;
  AnswerOptions answer_;
  GivenOptions given_;
};

}  // namespace

Command addPickCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<PickCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
