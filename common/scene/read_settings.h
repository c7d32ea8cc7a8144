#pragma once

#include <map>
#include <string>

#include "common/scene/reader.h"
#include "common/scene/toml_table.h"

namespace twintrace {

/// [film] and [render]: the keys of the option table.
void readFilmAndRender(TableReader& document, RenderOptions& options);

/// [camera], and that film, field of view and focus leave a focal plane of finite size.
void readCamera(TableReader& document, const RenderOptions& options, Camera& camera);

/// [environment]; the image's name is resolved against the scene file's folder.
void readEnvironment(TableReader& document, const std::string& scenePath, const FileCheck& check,
                     Environment& environment);

/// [effects]: effect names, on or off.
void readEffects(TableReader& document, std::map<std::string, bool>& forcedEffects);

}  // namespace twintrace
