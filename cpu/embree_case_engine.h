#pragma once

#include <memory>

#include "common/cast/case_set.h"

namespace twintrace {

/// The witness as a case engine, `embree`: each case's scene as Embree's own geometry, spheres as
/// sphere points, boxes and oriented boxes as 12 triangles each. It lacks planes, which are left out,
/// and bounces; t below 0; and an order among equal t.
/// @throws DeviceError if Embree fails.
std::unique_ptr<CaseEngine> makeEmbreeCaseEngine();

}  // namespace twintrace
