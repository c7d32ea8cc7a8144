#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "common/base/error.h"
#include "common/scene/effects.h"
#include "common/scene/option_names.h"
#include "common/scene/reader.h"

/// Any text must either be a scene or be refused with a FileError that says why and where. Files
/// that it names count as there, so that the file system is left alone.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace twintrace;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const Scene scene =
        parseScene(text, "fuzz.toml", [](const std::filesystem::path&) { return true; });
    checkOptions(scene.render);
    chosenEffects(scene, scene.render);
  } catch (const FileError& error) {
    if (error.diagnostics().empty()) std::abort();
  }
  return 0;
}
