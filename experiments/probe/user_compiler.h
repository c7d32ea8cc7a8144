#pragma once

#include <string>

#include "gpu/shared_library.h"

namespace twintrace::probe {

/// Compiles a C++ text to a shared library in a private folder, loads it and removes the folder.
///
/// The compiler is $CXX or c++; it is started without a shell. Contraction is off.
/// @param path the file to name where the compiler's errors name none.
/// @throws FileError with the errors at the places that #line gave them; DeviceError if there is no
/// compiler.
SharedLibrary compileLibrary(const std::string& text, const std::string& path);

}  // namespace twintrace::probe
