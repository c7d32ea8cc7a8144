#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace twintrace {

struct GlApi;
class Platform;

/// One OpenGL 4.5 core context. It is current only while a `Current` of it lives; between uses no
/// context is bound, so contexts of different providers can take turns on one thread, and a context
/// can move to another thread. One thread at a time; the context outlives the objects made in it.
class Context {
 public:
  /// Keeps the context current on this thread. Nests for one context; the scopes of two contexts
  /// must not overlap on one thread.
  class Current {
   public:
    explicit Current(Context& context) : context_(context) { context_.enter(); }
    ~Current() { context_.leave(); }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    Context& context_;
  };

  /// @throws DeviceError when the driver lacks a needed function.
  explicit Context(std::unique_ptr<Platform> platform);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Makes the context current until the result goes. All classes of this folder do so by
  /// themselves; an outer scope only saves the repeated switch.
  [[nodiscard]] Current use() { return Current(*this); }

  const GlApi& gl() const { return *gl_; }

  const std::string& vendor() const { return vendor_; }      ///< GL_VENDOR
  const std::string& renderer() const { return renderer_; }  ///< GL_RENDERER
  const std::string& version() const { return version_; }    ///< GL_VERSION
  const std::string& source() const { return source_; }      ///< "OSMesa", "EGL device 0", ...

  /// An integer limit or state, such as GL_MAX_TEXTURE_SIZE.
  std::int64_t integer(std::uint32_t name);

  /// Waits until the device has done everything it was asked for.
  void finish();

  /// Raises what has gone wrong since the last check.
  /// @param doing what was going on, to end "GL error ... while ".
  /// @throws DeviceError with the GL error's name and the driver's own words, if it has any.
  void check(std::string_view doing);

 private:
  void enter();
  void leave() noexcept;
  void enableDebugMessages();

  std::unique_ptr<Platform> platform_;
  std::unique_ptr<GlApi> gl_;
  std::unique_ptr<std::string> driverMessages_;  // the debug callback appends here
  int depth_ = 0;
  std::uint32_t vertexArray_ = 0;
  std::string vendor_;
  std::string renderer_;
  std::string version_;
  std::string source_;
};

}  // namespace twintrace
