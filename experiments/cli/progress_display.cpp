#include "experiments/cli/progress_display.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <ostream>

namespace twintrace {
namespace {

constexpr std::chrono::milliseconds kBarPeriod{100};
constexpr std::chrono::milliseconds kLinePeriod{2000};
constexpr int kBarWidth = 30;
constexpr const char* kEraseLine = "\r\x1b[K";

std::string clockText(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string bar(double fraction) {
  const auto filled = static_cast<int>(std::lround(fraction * kBarWidth));
  return fmt::format("[{:#<{}}{:.<{}}]", "", filled, "", kBarWidth - filled);
}

}  // namespace

std::string shortNumber(double value) {
  if (value >= 1e9) return fmt::format("{:.3g} G", value / 1e9);
  if (value >= 1e6) return fmt::format("{:.3g} M", value / 1e6);
  if (value >= 1e3) return fmt::format("{:.3g} k", value / 1e3);
  return fmt::format("{:.3g} ", value);
}

std::string progressText(const JobProgress& state, double elapsedSeconds) {
  std::string text = fmt::format("{:.0f} %", state.fraction * 100);
  if (state.samples > 0 && state.seconds > 0) {
    text += fmt::format(", {}samples/s", shortNumber(double(state.samples) / state.seconds));
  }
  if (state.fraction > 0) {
    text += ", " + clockText(elapsedSeconds * (1 / state.fraction - 1)) + " left";
  }
  return text;
}

ProgressDisplay::Style ProgressDisplay::styleForStandardError(bool quiet) {
  if (quiet) return Style::none;
  return isatty(STDERR_FILENO) != 0 ? Style::bar : Style::lines;
}

ProgressDisplay::ProgressDisplay(std::ostream& stream, Style style)
    : stream_(stream), style_(style), start_(Clock::now()), lastShown_(start_) {}

ProgressDisplay::~ProgressDisplay() {
  if (barShown_) stream_ << kEraseLine << std::flush;
}

void ProgressDisplay::show(const JobProgress& state) {
  if (style_ == Style::none) return;
  const Clock::time_point now = Clock::now();
  if (now - lastShown_ < (style_ == Style::bar ? kBarPeriod : kLinePeriod)) return;
  lastShown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const std::string text = progressText(state, elapsed);
  if (style_ == Style::lines) {
    stream_ << text << std::endl;
    return;
  }
  barShown_ = true;
  stream_ << kEraseLine << bar(state.fraction) << " " << text << std::flush;
}

}  // namespace twintrace
