#include "gpu/gl_api.h"

#include <string>

#include "common/base/error.h"

namespace twintrace {

namespace {

GlFunction require(GlLoader load, const char* name) {
  const GlFunction function = load(name);
  if (function == nullptr) {
    throw DeviceError(std::string("the GL driver lacks ") + name + ", expected OpenGL 4.5 core");
  }
  return function;
}

}  // namespace

GlApi loadGlApi(GlLoader load) {
  GlApi api;
#define TWINTRACE_GL_LOAD(type, name) \
  api.name = reinterpret_cast<PFNGL##type##PROC>(require(load, "gl" #name));
  TWINTRACE_GL_FUNCTIONS(TWINTRACE_GL_LOAD)
#undef TWINTRACE_GL_LOAD
  return api;
}

}  // namespace twintrace
