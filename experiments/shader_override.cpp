#include "experiments/shader_override.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "gpu/shader_source.h"

namespace twintrace {
namespace {

constexpr std::string_view kRoot = "shaders/";

std::string readOverride(const std::string& path) {
  std::error_code unknown;
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path, unknown)) {
    throw UsageError("override: found " + quote(path) + ", expected a file that can be read");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

ShaderReplacement readShaderOverride(const std::string& assignment,
                                     const std::string& shaderDirectory) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == assignment.size()) {
    throw UsageError("override: found " + quote(assignment) + ", expected shaders/X.glsl=FILE");
  }
  std::string shader = assignment.substr(0, equals);
  if (shader.starts_with(kRoot)) shader.erase(0, kRoot.size());
  const std::vector<std::string> known = ShaderLibrary(shaderDirectory).paths();
  if (std::ranges::find(known, shader) == known.end()) {
    throw UsageError("override: found shader " + quote(shader) +
                     ", expected a file of the shader library" + didYouMean(shader, known));
  }
  const std::string file = assignment.substr(equals + 1);
  return {shader, file, readOverride(file)};
}

}  // namespace twintrace
