// Wide against scalar, lane by lane: the twins with wide floats of every instruction set that this
// processor has.

#include "tests/parity/parity.h"
#include "tests/parity/wide_calls.h"

namespace twintrace::parity {
namespace {

// A multiple of all lane counts, small enough that all functions take a few seconds.
constexpr std::size_t kWideRandomCount = 16384;

/// Gives every lane of a batch the uniform parameters of its first lane.
void spreadUniforms(const ShaderFunction& function, const WideFunction& wide, int lanes,
                    std::vector<std::uint32_t>& inputs) {
  const auto stride = static_cast<std::size_t>(inputWords(function));
  for (std::size_t record = 0; record * stride < inputs.size(); ++record) {
    const std::size_t first = record - record % static_cast<std::size_t>(lanes);
    std::size_t word = 0;
    for (const probe::Slot& slot : function.inputs) {
      for (int i = 0; i < slot.size; ++i, ++word) {
        if ((wide.uniformParameters >> slot.parameter & 1u) != 0u) {
          inputs[record * stride + word] = inputs[first * stride + word];
        }
      }
    }
  }
}

void checkLanes(const ShaderFunction& function, const WideFunction& wide, int lanes,
                const World& world) {
  std::vector<std::uint32_t> inputs = drawInputs(function, world, kWideRandomCount, kSeed);
  spreadUniforms(function, wide, lanes, inputs);
  const std::vector<std::uint32_t> scalar = runTwin(function, world, inputs);
  std::vector<std::uint32_t> found(scalar.size());
  const std::size_t count = scalar.size() / static_cast<std::size_t>(wide.outputWords);
  wide.run(world.scene, world.options, inputs.data(), found.data(), count);
  const Difference difference = differenceOf(function, scalar, found);
  if (difference.differing == 0) return;
  FAIL_CHECK(difference.differing << " of " << difference.records << " records differ, at most "
             << difference.maxUlp << " ulp, lane " << difference.first % lanes << " of " << lanes
             << "\n" << describe(function, world, difference.first, inputs,
                                 {{"scalar", scalar}, {"wide", found}}));
}

void checkTable(const WideTable& table, int expectedLanes) {
  REQUIRE(table.lanes == expectedLanes);
  REQUIRE(table.count > 0);
  for (const WideFunction& wide : std::span(table.functions, table.count)) {
    const ShaderFunction& function = functionOf(wide.signature);
    for (const World& world : worldsFor(function)) {
      // To a CPU, geometry as literals is the same world again.
      if (world.options.geometry == Geometry::literal) continue;
      checkLanes(function, wide, table.lanes, world);
    }
  }
}

}  // namespace

TEST_CASE("every lane of SSE2 has the bits of the scalar twins", "[parity][wide]") {
  checkTable(wideTable_sse2(), 4);
}

TEST_CASE("every lane of AVX2 has the bits of the scalar twins", "[parity][wide]") {
  if (!__builtin_cpu_supports("avx2")) {
    WARN("left out: this processor has no AVX2");
    return;
  }
  checkTable(wideTable_avx2(), 8);
}

TEST_CASE("every lane of AVX-512 has the bits of the scalar twins", "[parity][wide]") {
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512dq")) {
    WARN("left out: this processor has no AVX-512");
    return;
  }
  checkTable(wideTable_avx512(), 16);
}

}  // namespace twintrace::parity
