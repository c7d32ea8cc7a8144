#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "common/trace/options.h"
#include "gpu/program.h"

namespace twintrace {

/// Where programs are kept between runs: $XDG_CACHE_HOME/twintrace or ~/.cache/twintrace; empty
/// when neither variable is set.
std::filesystem::path defaultProgramCacheDirectory();

/// Programs of one context by their full source: in memory, and on disk where the driver can give
/// binaries. The disk is a convenience: whatever goes wrong there, the program is compiled instead.
class ProgramCache {
 public:
  /// How the programs asked for so far came about.
  struct Counts {
    int compiled = 0;
    int fromMemory = 0;
    int fromDisk = 0;
  };

  /// @param directory made if needed; empty = memory only.
  explicit ProgramCache(Context& context,
                        std::filesystem::path directory = defaultProgramCacheDirectory());

  /// The program of a source, shared with all who ask for the same source: its uniforms have
  /// whatever values they last gave them.
  /// @throws DeviceError as Program's constructor.
  std::shared_ptr<Program> get(Stage stage, const ShaderSource& source);

  const Counts& counts() const { return counts_; }

 private:
  std::unique_ptr<Program> load(const std::string& key);
  void store(const std::string& key, const Program& program) const;

  Context& context_;
  std::filesystem::path directory_;
  std::map<std::string, std::shared_ptr<Program>> programs_;
  Counts counts_;
};

}  // namespace twintrace
