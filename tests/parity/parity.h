#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/scene/flat_scene.h"
#include "cpu/kernel/scene_view.h"
#include "gpu/context.h"
#include "gpu/probe.h"
#include "tests/catch.h"
#include "tests/parity/witness.h"

namespace twintrace::parity {

enum class Kind : std::uint8_t { real, integer, natural, truth };

/// A scalar or vector within the packed words of a function's parameters or result.
struct Slot {
  const char* path;   ///< as in "ray.direction"
  const char* owner;  ///< the structure it is a member of, or ""
  Kind kind;
  int size;       ///< words
  int parameter;  ///< index of the parameter it belongs to
};

/// The constants of a program that a function's answers depend on.
struct Needs {
  bool noise, intersector, integrator, geometry;
};

/// A shader function with its three implementations. Generated.
struct ShaderFunction {
  const char* name;
  const char* signature;
  const char* file;
  const char* main;  ///< GLSL that runs it over packed inputs
  std::span<const Slot> inputs;
  std::span<const Slot> outputs;
  Needs needs;
  /// Null where there is no twin with the same parameters.
  void (*twin)(const kernel::SceneView& view, const std::uint32_t* in, std::uint32_t* out);
  void (*witness)(Witness& witness, const std::uint32_t* in, std::uint32_t* out);
};

/// All functions of the shader library.
std::vector<const ShaderFunction*> shaderFunctions();

/// The function of that signature; fails the test if there is none.
const ShaderFunction& functionOf(const std::string& signature);

/// One scene under one set of options, as each implementation sees it.
struct World {
  std::string name;
  RenderOptions options;
  FlatScene scene;
  kernel::SceneView view;
  Witness witness;
};

/// The worlds whose differences the function can show, the plain one first.
std::vector<World> worldsFor(const ShaderFunction& function);

/// The plain world: robust intersections, pcg noise, path integrator, geometry in the texel array.
World plainWorld();

/// Words of one record; at least 1, since a program needs some input.
int inputWords(const ShaderFunction& function);
int outputWords(const ShaderFunction& function);

/// Records of inputs within the function's contract: special values first, then random ones.
std::vector<std::uint32_t> drawInputs(const ShaderFunction& function, const World& world,
                                      std::size_t randomCount, std::uint64_t seed);

/// The answers of the twin, of the witness and of the shader, for each record. Denormals are flushed.
std::vector<std::uint32_t> runTwin(const ShaderFunction& function, const World& world,
                                   std::span<const std::uint32_t> inputs);
std::vector<std::uint32_t> runWitness(const ShaderFunction& function, World& world,
                                      std::span<const std::uint32_t> inputs);
std::vector<std::uint32_t> runShader(Context& context, const ShaderLibrary& library,
                                     const ShaderFunction& function, const World& world,
                                     std::span<const std::uint32_t> inputs);

/// Records in which two answers differ. Floats: NaN equals NaN, the sign of zero is free.
struct Difference {
  std::size_t records = 0;  ///< in all
  std::size_t differing = 0;
  std::size_t first = 0;  ///< index of the first one that differs
  std::uint32_t maxUlp = 0;
};
Difference differenceOf(const ShaderFunction& function, std::span<const std::uint32_t> a,
                        std::span<const std::uint32_t> b);

/// What there is to say about a record: function, file, inputs and answers as hex floats.
/// @param answers pairs of who answered and all of the answers; ULP distances are to the first.
std::string describe(const ShaderFunction& function, const World& world, std::size_t record,
                     std::span<const std::uint32_t> inputs,
                     const std::vector<std::pair<std::string, std::span<const std::uint32_t>>>& answers);

inline constexpr std::size_t kRandomCount = 100000;
inline constexpr std::uint64_t kSeed = 20240229;

/// Fails the running test unless shader, twin and witness have the same bits in all worlds; under
/// all providers that this machine has in the plain world, under the first in the others.
void checkParity(const ShaderFunction& function);

}  // namespace twintrace::parity
