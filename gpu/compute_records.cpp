#include "gpu/compute_records.h"

#include <fmt/format.h>

#include "gpu/buffers.h"
#include "gpu/context.h"
#include "gpu/program.h"

namespace twintrace {
namespace {

constexpr const char* kMainPath = "records.glsl";
constexpr std::size_t kGroupSize = 64;

constexpr const char* kInterface = R"glsl(
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Inputs { uint inputWords[]; };
layout(std430, binding = 1) writeonly buffer Outputs { uint outputWords[]; };
uniform int recordCount;

void main() {
  int record = int(gl_GlobalInvocationID.x);
  if (record >= recordCount) {
    return;
  }
)glsl";

std::string statement(std::string_view expression, std::size_t index, bool ownInputs) {
  const std::string to = fmt::format("outputWords[{} * recordCount + record]", index);
  std::string text = fmt::format("  {{\n    int at = 3 * ({} * recordCount + record);\n",
                                 ownInputs ? index : 0);
  int word = 0;
  for (const char name : {'a', 'b', 'c'}) {
    text += fmt::format("    float {} = uintBitsToFloat(inputWords[at + {}]);\n", name, word++);
  }
  if (expression.starts_with(kBitsPrefix)) {
    text += fmt::format("    {} = {};\n", to, expression.substr(kBitsPrefix.size()));
  } else {
    text += fmt::format("    precise float result = {};\n    {} = floatBitsToUint(result);\n",
                        expression, to);
  }
  return text + "  }\n";
}

}  // namespace

ShaderSource recordSource(const ShaderLibrary& library, const RecordProgram& program) {
  std::string text = program.head + kInterface;
  for (std::size_t i = 0; i < program.expressions.size(); ++i) {
    text += statement(program.expressions[i], i, program.ownInputs);
  }
  ShaderRequest request;
  request.main = kMainPath;
  request.virtualFiles[kMainPath] = text + "}\n";
  request.stripPrecise = !program.precise;
  return assembleShader(library, request);
}

std::vector<std::uint32_t> runRecords(Context& context, const ShaderSource& source,
                                      const RecordProgram& program,
                                      std::span<const std::uint32_t> inputs) {
  const std::size_t expressionCount = program.expressions.size();
  const std::size_t blocks = program.ownInputs ? expressionCount : 1;
  const std::size_t count = inputs.size() / (kRecordWords * blocks);
  const Context::Current current = context.use();
  Program compiled(context, Stage::compute, source);
  const StorageBuffer given(context, std::as_bytes(inputs));
  std::vector<std::uint32_t> results(count * expressionCount);
  const StorageBuffer found(context, results.size() * sizeof(std::uint32_t));
  given.bind(0);
  found.bind(1);
  compiled.set("recordCount", static_cast<std::int32_t>(count));
  compiled.dispatch({static_cast<std::uint32_t>((count + kGroupSize - 1) / kGroupSize), 1, 1});
  found.read(std::as_writable_bytes(std::span(results)));
  return results;
}

}  // namespace twintrace
