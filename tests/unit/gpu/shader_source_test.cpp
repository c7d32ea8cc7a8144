#include "gpu/shader_source.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "common/base/error.h"
#include "gpu/embedded_shaders.h"
#include "tests/catch.h"

namespace twintrace {

namespace {

ShaderRequest requestOf(std::map<std::string, std::string> files) {
  ShaderRequest request;
  request.main = "main.glsl";
  request.virtualFiles = std::move(files);
  return request;
}

std::string assembledText(const ShaderRequest& request) {
  return assembleShader(ShaderLibrary(), request).text;
}

std::string errorOf(const ShaderRequest& request) {
  try {
    assembleShader(ShaderLibrary(), request);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("assembleShader puts version and prelude before the main file", "[unit]") {
  ShaderRequest request = requestOf({{"main.glsl", "void main() {}\n"}});
  request.prelude = "const int kCount = 3;";
  CHECK(assembledText(request) == "#version 450 core\nconst int kCount = 3;\nvoid main() {}\n");
}

TEST_CASE("assembleShader splices an include and remembers where lines come from", "[unit]") {
  ShaderRequest request =
      requestOf({{"main.glsl", "a\n  #  include \"sub/x.glsl\"\nb"}, {"sub/x.glsl", "x\r\ny\r\n"}});
  request.prelude = "p";
  const ShaderSource source = assembleShader(ShaderLibrary(), request);
  CHECK(source.text == "#version 450 core\np\na\nx\ny\nb\n");
  std::string origins;
  for (const ShaderSource::Line& line : source.lines) {
    origins += source.files[line.file] + ":" + std::to_string(line.number) + " ";
  }
  CHECK(origins ==
        "<prelude>:0 <prelude>:1 <main.glsl>:1 <sub/x.glsl>:1 <sub/x.glsl>:2 <main.glsl>:3 ");
}

TEST_CASE("assembleShader includes a file with pragma once only once", "[unit]") {
  const auto request = requestOf({{"main.glsl", "#include \"x.glsl\"\n#include \"x.glsl\"\n"},
                                  {"x.glsl", "// head\n#pragma once // guard\nbody\n"}});
  const std::string text = assembledText(request);
  CHECK(countOf(text, "body") == 1);
  CHECK(countOf(text, "pragma") == 0);
}

TEST_CASE("assembleShader repeats a file without pragma once", "[unit]") {
  const auto request = requestOf(
      {{"main.glsl", "#include \"x.glsl\"\n#include \"x.glsl\"\n"}, {"x.glsl", "body\n"}});
  CHECK(countOf(assembledText(request), "body") == 2);
}

TEST_CASE("assembleShader leaves a pragma once that is a longer word alone", "[unit]") {
  const auto request = requestOf({{"main.glsl", "#pragma once_more\n#includes\n"}});
  CHECK(countOf(assembledText(request), "#pragma once_more\n#includes\n") == 1);
}

TEST_CASE("assembleShader takes an alias in place of the file asked for", "[unit]") {
  ShaderRequest request = requestOf(
      {{"main.glsl", "#include \"math.glsl\"\n"}, {"math.glsl", "own"}, {"native.glsl", "driver"}});
  request.aliases["math.glsl"] = "native.glsl";
  const std::string text = assembledText(request);
  CHECK(countOf(text, "driver") == 1);
  CHECK(countOf(text, "own") == 0);
}

TEST_CASE("assembleShader blanks out precise as a token and keeps the columns", "[unit]") {
  ShaderRequest request = requestOf(
      {{"main.glsl", "precise float precisely = imprecise + precise_ + x.precise;(precise)\n"}});
  request.stripPrecise = true;
  CHECK(countOf(assembledText(request),
                "        float precisely = imprecise + precise_ + x.       ;(       )\n") == 1);
}

TEST_CASE("assembleShader keeps precise unless told to strip it", "[unit]") {
  CHECK(countOf(assembledText(requestOf({{"main.glsl", "precise float x;\n"}})), "precise") == 1);
}

TEST_CASE("assembleShader finds the embedded library", "[unit]") {
  const auto request = requestOf({{"main.glsl", "#include \"shared/layout.glsl\"\n"}});
  const ShaderSource source = assembleShader(ShaderLibrary(), request);
  CHECK(countOf(source.text, "const int kSphereTexels") == 1);
  CHECK(source.files.back() == "shaders/shared/layout.glsl");
}

TEST_CASE("assembleShader names every missing include with file, line and column", "[unit]") {
  const auto request = requestOf({{"main.glsl", "\n#include \"none.glsl\"\n#include \"x.glsl\"\n"},
                                  {"x.glsl", "  #include <bare>\n"}});
  CHECK(errorOf(request) ==
        "<main.glsl>:2:10: found #include of \"none.glsl\", expected a file of the shader library\n"
        "<x.glsl>:1:12: found #include <bare>, expected #include \"path\"");
}

TEST_CASE("assembleShader reports a cycle instead of following it", "[unit]") {
  const auto request =
      requestOf({{"main.glsl", "#include \"x.glsl\"\n"}, {"x.glsl", "#include \"main.glsl\"\n"}});
  CHECK(errorOf(request) ==
        "<x.glsl>:1:10: found #include of \"main.glsl\" inside itself, "
        "expected no cycle or #pragma once");
}

TEST_CASE("assembleShader reports a missing main file", "[unit]") {
  ShaderRequest request;
  request.main = "mains/none.glsl";
  CHECK(errorOf(request) ==
        "shaders/mains/none.glsl: found no such file, expected a file of the shader library");
}

TEST_CASE("ShaderLibrary replaces a file by its override", "[unit]") {
  const ShaderLibrary library({}, {{"shaders/shared/layout.glsl", {"replaced", ""}}});
  const auto file = library.find("shared/layout.glsl");
  REQUIRE(file);
  CHECK(file->text == "replaced");
  CHECK(file->displayName == "shaders/shared/layout.glsl");
}

TEST_CASE("ShaderLibrary shows the origin of an override in messages", "[unit]") {
  const ShaderLibrary library({}, {{"shared/layout.glsl", {"replaced", "mine.glsl"}}});
  CHECK(library.find("shared/layout.glsl")->displayName == "mine.glsl");
}

TEST_CASE("ShaderLibrary refuses an override of an unknown file", "[unit]") {
  const ShaderLibrary::Overrides overrides = {{"shaders/layot.glsl", {"", ""}}};
  CHECK_THROWS_AS(ShaderLibrary({}, overrides), UsageError);
}

TEST_CASE("ShaderLibrary reads a directory anew at each request", "[unit]") {
  const auto directory = std::filesystem::temp_directory_path() / ("twintrace_shader_source_test_" + std::to_string(getpid()));
  std::filesystem::create_directories(directory);
  const ShaderLibrary library(directory);
  std::ofstream(directory / "x.glsl") << "first";
  CHECK(library.find("x.glsl")->text == "first");
  std::ofstream(directory / "x.glsl") << "second";
  CHECK(library.find("x.glsl")->text == "second");
  CHECK(library.find("x.glsl")->displayName == (directory / "x.glsl").string());
  CHECK_FALSE(library.find("shared/layout.glsl"));
  CHECK_FALSE(library.find("."));
  std::filesystem::remove_all(directory);
}

TEST_CASE("embeddedShaders hold the files of the source tree to the byte", "[unit]") {
  for (const EmbeddedShader& shader : embeddedShaders()) {
    std::ifstream stream(std::filesystem::path(TWINTRACE_SOURCE_DIR) / "shaders" / shader.path,
                         std::ios::binary);
    INFO(shader.path);
    CHECK(std::string(std::istreambuf_iterator<char>(stream), {}) == shader.text);
  }
}

TEST_CASE("mapLog rewrites the places in the logs of Mesa and NVIDIA", "[unit]") {
  ShaderSource source;
  source.files = {"<prelude>", "shaders/x.glsl"};
  source.lines = {{0, 0}, {0, 1}, {1, 12}};
  CHECK(source.mapLog("0:3(5): error: `a' undeclared\n") ==
        "shaders/x.glsl:12:5: error: `a' undeclared\n");
  CHECK(source.mapLog("0(3) : error C1503: undefined variable") ==
        "shaders/x.glsl:12: error C1503: undefined variable\n");
}

TEST_CASE("mapLog leaves lines without a known place alone", "[unit]") {
  ShaderSource source;
  source.files = {"<prelude>"};
  source.lines = {{0, 0}};
  const std::string log = "error: no main\n0:0(5): error\n0:2(5): error: x\n7:1(5): error: x\n";
  CHECK(source.mapLog(log) == log);
}

}  // namespace twintrace
