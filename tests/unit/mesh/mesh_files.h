#pragma once

#include <string>

#include "common/mesh/load_mesh.h"
#include "tests/unit/experiments/temporary_directory.h"

namespace twintrace::test {

inline LoadedMesh loadText(const std::string& name, const std::string& text, bool smooth = false) {
  const TemporaryDirectory directory;
  writeBytes(directory.file(name), text);
  return loadMesh(directory.file(name), smooth);
}

/// What loading a text as a file of that name throws, its folder left out; empty if nothing.
inline std::string faultOf(const std::string& name, const std::string& text) {
  const TemporaryDirectory directory;
  writeBytes(directory.file(name), text);
  try {
    loadMesh(directory.file(name), true);
    return "";
  } catch (const MeshError& error) {
    std::string message = error.what();
    const std::string folder = directory.file("");
    for (std::size_t at = message.find(folder); at != message.npos; at = message.find(folder)) {
      message.erase(at, folder.size());
    }
    return message;
  }
}

/// An ASCII PLY file of vertices "x y z" and faces "n i j k", one a line.
inline std::string plyText(int vertices, int faces, const std::string& lines) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n" + lines;
}

/// A glTF file of one triangle, its buffer inside: three vertices in float, then three indices in
/// 16 bits.
/// @param buffer in base64, 44 bytes
/// @param node the node that has the mesh
inline std::string gltfText(const std::string& buffer, const std::string& node = R"({"mesh": 0})") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [)" +
         node + R"(],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"buffers": [{"byteLength": 44, "uri": "data:application/octet-stream;base64,)" +
         buffer + R"("}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
              {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}]}
)";
}

}  // namespace twintrace::test
