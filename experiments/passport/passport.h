#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/trace/options.h"
#include "gpu/device_passport.h"

namespace twintrace {

/// How far a builtin is from the exact value, over a few thousand inputs.
struct BuiltinAccuracy {
  std::string name;
  std::string allowance;       ///< in the words of the GLSL specification
  double maxUlp = 0;           ///< in ulp of the exact value
  double maxAbsolute = 0;
  std::uint32_t inputs[3] = {};  ///< bits of those with the largest error in ulp
  std::uint32_t found = 0;       ///< bits of the builtin's value there
  double exact = 0;              ///< the exact value there
  bool hasBound = false;         ///< the specification gives a number
  bool withinBound = false;      ///< no input went beyond it
};

/// All that `info --passport` tells.
struct Passport {
  DevicePassport device;
  std::string source;                    ///< where the context came from
  std::vector<PassportFact> fragment;    ///< denormals in fragment shaders; not part of the digest
  std::vector<BuiltinAccuracy> builtins;
};

/// Measures the GL that the options name anew, whatever has been kept of it.
/// @throws DeviceError without that provider.
Passport measureFullPassport(const RenderOptions& options);

/// The passport that the options' GL has under the options' shaders, as gpu arms take it.
/// @throws DeviceError without that provider.
DevicePassport devicePassport(const RenderOptions& options);

}  // namespace twintrace
