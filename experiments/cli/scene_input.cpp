#include "experiments/cli/scene_input.h"

namespace twintrace {

Scene openScene(const Console& console, const std::string& path) {
  Scene scene = readScene(path);
  for (const std::string& warning : scene.warnings) warn(console, warning);
  return scene;
}

}  // namespace twintrace
