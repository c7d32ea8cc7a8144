#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "common/base/error.h"
#include "common/film/film_file.h"
#include "common/film/image_io.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/command_syntax.h"
#include "experiments/outputs.h"

namespace twintrace {
namespace {

class MergeCommand {
 public:
  explicit MergeCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "merge", "add films of disjoint samples exactly");
    syntax.option("films", films_, "films to add").required().typeName("A.film B.film");
    syntax.option("-o,--output", output_, "picture or film, by its ending")
        .required()
        .typeName("OUT.exr|OUT.film");
    syntax.flag("--quiet", quiet_, "no summary");
    return syntax.app();
  }

  int run() const {
    checkExtension(output_, {".exr", ".film"});
    checkWritable(output_);
    Film sum = readFilm(films_.front());
    for (std::size_t i = 1; i < films_.size(); ++i) mergeInto(sum, films_[i]);
    if (std::filesystem::path(output_).extension() == ".film") {
      writeFilm(output_, sum);
    } else {
      writeExr(output_, exrContent(sum));
    }
    warnOfBadFrames(console_, output_, sum);
    answer(console_, {"", quiet_}, {},
           fmt::format("{} films, samples {}: {}\n", films_.size(), sum.data().ranges.toString(),
                       output_));
    return kAgree;
  }

 private:
  static void mergeInto(Film& sum, const std::string& path) {
    const Film film = readFilm(path);
    try {
      sum.merge(film);
    } catch (const UsageError& error) {
      throw UsageError(path + ": " + error.what());
    }
  }

  Console console_;
  std::vector<std::string> films_;
  std::string output_;
  bool quiet_ = false;
};

}  // namespace

Command addMergeCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<MergeCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
