#include "gpu/shared_library.h"

#include "common/base/error.h"

#include <dlfcn.h>

namespace twintrace {

SharedLibrary::SharedLibrary(const std::vector<std::string>& names, const std::string& package) {
  std::string tried;
  for (const std::string& name : names) {
    handle_ = dlopen(name.c_str(), RTLD_LOCAL | RTLD_NOW | RTLD_NODELETE);
    if (handle_ != nullptr) {
      name_ = name;
      return;
    }
    const char* reason = dlerror();
    tried += "\n  " + (reason != nullptr ? std::string(reason) : name);
  }
  throw DeviceError("library " + names.front() + " can't be loaded (Debian package " + package +
                    "):" + tried);
}

void* SharedLibrary::address(const char* symbol) const {
  void* found = dlsym(handle_, symbol);
  if (found == nullptr) throw DeviceError("library " + name_ + " lacks the function " + symbol);
  return found;
}

}  // namespace twintrace
