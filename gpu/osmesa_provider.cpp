#include <array>

#include "common/base/error.h"
#include "gpu/platform.h"
#include "gpu/shared_library.h"

namespace twintrace {

namespace {

// The part of <GL/osmesa.h> that is needed, written out so that the program also builds where Mesa
// no longer ships OSMesa (25.1 and later).
using OSMesaContext = struct osmesa_context*;
using CreateContextAttribs = OSMesaContext(const int* attributes, OSMesaContext shared);
using DestroyContext = void(OSMesaContext);
using MakeCurrent = GLboolean(OSMesaContext, void* buffer, GLenum type, GLsizei width,
                              GLsizei height);
using GetProcAddress = GlFunction(const char* name);
constexpr int kFormat = 0x22;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

// OSMesa insists on a window buffer; everything is rendered to framebuffer objects instead.
constexpr int kBufferSize = 16;

class OsmesaPlatform final : public Platform {
 public:
  OsmesaPlatform();
  ~OsmesaPlatform() override { destroyContext_(context_); }
  OsmesaPlatform(const OsmesaPlatform&) = delete;
  OsmesaPlatform& operator=(const OsmesaPlatform&) = delete;

  void bind() override;
  void release() noexcept override { makeCurrent_(nullptr, nullptr, 0, 0, 0); }
  GlLoader loader() const override { return getProcAddress_; }
  std::string description() const override { return "OSMesa"; }

 private:
  SharedLibrary library_;
  MakeCurrent* makeCurrent_;
  DestroyContext* destroyContext_;
  GetProcAddress* getProcAddress_;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, kBufferSize * kBufferSize * 4> buffer_{};
};

OsmesaPlatform::OsmesaPlatform()
    : library_({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}, "libosmesa6"),
      makeCurrent_(library_.function<MakeCurrent>("OSMesaMakeCurrent")),
      destroyContext_(library_.function<DestroyContext>("OSMesaDestroyContext")),
      getProcAddress_(library_.function<GetProcAddress>("OSMesaGetProcAddress")) {
  const auto create = library_.function<CreateContextAttribs>("OSMesaCreateContextAttribs");
  const int attributes[] = {kFormat,       GL_RGBA, kProfile, kCoreProfile, kMajorVersion, 4,
                            kMinorVersion, 5,       0};
  context_ = create(attributes, nullptr);
  if (context_ == nullptr) throw DeviceError("OSMesa can't create an OpenGL 4.5 core context");
}

void OsmesaPlatform::bind() {
  if (!makeCurrent_(context_, buffer_.data(), GL_UNSIGNED_BYTE, kBufferSize, kBufferSize)) {
    throw DeviceError("OSMesa can't make its context current");
  }
}

}  // namespace

std::unique_ptr<Platform> createOsmesaPlatform() {
  return std::make_unique<OsmesaPlatform>();
}

}  // namespace twintrace
