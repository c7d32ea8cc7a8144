#include "experiments/benchmark/arms.h"

#include "common/scene/option_names.h"

namespace twintrace {
namespace {

constexpr InstructionSet kInstructionSets[] = {InstructionSet::sse2, InstructionSet::avx2,
                                               InstructionSet::avx512};

BenchmarkArm arm(RenderOptions options, std::string_view name, std::string_view settings) {
  setOptions(options, settings);
  return {std::string(name), options};
}

}  // namespace

std::string wideArmName(InstructionSet set) {
  return std::string("cpu/wide/") + instructionSetName(set);
}

std::vector<BenchmarkArm> benchmarkArms(const RenderOptions& base) {
  std::vector<BenchmarkArm> arms = {
      arm(base, kStrictFragment, "backend=gpu,maths=strict,stage=fragment"),
      arm(base, kNativeFragment, "backend=gpu,maths=native,stage=fragment"),
      arm(base, kStrictCompute, "backend=gpu,maths=strict,stage=compute"),
      arm(base, kNativeCompute, "backend=gpu,maths=native,stage=compute"),
      arm(base, kBufferGeometry, "backend=gpu,maths=strict,stage=fragment,geometry=buffer"),
      arm(base, kAllEffects, "backend=gpu,maths=strict,stage=fragment,geometry=buffer,effects=all"),
      arm(base, kScalar, "backend=cpu,maths=strict,lanes=scalar"),
      arm(base, "cpu/scalar/native", "backend=cpu,maths=native,lanes=scalar"),
      arm(base, "cpu/scalar/double", "backend=cpu,maths=strict,precision=double,lanes=scalar"),
  };
  for (const InstructionSet set : kInstructionSets) {
    if (set > bestInstructionSet()) continue;
    arms.push_back(arm(base, wideArmName(set), "backend=cpu,maths=strict,lanes=wide"));
    arms.back().instructionSet = set;
  }
  return arms;
}

}  // namespace twintrace
