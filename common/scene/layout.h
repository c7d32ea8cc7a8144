#pragma once

namespace twintrace::layout {
#include "shaders/shared/layout.glsl"
}
