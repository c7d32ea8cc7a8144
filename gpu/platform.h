#pragma once

#include <memory>
#include <string>

#include "gpu/gl_api.h"

namespace twintrace {

/// What a provider must do for a Context: own one GL 4.5 core context and bind it to threads.
class Platform {
 public:
  virtual ~Platform() = default;

  /// Makes the context current on the calling thread, which must have none.
  /// @throws DeviceError if the driver refuses.
  virtual void bind() = 0;

  /// Leaves the calling thread without a current context.
  virtual void release() noexcept = 0;

  /// Where GL functions come from.
  virtual GlLoader loader() const = 0;

  /// How the context came about, for provenance: "OSMesa", "EGL device 0", "EGL surfaceless".
  virtual std::string description() const = 0;
};

/// @throws DeviceError when libOSMesa is missing or can't give GL 4.5 core.
std::unique_ptr<Platform> createOsmesaPlatform();

/// A hardware device if one works, else Mesa without a surface (which may still be hardware).
/// @throws DeviceError with the reason of every candidate.
std::unique_ptr<Platform> createEglPlatform();

}  // namespace twintrace
