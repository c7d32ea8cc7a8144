#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "experiments/probe/user_shader.h"
#include "gpu/shader_source.h"

namespace twintrace::probe {

/// Computes one record: from packed input words to the outputs as doubles, word by word.
using UserReference = std::function<void(const std::uint32_t* in, double* out)>;

/// The shader's own text as C++ in double, compiled now by $CXX or c++.
///
/// Literals keep their decimal value. Swizzles with x, y, z, w can be read, not written; matrices,
/// textures and arrays with constructors are not supported.
/// @param source the user's file with all that it includes.
/// @throws FileError with the compiler's errors at the places of the shader; DeviceError without a
/// compiler.
UserReference textReference(const ShaderSource& source, const UserFunction& function);

/// The C++ text that textReference compiles.
std::string referenceText(const ShaderSource& source, const UserFunction& function);

/// The function of the same name in a C++ header, compiled now. It may be a template on the number
/// type; vectors may be of any type that is made from its components.
/// @throws IoError if the header can't be read; else as textReference.
UserReference headerReference(const std::string& path, const UserFunction& function);

/// The double twin of a function of this project.
/// @throws UsageError for an unknown name and for one with other parameters or results.
UserReference namedReference(const std::string& name, const UserFunction& function);

}  // namespace twintrace::probe
