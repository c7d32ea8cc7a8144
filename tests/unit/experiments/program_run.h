#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/unit/experiments/temporary_directory.h"

namespace twintrace::test {

/// What a run of the program left behind.
struct ProgramResult {
  int exitCode = -1;  ///< -1 - signal if one killed it
  std::string out;
  std::string err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// A variable of the program's environment.
struct Variable {
  std::string name;
  std::string value;
};

/// The program, running in a directory; its standard streams go to files in it.
class RunningProgram {
 public:
  RunningProgram(const TemporaryDirectory& directory, const std::vector<std::string>& arguments,
                 const std::vector<Variable>& environment = {})
      : directory_(directory) {
    std::vector<char*> words = {const_cast<char*>(TWINTRACE_BINARY)};
    for (const std::string& argument : arguments)
      words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const std::string out = directory.file("stdout.txt");
    const std::string err = directory.file("stderr.txt");
    pid_ = fork();
    if (pid_ != 0) return;
    for (const Variable& v : environment) setenv(v.name.c_str(), v.value.c_str(), 1);
    const bool ready = chdir(directory.path().c_str()) == 0 &&
                       dup2(open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), 1) == 1 &&
                       dup2(open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), 2) == 2;
    if (ready) execv(words[0], words.data());
    _exit(127);
  }

  pid_t pid() const { return pid_; }

  ProgramResult wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    ProgramResult result;
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1 - WTERMSIG(status);
    result.out = readBytes(directory_.file("stdout.txt"));
    result.err = readBytes(directory_.file("stderr.txt"));
    return result;
  }

 private:
  const TemporaryDirectory& directory_;
  pid_t pid_ = -1;
};

inline ProgramResult runProgram(const TemporaryDirectory& directory,
                                const std::vector<std::string>& arguments) {
  return RunningProgram(directory, arguments).wait();
}

inline const std::string kCornell = TWINTRACE_SOURCE_DIR "/experiments/scenes/cornell.toml";

/// A command on the Cornell box at 16x16 pixels.
inline std::vector<std::string> onCornell(const std::string& command,
                                          const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {command, kCornell, "--width", "16", "--height", "16"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace twintrace::test
