#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/trace/options.h"
#include "experiments/cli/command_syntax.h"
#include "experiments/cli/console.h"
#include "experiments/job_control.h"

namespace twintrace {

/// The options of rendering as given on the command line, to be laid over a scene's.
struct GivenOptions {
  std::vector<std::pair<std::string, std::string>> list;  ///< name and value
  std::string shaderDirectory;
  std::vector<std::string> overrides;  ///< as in `shaders/X.glsl=FILE`
  std::string armList;                 ///< `--a` or `--b` of compare, laid over `list`

  bool has(std::string_view name) const;
  bool empty() const { return list.empty() && shaderDirectory.empty() && overrides.empty(); }
};

/// Adds `--name` for every option of renderOptionTable(), `--shader-dir` and `--override`.
void addRenderOptions(CommandSyntax& syntax, GivenOptions& given);

/// Adds `--shader-dir` and `--override` alone.
void addShaderOptions(CommandSyntax& syntax, GivenOptions& given);

/// Adds `--json` and `--quiet`.
void addAnswerOptions(CommandSyntax& syntax, AnswerOptions& options);

/// Lays the given options over a scene's.
/// @throws UsageError as setOption does, for a shader directory that is none, and as
/// readShaderOverride does.
RenderOptions layOptions(RenderOptions options, const GivenOptions& given);

/// Whether a stop rule is given without spp, so that the scene's limit on samples must not end the
/// run.
bool stopRuleDecides(const RenderOptions& options, const GivenOptions& given);

/// Sets as many samples as a film holds.
void liftSampleLimit(RenderOptions& options);

/// layOptions() with the limit lifted where a stop rule decides.
RenderOptions applyOptions(const RenderOptions& ofScene, const GivenOptions& given);

}  // namespace twintrace
