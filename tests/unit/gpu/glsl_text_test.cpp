#include "gpu/glsl_text.h"

#include <algorithm>

#include "gpu/embedded_shaders.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

std::string errorOf(const std::string& text) {
  try {
    parseGlsl(text, "a.glsl");
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

GlslFunction onlyFunction(const std::string& text) {
  const GlslText parsed = parseGlsl(text, "a.glsl");
  REQUIRE(parsed.functions.size() == 1);
  return parsed.functions.front();
}

std::string at(const std::string& text, const TextRange& range) {
  return text.substr(range.begin, range.end - range.begin);
}

}  // namespace

TEST_CASE("withoutGlslComments keeps every place", "[unit]") {
  CHECK(withoutGlslComments("a / b; // c\nd /* e\nf */ g") == "a / b;     \nd     \n     g");
}

TEST_CASE("parseGlsl reads name, result and parameters", "[unit]") {
  const GlslFunction found = onlyFunction(
      "precise vec3 shade(const in vec3 n, out float t,\n  inout highp int k, vec2) { return n; }");
  CHECK(found.name == "shade");
  CHECK(found.result == "vec3");
  CHECK(found.signature() == "shade(vec3, float, int, vec2)");
  CHECK(found.parameters[0].name == "n");
  CHECK(found.parameters[0].direction == GlslDirection::in);
  CHECK(found.parameters[1].direction == GlslDirection::out);
  CHECK(found.parameters[2].direction == GlslDirection::inout);
  CHECK(found.parameters[3].name.empty());
}

TEST_CASE("parseGlsl gives the extent of a body with blocks in it", "[unit]") {
  const std::string text = "float f(float x) { if (x > 0.0) { x = 1.0; } return x; }\nint k;";
  const GlslFunction found = onlyFunction(text);
  CHECK(at(text, found.body) == "{ if (x > 0.0) { x = 1.0; } return x; }");
  CHECK(at(text, found.whole) == text.substr(0, text.find('\n')));
}

TEST_CASE("parseGlsl takes void for no parameters", "[unit]") {
  CHECK(onlyFunction("void f(void) {}").parameters.empty());
}

TEST_CASE("parseGlsl writes arrays into the type", "[unit]") {
  const GlslFunction found = onlyFunction("float[2] f(float a[4], vec2[3] b) { return c; }");
  CHECK(found.result == "float[2]");
  CHECK(found.signature() == "f(float[4], vec2[3])");
}

TEST_CASE("parseGlsl reads the fields of a structure", "[unit]") {
  const GlslText parsed = parseGlsl("struct Ray {\n  vec3 o, d;\n  float t[2];\n};\n", "a.glsl");
  const GlslStruct* ray = parsed.findStruct("Ray");
  REQUIRE(ray != nullptr);
  REQUIRE(ray->fields.size() == 3);
  CHECK(ray->fields[1].type == "vec3");
  CHECK(ray->fields[1].name == "d");
  CHECK(ray->fields[2].type == "float[2]");
  CHECK(parsed.findStruct("Hit") == nullptr);
}

TEST_CASE("parseGlsl passes over prototypes, globals, blocks and directives", "[unit]") {
  const GlslText parsed = parseGlsl(
      "#version 450\n#define OPEN { \\\n  {\nfloat g(float x);\nconst float a[2] = {1.0, 2.0};\n"
      "const vec2 b = vec2(1.0, 2.0);\nlayout(local_size_x = 64) in;\n"
      "layout(std430, binding = 0) buffer Words { uint words[]; } all;\n"
      "// float h(float x) {\nfloat f(float x) { return x; }\n",
      "a.glsl");
  REQUIRE(parsed.functions.size() == 1);
  CHECK(parsed.functions[0].name == "f");
  CHECK(parsed.structs.empty());
}

TEST_CASE("parseGlsl tells line and column of a function", "[unit]") {
  const GlslText parsed = parseGlsl("/* a\nb */ float f() { return 1.0; }", "a.glsl");
  CHECK(parsed.location(parsed.functions.at(0).place).toString() == "a.glsl:2:12");
}

TEST_CASE("parseGlsl finds brackets without a partner", "[unit]") {
  CHECK(errorOf("float f() {\n  if (x) {\n}\n").find("a.glsl:1:11: found '{'") == 0);
  CHECK(errorOf("float f(\n").find("a.glsl:1:8: found '('") == 0);
  CHECK(errorOf("int k;\n}\n").find("a.glsl:2:1: found '}'") == 0);
}

TEST_CASE("parseGlsl finds definitions that end too soon", "[unit]") {
  CHECK(errorOf("float f()").find("a.glsl:1:1: found a definition without its end") == 0);
  CHECK(errorOf("struct A { int k; }").find("expected ';'") != std::string::npos);
  CHECK(errorOf("f(float x) { }").find("expected a function") != std::string::npos);
  CHECK(errorOf("float f(in) { }").find("without its type") != std::string::npos);
}

TEST_CASE("parseGlsl reads every file of the shader library", "[unit]") {
  std::size_t functions = 0;
  for (const EmbeddedShader& shader : embeddedShaders()) {
    INFO(shader.path);
    functions += parseGlsl(shader.text, std::string(shader.path)).functions.size();
  }
  CHECK(functions > 100);
}

}  // namespace twintrace
