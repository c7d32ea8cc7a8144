#include "gpu/glsl_instrumenter.h"

#include <algorithm>

#include "tests/unit/gpu/gl_fixture.h"

namespace twintrace {
namespace {

InstrumentedShader calls(const std::string& text) {
  InstrumentSettings settings;
  settings.statements = [](const GlslFunction&) { return false; };
  return instrumentShader(sourceOf(text), settings);
}

InstrumentedShader statements(const std::string& text) {
  InstrumentSettings settings;
  settings.statements = [](const GlslFunction&) { return true; };
  return instrumentShader(sourceOf(text), settings);
}

std::vector<TraceSite> sitesOf(const InstrumentedShader& shader, TraceSite::Kind kind) {
  std::vector<TraceSite> found;
  std::ranges::copy_if(shader.program.sites, std::back_inserter(found),
                       [kind](const TraceSite& site) { return site.kind == kind; });
  return found;
}

/// The texts of the statements whose values are recorded.
std::vector<std::string> recorded(const std::string& text) {
  std::vector<std::string> found;
  for (const TraceSite& site : sitesOf(statements(text), TraceSite::Kind::local)) {
    found.push_back(site.text);
  }
  return found;
}

std::vector<std::string> paths(const TraceSite& site) {
  std::vector<std::string> found;
  for (const TraceSlot& slot : site.slots) found.push_back(slot.path);
  return found;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("instrumentShader records arguments on entry and the result on return", "[unit]") {
  const InstrumentedShader shader = calls("float twice(float x, int n) {\n  return x + x;\n}\n");
  REQUIRE(shader.program.functions.size() == 1);
  CHECK(signatureOf(shader.program.functions[0]) == "twice(float, int)");
  CHECK(shader.program.functions[0].result == "float");
  CHECK(shader.program.functions[0].place == "<main.glsl>:1");
  REQUIRE(shader.program.sites.size() == 2);
  const TraceSite& enter = shader.program.sites[0];
  CHECK(enter.kind == TraceSite::Kind::enter);
  CHECK(paths(enter) == Texts{"x", "n"});
  CHECK(enter.slots[1].kind == WordKind::integer);
  const TraceSite& leave = shader.program.sites[1];
  CHECK(leave.kind == TraceSite::Kind::leave);
  CHECK(paths(leave) == Texts{"result"});
  CHECK(leave.place == "<main.glsl>:2");
  CHECK(leave.text == "return x + x;");
  CHECK(shader.width == 2);
}

TEST_CASE("instrumentShader takes structures and vectors apart", "[unit]") {
  const InstrumentedShader shader = calls(
      "struct Ray { vec3 origin; bool inside; };\n"
      "Ray same(Ray ray) { return ray; }\n");
  CHECK(paths(shader.program.sites[0]) ==
        Texts{"ray.origin.x", "ray.origin.y", "ray.origin.z", "ray.inside"});
  CHECK(shader.program.sites[0].slots[3].kind == WordKind::truth);
}

TEST_CASE("instrumentShader records statements where they are asked for", "[unit]") {
  const std::string text =
      "float first(float x) { float y = x; return y; }\n"
      "float second(float x) { float z = x; return z; }\n";
  InstrumentSettings settings;
  settings.statements = [](const GlslFunction& f) { return f.name == "second"; };
  const auto locals = sitesOf(instrumentShader(sourceOf(text), settings), TraceSite::Kind::local);
  REQUIRE(locals.size() == 1);
  CHECK(locals[0].text == "float z = x;");
  CHECK(locals[0].place == "<main.glsl>:2");
  CHECK(locals[0].function == 1);
}

TEST_CASE("instrumentShader records declarations and assignments", "[unit]") {
  CHECK(recorded("float f(float x) {\n"
                 "  precise float a = x *\n      x;\n"
                 "  float b;\n"
                 "  b = a;\n"
                 "  b += 1.0f;\n"
                 "  return b;\n}\n") == Texts{"precise float a = x * x;", "b = a;", "b += 1.0f;"});
}

TEST_CASE("instrumentShader records the whole variable of which a member is set", "[unit]") {
  const auto locals =
      sitesOf(statements("vec3 f(vec3 v) { v.y = 1.0f; return v; }\n"), TraceSite::Kind::local);
  REQUIRE(locals.size() == 1);
  CHECK(locals[0].text == "v.y = 1.0f;");
  CHECK(paths(locals[0]) == Texts{"v.x", "v.y", "v.z"});
}

TEST_CASE("instrumentShader takes no comparison or call for an assignment", "[unit]") {
  CHECK(recorded("float g(float x) { return x; }\n"
                 "float f(float x) { x == 1.0f; g(x); return x; }\n")
            .empty());
}

TEST_CASE("instrumentShader records what hangs on a condition on that condition", "[unit]") {
  const InstrumentedShader shader =
      statements("float f(float x) { if (x > 0.0f) x = 1.0f; return x; }\n");
  const std::string& text = shader.source.text;
  const std::size_t block = text.find("{ x = 1.0f; traceBegin(1u);");
  REQUIRE(block != std::string::npos);
  CHECK(text.find('}', block) < text.find("traceBegin(2u)"));
}

TEST_CASE("instrumentShader follows branches and loops", "[unit]") {
  CHECK(recorded("float f(float x) {\n"
                 "  for (int i = 0; i < 3; ++i) { x = x + 1.0f; }\n"
                 "  if (x > 2.0f) { x = 2.0f; } else x = 3.0f;\n"
                 "  while (x > 9.0f) { x = 9.0f; }\n"
                 "  return x;\n}\n") ==
        Texts{"x = x + 1.0f;", "x = 2.0f;", "x = 3.0f;", "x = 9.0f;"});
}

TEST_CASE("instrumentShader keeps a return's expression to the letter", "[unit]") {
  const InstrumentedShader shader =
      calls("float f(float x) {\n  return x /* once */ + 1.0f; // more\n}\n");
  CHECK_THAT(shader.source.text, Catch::Contains("result_ = ( x /* once */ + 1.0f);"));
  CHECK_THAT(shader.source.text, Catch::Contains("return result_; } // more"));
}

TEST_CASE("instrumentShader is precise where the text is", "[unit]") {
  CHECK_THAT(calls("float f(float x) { precise float y = x; return y; }\n").source.text,
             Catch::Contains("precise float result_"));
  CHECK_THAT(calls("float f(float x) { float y = x; return y; }\n").source.text,
             !Catch::Contains("precise"));
}

TEST_CASE("instrumentShader leaves functions that it can't trace", "[unit]") {
  const InstrumentedShader shader = calls(
      "void none(float x) { }\n"
      "float gives(out float x) { x = 1.0f; return x; }\n"
      "float turned(mat3 m) { return m[0][0]; }\n"
      "float kept(float x) { return x; }\n");
  REQUIRE(shader.program.functions.size() == 1);
  CHECK(shader.program.functions[0].name == "kept");
}

TEST_CASE("instrumentShader leaves functions that aren't asked for", "[unit]") {
  InstrumentSettings settings;
  settings.calls = [](const GlslFunction& f) { return f.name == "f"; };
  const auto shader = instrumentShader(
      sourceOf("float f(float x) { return x; }\nfloat g(float x) { return x; }\n"), settings);
  REQUIRE(shader.program.functions.size() == 1);
  CHECK(shader.program.functions[0].name == "f");
  CHECK_THAT(shader.source.text, Catch::Contains("float g(float x) { return x; }"));
}

TEST_CASE("instrumentShader rounds doubles to floats", "[unit]") {
  const InstrumentedShader shader =
      statements("float f(float x) { double y = double(x); return float(y); }\n");
  const auto locals = sitesOf(shader, TraceSite::Kind::local);
  REQUIRE(locals.size() == 1);
  CHECK(locals[0].slots.at(0).kind == WordKind::real);
  CHECK_THAT(shader.source.text, Catch::Contains("floatBitsToUint(float(y))"));
}

TEST_CASE("instrumentShader keeps the way back to the files' lines", "[unit]") {
  const std::string text = "float f(float x) {\n  float y = x;\n  return y;\n}\n";
  const InstrumentedShader shader = statements(text);
  const ShaderSource& source = shader.source;
  CHECK(source.lines.size() ==
        static_cast<std::size_t>(std::count(source.text.begin(), source.text.end(), '\n')));
  const std::size_t at = source.text.find("return result_");
  const auto line = static_cast<std::size_t>(
      std::count(source.text.begin(), source.text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  CHECK(source.files[source.lines.at(line).file] == "<main.glsl>");
  CHECK(source.lines.at(line).number == 3);
}

}  // namespace twintrace
