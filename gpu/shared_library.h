#pragma once

#include <string>
#include <vector>

namespace twintrace {

/// A library loaded at run time, so that a machine without it still runs everything else.
///
/// It stays loaded until the process ends: Mesa and LLVM leave thread-local destructors, exit
/// handlers and idle worker threads behind, which would run unmapped code.
class SharedLibrary {
 public:
  /// Loads the first of `names` that exists, with its symbols hidden from other libraries.
  /// @param package the Debian package to name when none can be loaded.
  /// @throws DeviceError with what was tried and the package.
  SharedLibrary(const std::vector<std::string>& names, const std::string& package);

  /// The function's address.
  /// @throws DeviceError when the library has no such symbol.
  template <class Function>
  Function* function(const char* symbol) const {
    return reinterpret_cast<Function*>(address(symbol));
  }

 private:
  void* address(const char* symbol) const;

  void* handle_ = nullptr;
  std::string name_;
};

}  // namespace twintrace
