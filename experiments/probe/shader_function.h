#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cpu/kernel/scene_view.h"

namespace twintrace::probe {

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

/// A shader function and its twins, called with packed words. Generated from the shaders.
struct ShaderFunction {
  const char* name;
  const char* signature;
  const char* file;  ///< below shaders/
  const char* main;  ///< GLSL that runs it over packed inputs, for gpu/probe.h
  std::span<const Slot> inputs;
  std::span<const Slot> outputs;
  Needs needs;
  bool inNative;  ///< whether native maths has it
  /// The float twin; null where there is none with the same parameters.
  void (*twin)(const kernel::SceneView& view, const std::uint32_t* in, std::uint32_t* out);
  /// The double twin of the same inputs; integers and truth values are numbers too. Null where the
  /// function exists for float alone.
  void (*twin64)(const kernel::SceneView& view, const std::uint32_t* in, double* out);
};

/// All functions of the shader library, by file.
std::vector<const ShaderFunction*> shaderFunctions();

/// Words of one record; at least 1, since a program needs some input.
int inputWords(const ShaderFunction& function);
int outputWords(const ShaderFunction& function);

/// The kind of each word of the function's results.
std::vector<Kind> outputKinds(const ShaderFunction& function);

}  // namespace twintrace::probe
