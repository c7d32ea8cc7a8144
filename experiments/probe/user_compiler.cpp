#include "experiments/probe/user_compiler.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <vector>

#include "common/base/error.h"

namespace twintrace::probe {
namespace {

namespace fs = std::filesystem;

/// A new folder that only this user can enter; removed at the end of the scope.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string name = (fs::temp_directory_path() / "twintrace-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw IoError(name + ": " + std::strerror(errno));
    path_ = name;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

std::string compilerName() {
  const char* given = std::getenv("CXX");
  return given != nullptr && *given != '\0' ? given : "c++";
}

/// Runs a program of the search path, its standard error going to a file.
/// @return whether it ended with 0. @throws DeviceError if it can't be started.
bool runProgram(std::vector<std::string> words, const std::string& errors) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(),
                                   O_CREAT | O_WRONLY | O_TRUNC, 0600);
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed == 0) waitpid(child, &status, 0);
  if (failed != 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 127)) {
    throw DeviceError("no C++ compiler: " + words[0] +
                      " can't be started; install g++ or name one in CXX, or take a function of "
                      "this program by --reference NAME");
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string readAll(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

constexpr std::size_t kMaxErrors = 20;

/// The first errors of g++ or clang++: `path:line:column: error: message`.
std::vector<Diagnostic> compilerErrors(const std::string& log, const std::string& path) {
  static const std::regex error(R"(^(.*?):(\d+):(?:(\d+):)? (?:fatal )?error: (.*)$)");
  std::vector<Diagnostic> found;
  std::istringstream lines(log);
  for (std::string line; found.size() < kMaxErrors && std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, error)) continue;
    const int column = match[3].matched ? std::stoi(match[3].str()) : 0;
    found.push_back(
        {{match[1].str(), std::stoi(match[2].str()), column}, "as C++: " + match[4].str()});
  }
  if (found.empty()) {
    const SourceLocation whole{path, 0, 0};
    found.push_back({whole, "as C++: " + log});
  }
  return found;
}

}  // namespace

SharedLibrary compileLibrary(const std::string& text, const std::string& path) {
  const PrivateFolder folder;
  const std::string source = folder.file("reference.cpp");
  const std::string library = folder.file("reference.so");
  const std::string log = folder.file("errors.txt");
  if (!(std::ofstream(source, std::ios::binary) << text << std::flush)) {
    throw IoError(source + ": cannot be written");
  }
  const bool compiled = runProgram({compilerName(), "-std=c++20", "-O1", "-w", "-ffp-contract=off",
                                    "-fPIC", "-shared", "-o", library, source},
                                   log);
  if (!compiled) throw FileError(compilerErrors(readAll(log), path));
  return SharedLibrary({library}, "g++");
}

}  // namespace twintrace::probe
