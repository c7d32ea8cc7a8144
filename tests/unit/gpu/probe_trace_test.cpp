#include <bit>
#include <sstream>

#include "common/scene/reader.h"
#include "gpu/probe.h"
#include "tests/unit/gpu/gl_fixture.h"

namespace twintrace {
namespace {

// Three functions that call each other, and a branch.
constexpr const char* kLibrary = R"glsl(#pragma once
float added(float x, float y) {
  precise float sum = x + y;
  return sum;
}
float chosen(float x) {
  precise float y = x;
  if (x < 0.0f) y = added(x, 1.0f);
  for (int i = 0; i < 2; ++i) {
    y = added(y, y);
  }
  return y;
}
)glsl";

constexpr const char* kMain = R"glsl(
#include "mains/uniforms.glsl"

#include "toy.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer ProbeInputs { uint probeInputs[]; };
layout(std430, binding = 1) writeonly buffer ProbeOutputs { uint probeOutputs[]; };
uniform int probeCount;

void main() {
  int record = int(gl_GlobalInvocationID.x);
  if (record >= probeCount) {
    return;
  }
  float result = chosen(uintBitsToFloat(probeInputs[record]));
  probeOutputs[record] = floatBitsToUint(result);
}
)glsl";

FlatScene smallScene() {
  return flatten(parseScene("[[objects]]\nname = \"a\"\nshape = \"sphere\"\ncenter = [0, 0, 0]\n"
                            "radius = 1.0\nmaterial = \"m\"\n[materials.m]\nalbedo = [1, 1, 1]\n"
                            "[camera]\neye = [0, 0, 3]\ntarget = [0, 0, 0]\nfov = 40.0\n",
                            "toy.toml"),
                 RenderOptions{});
}

/// The events of chosen(x), one text each: a function's or statement's text and its values.
std::vector<std::string> events(Context& context, float x, std::uint32_t& output) {
  ShaderLibrary library;
  library.add("toy.glsl", {kLibrary, ""});
  RenderOptions options;
  options.geometry = Geometry::buffer;
  InstrumentSettings settings;
  settings.statements = [](const GlslFunction& f) { return f.name == "chosen"; };
  const std::uint32_t input = std::bit_cast<std::uint32_t>(x);
  const ProbeTrace traced = traceProbe(context, library, {kMain, 1, 1}, smallScene(), options,
                                       std::span(&input, 1), settings);
  output = traced.outputs.at(0);
  std::vector<std::string> found;
  const auto& words = traced.trace.words;
  for (std::size_t at = 0; at < words.size();) {
    const TraceSite& site = traced.program.sites.at(words[at++]);
    const auto function = static_cast<std::size_t>(site.function);
    std::ostringstream text;
    const bool isEntry = site.kind == TraceSite::Kind::enter;
    text << (isEntry ? traced.program.functions[function].name : site.text);
    for (std::size_t i = 0; i < site.slots.size(); ++i) {
      text << ' ' << std::bit_cast<float>(words[at++]);
    }
    found.push_back(text.str());
  }
  return found;
}

}  // namespace

TEST_CASE("traceProbe tells calls and statements in the order of time", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  std::uint32_t output = 0;
  const std::vector<std::string> expected = {
      "chosen 1",      "precise float y = x; 1", "added 1 1",
      "return sum; 2", "y = added(y, y); 2",     "added 2 2",
      "return sum; 4", "y = added(y, y); 4",     "return y; 4"};
  CHECK(events(*context, 1.0f, output) == expected);
  CHECK(std::bit_cast<float>(output) == 4.0f);
}

TEST_CASE("traceProbe tells only statements that were executed", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  std::uint32_t output = 0;
  const auto found = events(*context, -3.0f, output);
  REQUIRE(found.size() == 12);
  CHECK(found[2] == "added -3 1");
  CHECK(found[4] == "y = added(x, 1.0f); -2");
  CHECK(std::bit_cast<float>(output) == -8.0f);
}

}  // namespace twintrace
