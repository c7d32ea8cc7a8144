#pragma once

#include <string_view>

namespace twintrace::probe {

/// The real function that a shader function stands for, correctly rounded by MPFR.
struct Reference {
  std::string_view signature;
  std::string_view meaning;  ///< as in "sin x"
  /// Writes the answers for the inputs as packed; false outside the domain in which the shader
  /// function promises anything. Results below the smallest normal float may be rounded twice.
  bool (*answer)(const float* in, float* out);
};

/// The reference of the shader function with that signature, or nullptr where it stands for none.
const Reference* referenceOf(std::string_view signature);

}  // namespace twintrace::probe
