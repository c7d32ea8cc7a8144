#pragma once

#include <string>

namespace twintrace {

/// How this program was built.
struct BuildInfo {
  std::string version;
  std::string compiler;
  std::string buildType;
  std::string flags;
};

BuildInfo buildInfo();

}  // namespace twintrace
