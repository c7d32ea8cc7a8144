#pragma once

#include <filesystem>

#include "gpu/device_passport.h"
#include "gpu/program_cache.h"

namespace twintrace {

/// The passport that was measured before, of the same driver and the same programs, or a new one.
/// @param directory where passports are kept; empty = nowhere. Whatever goes wrong there, the device
///   is measured instead.
/// @throws as measurePassport.
DevicePassport passportOf(Context& context, const ShaderLibrary& library,
                          const std::filesystem::path& directory = defaultProgramCacheDirectory());

}  // namespace twintrace
