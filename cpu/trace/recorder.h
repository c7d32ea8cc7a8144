#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace twintrace::kernel {

/// The words that the instrumented kernel records on one thread.
struct TraceRecorder {
  static constexpr std::size_t kMostWords = std::size_t{1} << 26;  // 256 MB

  std::vector<std::uint32_t> words;
  std::uint64_t lost = 0;  ///< events for which there was no room

  /// Whether an event of so many words has room; counts it as lost otherwise.
  bool begin(std::uint32_t site, std::size_t slots) {
    if (words.size() + slots >= kMostWords) {
      ++lost;
      return false;
    }
    words.push_back(site);
    return true;
  }
};

inline std::uint32_t traceWord(float x) { return std::bit_cast<std::uint32_t>(x); }
inline std::uint32_t traceWord(double x) { return traceWord(static_cast<float>(x)); }
inline std::uint32_t traceWord(long double x) { return traceWord(static_cast<float>(x)); }
inline std::uint32_t traceWord(std::int32_t x) { return static_cast<std::uint32_t>(x); }
inline std::uint32_t traceWord(std::uint32_t x) { return x; }
inline std::uint32_t traceWord(bool x) { return x ? 1u : 0u; }
/// A number type that wraps a float.
template <class Wrapped>
std::uint32_t traceWord(const Wrapped& x) {
  return traceWord(x.value);
}

// The kernel's functions have their twins' parameters, so that a recorder can't be passed to them.
inline thread_local TraceRecorder* traceRecorder = nullptr;

/// Makes a recorder the thread's own while it lives.
class TraceScope {
 public:
  explicit TraceScope(TraceRecorder& recorder) { traceRecorder = &recorder; }
  ~TraceScope() { traceRecorder = nullptr; }
  TraceScope(const TraceScope&) = delete;
  TraceScope& operator=(const TraceScope&) = delete;
};

}  // namespace twintrace::kernel
