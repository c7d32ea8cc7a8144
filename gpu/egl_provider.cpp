#include <array>
#include <string_view>
#include <vector>

#include "common/base/error.h"
#include "gpu/platform.h"
#include "gpu/shared_library.h"

#define EGL_NO_PLATFORM_SPECIFIC_TYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace twintrace {

namespace {

constexpr EGLint kMaxDevices = 32;

/// True if the space-separated list, which may be null, holds the name as a whole word.
bool hasExtension(const char* list, std::string_view name) {
  std::string_view rest = list != nullptr ? list : "";
  while (!rest.empty()) {
    const std::size_t end = rest.find(' ');
    if (rest.substr(0, end) == name) return true;
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
  }
  return false;
}

/// The entry points of libEGL; extension functions are null where the driver lacks them.
struct EglApi {
  SharedLibrary library{{"libEGL.so.1", "libEGL.so"}, "libegl1"};
  decltype(&eglGetProcAddress) getProcAddress =
      library.function<decltype(eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglQueryString) queryString =
      library.function<decltype(eglQueryString)>("eglQueryString");
  decltype(&eglGetError) getError = library.function<decltype(eglGetError)>("eglGetError");
  decltype(&eglInitialize) initialize = library.function<decltype(eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) bindApi = library.function<decltype(eglBindAPI)>("eglBindAPI");
  decltype(&eglChooseConfig) chooseConfig =
      library.function<decltype(eglChooseConfig)>("eglChooseConfig");
  decltype(&eglCreateContext) createContext =
      library.function<decltype(eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroyContext =
      library.function<decltype(eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) makeCurrent =
      library.function<decltype(eglMakeCurrent)>("eglMakeCurrent");
  PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay =
      extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  PFNEGLQUERYDEVICESEXTPROC queryDevices =
      extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString =
      extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");

  bool hasClientExtension(std::string_view name) const {
    return hasExtension(queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), name);
  }

 private:
  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(getProcAddress(name));
  }
};

std::string errorText(const EglApi& egl) {
  constexpr std::array kNames = {
      "EGL_SUCCESS",       "EGL_NOT_INITIALIZED",     "EGL_BAD_ACCESS",
      "EGL_BAD_ALLOC",     "EGL_BAD_ATTRIBUTE",       "EGL_BAD_CONFIG",
      "EGL_BAD_CONTEXT",   "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY",
      "EGL_BAD_MATCH",     "EGL_BAD_NATIVE_PIXMAP",   "EGL_BAD_NATIVE_WINDOW",
      "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",         "EGL_CONTEXT_LOST"};
  const EGLint code = egl.getError();
  const auto index = static_cast<std::size_t>(code - EGL_SUCCESS);
  return index < kNames.size() ? kNames[index] : "EGL error " + std::to_string(code);
}

/// A display to try, in order of preference.
struct Candidate {
  std::string description;
  EGLenum platform;
  void* nativeDisplay;
};

void addHardwareDevices(const EglApi& egl, std::vector<Candidate>& candidates) {
  const bool canEnumerate = egl.queryDevices != nullptr && egl.queryDeviceString != nullptr;
  if (!canEnumerate || !egl.hasClientExtension("EGL_EXT_platform_device")) return;
  std::array<EGLDeviceEXT, kMaxDevices> devices{};
  EGLint count = 0;
  if (!egl.queryDevices(kMaxDevices, devices.data(), &count)) return;
  for (EGLint i = 0; i < count; ++i) {
    const auto device = devices[static_cast<std::size_t>(i)];
    const char* extensions = egl.queryDeviceString(device, EGL_EXTENSIONS);
    if (hasExtension(extensions, "EGL_MESA_device_software")) continue;
    candidates.push_back({"EGL device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT, device});
  }
}

std::vector<Candidate> findCandidates(const EglApi& egl) {
  std::vector<Candidate> candidates;
  if (egl.getPlatformDisplay == nullptr) return candidates;
  addHardwareDevices(egl, candidates);
  if (egl.hasClientExtension("EGL_MESA_platform_surfaceless")) {
    candidates.push_back({"EGL surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
  }
  return candidates;
}

/// A config that can back a GL context, where contexts need one.
EGLConfig chooseConfig(const EglApi& egl, EGLDisplay display) {
  const EGLint attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (!egl.chooseConfig(display, attributes, &config, 1, &count) || count == 0) {
    throw DeviceError("no EGL config for OpenGL (and no EGL_KHR_no_config_context)");
  }
  return config;
}

class EglPlatform final : public Platform {
 public:
  EglPlatform(const EglApi& egl, const Candidate& candidate);
  // The display is not terminated: EGL hands the same one to every context of the process and does
  // not count them, so that would break the others.
  ~EglPlatform() override { egl_.destroyContext(display_, context_); }
  EglPlatform(const EglPlatform&) = delete;
  EglPlatform& operator=(const EglPlatform&) = delete;

  void bind() override;
  void release() noexcept override;
  GlLoader loader() const override { return egl_.getProcAddress; }
  std::string description() const override { return description_; }

 private:
  EglApi egl_;
  std::string description_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

EglPlatform::EglPlatform(const EglApi& egl, const Candidate& candidate)
    : egl_(egl),
      description_(candidate.description),
      display_(egl.getPlatformDisplay(candidate.platform, candidate.nativeDisplay, nullptr)) {
  if (display_ == EGL_NO_DISPLAY || !egl_.initialize(display_, nullptr, nullptr)) {
    throw DeviceError("the display can't be initialised: " + errorText(egl_));
  }
  const char* extensions = egl_.queryString(display_, EGL_EXTENSIONS);
  if (!hasExtension(extensions, "EGL_KHR_surfaceless_context")) {
    throw DeviceError("extension EGL_KHR_surfaceless_context is missing");
  }
  const bool needsConfig = !hasExtension(extensions, "EGL_KHR_no_config_context");
  const EGLConfig config = needsConfig ? chooseConfig(egl_, display_) : EGL_NO_CONFIG_KHR;
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_NONE};
  if (!egl_.bindApi(EGL_OPENGL_API)) throw DeviceError("no desktop OpenGL: " + errorText(egl_));
  context_ = egl_.createContext(display_, config, EGL_NO_CONTEXT, attributes);
  if (context_ == EGL_NO_CONTEXT) {
    throw DeviceError("no OpenGL 4.5 core context: " + errorText(egl_));
  }
}

void EglPlatform::bind() {
  // The bound API belongs to the thread, and this may be another one than that of the constructor.
  egl_.bindApi(EGL_OPENGL_API);
  if (!egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
    throw DeviceError(description_ + " can't make its context current: " + errorText(egl_));
  }
}

void EglPlatform::release() noexcept {
  egl_.bindApi(EGL_OPENGL_API);
  egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace

std::unique_ptr<Platform> createEglPlatform() {
  const EglApi egl;
  std::string reasons;
  for (const Candidate& candidate : findCandidates(egl)) {
    try {
      return std::make_unique<EglPlatform>(egl, candidate);
    } catch (const DeviceError& error) {
      reasons += "\n  " + candidate.description + ": " + error.what();
    }
  }
  if (reasons.empty()) {
    reasons = "\n  no hardware device, and extension EGL_MESA_platform_surfaceless is missing";
  }
  throw DeviceError(
      "EGL gives no OpenGL 4.5 core context (Debian packages libegl-mesa0 and "
      "libgl1-mesa-dri, or the GPU vendor's driver):" +
      reasons);
}

}  // namespace twintrace
