#pragma once

#include <string>
#include <vector>

#include "gpu/specialisation.h"

namespace twintrace {

class Context;

/// Something measured on a device that decides the bits of results.
struct PassportFact {
  std::string name;
  std::string value;
  bool breaksStrict = false;  ///< strict maths cannot give the CPU's bits because of it

  bool operator==(const PassportFact&) const = default;
};

/// What the GL in use makes of arithmetic, as far as it decides bits: measured in a compute shader,
/// judged by the processor's arithmetic, which rounds correctly.
struct DevicePassport {
  std::string renderer;  ///< GL_RENDERER
  std::string version;   ///< GL_VERSION
  std::vector<PassportFact> facts;
  Corrections corrections;  ///< what strict maths must not leave to the device

  /// Hash of the facts alone: equal digests promise equal bits.
  std::string digest() const;

  /// "yes", "yes, through corrected ...", or "no: " and the facts that break it.
  std::string strictness() const;

  bool isStrict() const;
};

/// Measures the device through the library's shaders, whose `approximateQuotient` and
/// `approximateRoot` stand for its own division and square root.
/// @throws DeviceError if the device fails, FileError as assembleShader.
DevicePassport measurePassport(Context& context, const ShaderLibrary& library);

/// Hash of all that decides the facts: the driver and the text of what would be measured.
std::string passportKey(const Context& context, const ShaderLibrary& library);

/// Names of the facts in which two passports differ, such as "division".
std::vector<std::string> changedFacts(const std::vector<PassportFact>& before,
                                      const std::vector<PassportFact>& after);

}  // namespace twintrace
