#pragma once

#include <filesystem>
#include <functional>

namespace twintrace {

/// Says whether a file that a scene names can be read.
using FileCheck = std::function<bool(const std::filesystem::path&)>;

}  // namespace twintrace
