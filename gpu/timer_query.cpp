#include "gpu/timer_query.h"

#include "gpu/context.h"
#include "gpu/gl_api.h"

namespace twintrace {

TimerQuery::TimerQuery(Context& context) : context_(context) {
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  GLint counterBits = 0;
  gl.GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &counterBits);
  supported_ = counterBits > 0;
  gl.CreateQueries(GL_TIME_ELAPSED, 1, &query_);
  context_.check("making a timer query");
}

TimerQuery::~TimerQuery() {
  const auto current = context_.use();
  context_.gl().DeleteQueries(1, &query_);
}

void TimerQuery::start() {
  const auto current = context_.use();
  context_.finish();
  startTime_ = std::chrono::steady_clock::now();
  context_.gl().BeginQuery(GL_TIME_ELAPSED, query_);
  context_.check("starting a timer query");
}

void TimerQuery::stop() {
  const auto current = context_.use();
  context_.gl().EndQuery(GL_TIME_ELAPSED);
  context_.finish();
  const auto elapsed = std::chrono::steady_clock::now() - startTime_;
  wallSeconds_ = std::chrono::duration<double>(elapsed).count();
  GLuint64 nanoseconds = 0;
  context_.gl().GetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
  context_.check("reading a timer query");
  queriedSeconds_ = static_cast<double>(nanoseconds) * 1e-9;
}

std::optional<double> TimerQuery::deviceSeconds() const {
  const bool plausible = queriedSeconds_ <= wallSeconds_ && queriedSeconds_ >= 0.5 * wallSeconds_;
  if (!supported_ || !plausible) return std::nullopt;
  return queriedSeconds_;
}

}  // namespace twintrace
