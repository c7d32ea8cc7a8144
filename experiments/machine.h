#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/trace/options.h"

namespace twintrace {

/// A GL provider as found on this machine.
struct ProviderFacts {
  std::string name;  ///< as in --gl
  bool available = false;
  std::string renderer;  ///< GL_RENDERER
  std::string version;   ///< GL_VERSION
  std::string source;    ///< where the context came from
  std::string reason;    ///< why there is none
};

struct CpuFacts {
  std::string model;  ///< as the system calls it
  unsigned threads = 0;
  std::vector<std::string> instructionSets;  ///< those of the wide kernel that this processor has
  std::string usedInstructionSet;
  int lanes = 0;
};

using LibraryVersions = std::vector<std::pair<std::string, std::string>>;

CpuFacts cpuFacts();

/// Bytes that can be had without swapping; nothing where the system does not tell.
std::optional<std::int64_t> availableMemory();

/// Refuses a film before it fills the memory, since the system then kills programs unasked.
/// @throws UsageError if the film and the pictures made of it need more than what is available.
void checkFilmMemory(int width, int height, std::optional<std::int64_t> availableBytes);

/// Opens a context of each provider in turn.
std::vector<ProviderFacts> providerFacts();

/// Versions of the libraries in use, by name.
LibraryVersions libraryVersions();

}  // namespace twintrace
