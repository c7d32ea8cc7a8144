#include "common/scene/reader.h"

#include <cstddef>
#include <fstream>

#include "common/base/wording.h"
#include "common/scene/expand_shapes.h"
#include "common/scene/read_content.h"
#include "common/scene/read_settings.h"
#include "common/scene/toml_table.h"

namespace twintrace {

namespace {

/// The name stands in names of output files, so it must be none of a folder.
void readName(TableReader& table, Scene& scene) {
  constexpr std::string_view kExpected = "a name without '/' and control characters";
  if (!table.read("name", scene.name, kExpected)) {
    scene.name = std::filesystem::path(scene.path).stem().string();
    return;
  }
  if (scene.name.empty() || scene.name.find('/') != std::string::npos) {
    table.faults().add(table.positionOf("name"), quote(scene.name), std::string(kExpected));
  }
}

/// The whole file, or as much as shows that it is too long: a device may never end.
std::string readText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::string block(std::size_t{1} << 16, '\0');
  while (file && text.size() <= kMaxTomlBytes) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block, 0, static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad()) {
    throw IoError("can't read " + path.string());
  }
  return text;
}

}  // namespace

bool isReadableFile(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && std::ifstream(path).is_open();
}

Scene readScene(const std::filesystem::path& path) {
  Scene scene = parseScene(readText(path), path.string());
  expandShapes(scene);
  return scene;
}

Scene parseScene(std::string_view text, const std::string& path, const FileCheck& check) {
  const toml::table document = parseToml(text, path);
  Faults faults(path);
  TableReader table(document, {1, 1}, faults);
  Scene scene;
  scene.path = path;
  readName(table, scene);
  readFilmAndRender(table, scene.render);
  readCamera(table, scene.render, scene.camera);
  readEnvironment(table, path, check, scene.environment);
  readMaterials(table, scene.materials);
  readObjects(table, check, scene);
  readLights(table, scene.lights);
  readEffects(table, scene.forcedEffects);
  table.finish();
  faults.throwIfAny();
  return scene;
}

}  // namespace twintrace
