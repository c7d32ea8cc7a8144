// Built once per instruction set, like cpu/wide_kernel.cpp, with TWINTRACE_WIDE_TABLE naming the
// function that hands out the calls.

#include "cpu/kernel/wide.h"

#include "common/base/flush_denormals.h"
#include "kernel_transfer.h"
#include "tests/parity/wide_calls.h"

TWINTRACE_KERNEL_BEGIN
namespace {

using parity::WideFunction;

/// Takes values of all lanes out of records of packed words; what is the same in all lanes comes
/// from the first.
struct LaneReader {
  const std::uint32_t* at;
  std::size_t stride;

  void item(WideFloat& value) {
    for (int i = 0; i < kLanes; ++i) value.value[i] = std::bit_cast<float>(at[i * stride]);
    ++at;
  }
  void item(WideInt& value) {
    for (int i = 0; i < kLanes; ++i) value.value[i] = static_cast<std::int32_t>(at[i * stride]);
    ++at;
  }
  void item(WideUint& value) {
    for (int i = 0; i < kLanes; ++i) value.value[i] = at[i * stride];
    ++at;
  }
  void item(WideMask& value) {
    for (int i = 0; i < kLanes; ++i) value.value[i] = (at[i * stride] & 1u) != 0u;
    ++at;
  }
  void item(std::int32_t& value) { value = static_cast<std::int32_t>(*at++); }
  void item(std::uint32_t& value) { value = *at++; }
  void item(bool& value) { value = (*at++ & 1u) != 0u; }
};

struct LaneWriter {
  std::uint32_t* at;
  std::size_t stride;

  void item(const WideFloat& value) {
    for (int i = 0; i < kLanes; ++i) at[i * stride] = std::bit_cast<std::uint32_t>(value.lane(i));
    ++at;
  }
  void item(const WideInt& value) {
    for (int i = 0; i < kLanes; ++i) at[i * stride] = static_cast<std::uint32_t>(value.lane(i));
    ++at;
  }
  void item(const WideUint& value) {
    for (int i = 0; i < kLanes; ++i) at[i * stride] = value.value[i];
    ++at;
  }
  void item(const WideMask& value) {
    for (int i = 0; i < kLanes; ++i) at[i * stride] = value.lane(i) ? 1u : 0u;
    ++at;
  }
};

using WideCall = void (*)(const SceneView& view, const std::uint32_t* in, std::uint32_t* out);

template <WideCall call, int inputWords, int outputWords>
void runWide(const FlatScene& scene, const RenderOptions& options, const std::uint32_t* in,
             std::uint32_t* out, std::size_t count) {
  const FlushDenormals flush;
  const SceneView view = viewScene(scene, options, nullptr);
  for (std::size_t i = 0; i < count; i += kLanes) call(view, in + i * inputWords, out + i * outputWords);
}

#include "wide_functions.h"

}  // namespace
TWINTRACE_KERNEL_END

namespace twintrace::parity {

WideTable TWINTRACE_WIDE_TABLE() {
  return {kernel::kLanes, std::size(kernel::kWideFunctions), kernel::kWideFunctions};
}

}  // namespace twintrace::parity
