#include "gpu/trace_records.h"

#include <algorithm>
#include <span>

namespace twintrace {
namespace {

// TRACE_STORE is the instrumenter's.
constexpr const char* kText = R"glsl(
layout(std430, binding = 2) buffer TraceWords {
  uint traceCount;
  uint traceWords[];
};
uniform uint firstEvent;
uniform int recordWords;

void traceChoose() {
  traceWanted = firstEvent + gl_GlobalInvocationID.x;
}

void traceKeep() {
  int to = int(gl_GlobalInvocationID.x) * recordWords;
  TRACE_STORE(to)
  if (gl_GlobalInvocationID.x == 0u) {
    traceCount = traceEvent;
  }
}
)glsl";
constexpr std::uint32_t kBinding = 2;
constexpr std::size_t kHeaderWords = 1;  // the count

// Whole batches, as they are kept. The work grows with the square of their number.
constexpr std::uint32_t kMostEvents = 30 * kTraceBatch;

}  // namespace

std::string traceRecordsText() {
  return kText;
}

TraceRecords::TraceRecords(Context& context, Program& program, const InstrumentedShader& shader)
    : program_(program),
      shader_(shader),
      recordWords_(static_cast<std::size_t>(shader.width) + 1),
      words_(kHeaderWords + kTraceBatch * recordWords_),
      storage_(context, words_.size() * sizeof(std::uint32_t)) {
  program_.set("recordWords", static_cast<std::int32_t>(recordWords_));
}

CallTrace TraceRecords::collect() {
  CallTrace trace;
  std::uint32_t count = kTraceBatch;
  for (std::uint32_t first = 0; first < std::min(count, kMostEvents); first += kTraceBatch) {
    run(first, std::min(count - first, kTraceBatch));
    count = words_[0];
    append(trace, std::min(count - first, kTraceBatch));
  }
  trace.lost = count - std::min(count, kMostEvents);
  return trace;
}

void TraceRecords::run(std::uint32_t firstEvent, std::uint32_t count) {
  program_.set("firstEvent", firstEvent);
  storage_.bind(kBinding);
  program_.dispatch({(count + kTraceGroupSize - 1) / kTraceGroupSize, 1, 1});
  storage_.read(std::as_writable_bytes(std::span(words_)));
}

void TraceRecords::append(CallTrace& trace, std::uint32_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t* record = &words_[kHeaderWords + i * recordWords_];
    const TraceSite& site = shader_.program.sites.at(record[0]);
    trace.words.insert(trace.words.end(), record, record + 1 + site.slots.size());
  }
}

}  // namespace twintrace
