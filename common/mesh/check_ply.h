#pragma once

#include <string>

namespace twintrace {

/// Checks that a PLY file holds as much as its header announces: assimp reads on beyond the end.
/// @throws MeshError if not, or if there is no such header.
void checkPly(const std::string& path);

}  // namespace twintrace
