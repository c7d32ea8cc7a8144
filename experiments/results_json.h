#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "common/film/film.h"
#include "common/scene/scene.h"
#include "experiments/arm.h"
#include "experiments/compare_arms.h"
#include "experiments/compare_files.h"
#include "experiments/render_job.h"

namespace twintrace {

/// Keys stay in the order in which they are written.
using Json = nlohmann::ordered_json;

/// Program, machine and libraries: the part of `provenance` that every result shares.
Json machineJson();

/// Options in full, what ran them, scene and effects of one arm.
Json armJson(const Arm& arm);

/// Count of the frames left out, and the first places of them.
Json badFramesJson(const Film& film);

/// The JSON of `render`.
Json renderJson(const Scene& scene, const Arm& arm, const RenderResult& result,
                const std::vector<std::string>& outputs);

/// The JSON of `compare` for rendered arms (design section 9).
Json compareJson(const Scene& scene, const Arm& a, const Arm& b, const ArmsComparison& result,
                 const ComparisonSettings& settings);

/// The same for two picture files: no times.
Json compareJson(const PictureFiles& files, const Comparison& comparison,
                 const ComparisonSettings& settings);

/// The text that is written: numbers that are not finite are null, bytes that are not UTF-8 are
/// replaced.
std::string jsonText(const Json& json);

}  // namespace twintrace
