#pragma once

#include <functional>
#include <string>

#include "common/trace/call_trace.h"
#include "gpu/glsl_text.h"
#include "gpu/shader_source.h"

namespace twintrace {

/// What of a program is recorded.
struct InstrumentSettings {
  /// Whether calls of a function are recorded; empty = of all.
  std::function<bool(const GlslFunction&)> calls;
  /// Whether the values that its statements give to its variables are recorded too; empty = of none.
  std::function<bool(const GlslFunction&)> statements;
};

/// A shader that records what it does, and what its records mean.
struct InstrumentedShader {
  ShaderSource source;
  TraceProgram program;
  int width = 0;  ///< slots of the widest site
};

/// Makes the functions of an assembled shader note their calls: the arguments on entry, the result on
/// return, unless `traceMuted` is set. Events are counted in `traceEvent`; the one whose number is `traceWanted` is kept, and
/// `TRACE_STORE(at)` writes its site and its words to `traceWords`, a buffer that the main declares.
/// Functions without a result or with types that can't be traced are left as they are. Lines stay
/// where they are in the shader's files.
/// @throws FileError if the text can't be parsed.
InstrumentedShader instrumentShader(const ShaderSource& source, const InstrumentSettings& settings);

}  // namespace twintrace
