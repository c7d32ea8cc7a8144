#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/import/imported_scene.h"
#include "common/scene/reader.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/command_syntax.h"
#include "experiments/outputs.h"

namespace twintrace {
namespace {

class ImportCommand {
 public:
  explicit ImportCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "import", "make a scene out of an NFF, OBJ, PLY or glTF file");
    syntax
        .option("file", file_,
                "file with the surfaces, which stay in it; camera, lights and materials are taken "
                "from it where it has them")
        .required()
        .typeName("FILE");
    syntax.option("-o,--output", output_, "scene; default FILE's name with .toml, if that is free")
        .typeName("SCENE.toml");
    syntax.flag("--quiet", quiet_, "no summary");
    return syntax.app();
  }

  int run() {
    chooseOutput();
    const ImportedScene scene = importScene(file_);
    const std::string folder = std::filesystem::path(output_).parent_path().string();
    const std::string text = sceneText(scene, folder);
    // A file may say what no scene can: a camera with its up along the view, a name that is no
    // UTF-8.
    parseScene(text, output_);
    writeText(output_, text);
    for (const std::string& note : scene.notes) warn(console_, file_ + ": " + note);
    answer(console_, {"", quiet_}, {}, summary(scene));
    return kAgree;
  }

 private:
  void chooseOutput() {
    if (output_.empty()) {
      output_ = std::filesystem::path(file_).replace_extension(".toml").string();
      if (std::filesystem::exists(output_)) {
        throw UsageError("found " + quote(output_) +
                         " already there, expected -o to say where to write");
      }
    }
    checkExtension(output_, {".toml"});
    checkWritable(output_);
  }

  std::string summary(const ImportedScene& scene) const {
    const auto count = [](std::size_t size) { return static_cast<std::int64_t>(size); };
    return fmt::format("{}, {}, {}, {}: {}\n",
                       counted(count(scene.parts.size()), "object", "objects"),
                       counted(scene.sphereCount, "sphere", "spheres"),
                       counted(scene.triangleCount, "triangle", "triangles"),
                       counted(count(scene.lights.size()), "light", "lights"), output_);
  }

  Console console_;
  std::string file_;
  std::string output_;
  bool quiet_ = false;
};

}  // namespace

Command addImportCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<ImportCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
