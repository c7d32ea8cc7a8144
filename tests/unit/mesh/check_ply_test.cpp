#include "common/mesh/check_ply.h"

#include "tests/catch.h"
#include "tests/unit/mesh/mesh_files.h"

namespace twintrace {
namespace {

/// What checkPly says about a text, its path replaced by FILE; empty if nothing.
std::string plyFault(const std::string& text) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("x");
  test::writeBytes(path, text);
  try {
    checkPly(path);
    return "";
  } catch (const MeshError& error) {
    std::string message = error.what();
    const std::size_t at = message.find(path.substr(0, 59));
    if (at == message.npos) return message;
    return message.replace(at, message.find('\'', at) - at, "FILE");
  }
}

std::string header(const std::string& format, const std::string& lines) {
  return "ply\nformat " + format + " 1.0\n" + lines + "end_header\n";
}

const std::string kElements =
    "comment a line of words\r\nelement vertex 2\nproperty float x\nproperty uchar red\n"
    "element face 1\nproperty list uchar int vertex_indices\n";

TEST_CASE("checkPly takes files that hold what they announce", "[mesh]") {
  CHECK(plyFault(header("ascii", kElements) + "0 0\n1 1\n3 0 1 1\n") == "");
  CHECK(plyFault(header("ascii", kElements) + "0 0 1 1 0") == "");
  const std::string body(10 + 1 + 8, '\x02');
  CHECK(plyFault(header("binary_little_endian", kElements) + body) == "");
  CHECK(plyFault(header("binary_big_endian", kElements) + body) == "");
  CHECK(plyFault(header("ascii", "")) == "");
}

TEST_CASE("checkPly reports files that end too early", "[mesh]") {
  const std::string face =
      "found the end after 0 of 1 elements 'face' in 'FILE', expected all of them";
  const std::string vertex =
      "found the end after 1 of 2 elements 'vertex' in 'FILE', expected all of them";
  CHECK(plyFault(header("ascii", kElements) + "0 0\n1 1\n3 0 1\n") == face);
  CHECK(plyFault(header("ascii", kElements) + "0 0\n1 1\n") == face);
  CHECK(plyFault(header("ascii", kElements) + "0 0\n1") == vertex);
  const std::string body(10 + 1 + 8, '\x02');
  CHECK(plyFault(header("binary_little_endian", kElements) + body.substr(1)) == face);
  CHECK(plyFault(header("binary_little_endian", kElements) + body.substr(0, 10)) == face);
  CHECK(plyFault(header("binary_little_endian", kElements) + body.substr(0, 9)) == vertex);
}

TEST_CASE("checkPly reads the lengths of lists in the file's byte order", "[mesh]") {
  const std::string lists = "element face 1\nproperty list ushort short vertex_indices\n";
  const std::string one = {'\x00', '\x01', 'a', 'b'};
  CHECK(plyFault(header("binary_big_endian", lists) + one) == "");
  CHECK(plyFault(header("binary_little_endian", lists) + one) != "");
}

TEST_CASE("checkPly is done at once with counts that no file can hold", "[mesh]") {
  const std::string most = "element vertex 18446744073709551615\n";
  CHECK(plyFault(header("ascii", most + "property float x\n")) ==
        "found the end after 0 of 18446744073709551615 elements 'vertex' in 'FILE', expected all "
        "of them");
  CHECK(plyFault(header("ascii", most)) == "");
  const std::string list = "element face 1\nproperty list uint double vertex_indices\n";
  CHECK(plyFault(header("binary_little_endian", list) + "\xff\xff\xff\xff") != "");
}

TEST_CASE("checkPly reports headers that it can't follow", "[mesh]") {
  const std::string rest = " in 'FILE', expected 'format', 'element', 'property' or 'comment'";
  CHECK(plyFault("") == "found no first line 'ply' in 'FILE', expected a PLY file");
  CHECK(plyFault("plyx\n") == "found no first line 'ply' in 'FILE', expected a PLY file");
  CHECK(plyFault("ply\nformat ascii 1.0\n") ==
        "found no line 'end_header' in 'FILE', expected one");
  for (const std::string line : {"format latin 1.0", "element vertex -1", "element vertex",
                                 "element 9vertex 3", "property float x", "elephant"}) {
    CHECK(plyFault(header("ascii", line + "\n")) == "found header line '" + line + "'" + rest);
  }
  for (const std::string line :
       {"property half x", "property list uchar half x", "property list half int x", "property"}) {
    CHECK(plyFault(header("ascii", "element vertex 1\n" + line + "\n")) ==
          "found header line '" + line + "'" + rest);
  }
}

}  // namespace
}  // namespace twintrace
