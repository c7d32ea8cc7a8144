#include "gpu/device_passport.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "common/base/float_bits.h"
#include "common/scene/reader.h"
#include "cpu/tracer.h"
#include "gpu/passport_cache.h"
#include "gpu/tracer.h"
#include "tests/unit/experiments/temporary_directory.h"
#include "tests/unit/gpu/gl_fixture.h"
#include "tests/unit/gpu/inexact_shaders.h"

using namespace twintrace;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::string valueOf(const DevicePassport& passport, const std::string& name) {
  const auto found = std::ranges::find(passport.facts, name, &PassportFact::name);
  return found == passport.facts.end() ? "" : found->value;
}

/// A copy of the shaders in which one file has another text.
void writeShaders(const std::string& directory, const std::string& file, const std::string& text) {
  std::filesystem::copy(TWINTRACE_SOURCE_DIR "/shaders", directory,
                        std::filesystem::copy_options::recursive);
  test::writeBytes(directory + "/" + file, text);
}

/// Values of a small picture in which the GPU with those shaders differs from the CPU.
std::size_t differingValues(const std::string& name, const std::string& correctedText) {
  const test::TemporaryDirectory directory;
  const Scene scene = readScene(TWINTRACE_SOURCE_DIR "/experiments/scenes/" + name);
  RenderOptions options = scene.render;
  options.width = 64;
  options.height = 64;
  options.shaderDirectory = directory.file("shaders");
  writeShaders(options.shaderDirectory, kCorrectedShader, correctedText);
  const auto flat = std::make_shared<const FlatScene>(flatten(scene, options));
  std::vector<float> gpu(std::size_t{3} * 64 * 64);
  std::vector<float> cpu(gpu.size());
  makeGpuRenderer(flat, options)->renderFrame(0, 1, gpu);
  makeCpuRenderer(flat, options)->renderFrame(0, 1, cpu);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < gpu.size(); ++i) differing += sameBits(gpu[i], cpu[i]) ? 0 : 1;
  return differing;
}

}  // namespace

TEST_CASE("measurePassport finds the same facts twice, and corrections that are exact", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const DevicePassport first = measurePassport(*context, ShaderLibrary());
  CHECK(measurePassport(*context, ShaderLibrary()).digest() == first.digest());
  CHECK(valueOf(first, "corrected division") == "correctly rounded");
  CHECK(valueOf(first, "corrected square root") == "correctly rounded");
}

TEST_CASE("measurePassport finds that llvmpipe is strict by itself", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context || context->renderer().find("llvmpipe") == std::string::npos) return;
  const DevicePassport passport = measurePassport(*context, ShaderLibrary());
  CHECK(passport.strictness() == "yes");
  CHECK(valueOf(passport, "precise a * b + c") == "kept");
  CHECK(valueOf(passport, "fma") == "product, then sum");
  CHECK(valueOf(passport, "denormal results") == "flushed to zero");
  CHECK_THAT(valueOf(passport, "plain (a * k) * l"), Contains("differ"));
}

TEST_CASE("measurePassport corrects the operations that are not correctly rounded", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const DevicePassport passport = measurePassport(*context, libraryWith(inexactArithmetic()));
  CHECK(passport.corrections.division);
  CHECK(passport.corrections.root);
  CHECK_THAT(valueOf(passport, "division"), Contains("differ"));
  CHECK_THAT(passport.strictness(), StartsWith("yes, through corrected division and square root"));
  CHECK(passport.digest() != measurePassport(*context, ShaderLibrary()).digest());
}

TEST_CASE("measurePassport names the operation that breaks strict maths", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const DevicePassport passport = measurePassport(*context, libraryWith(withoutCorrection()));
  CHECK_FALSE(passport.isStrict());
  CHECK_THAT(passport.strictness(), StartsWith("no: corrected division ("));
}

TEST_CASE("passportOf gives back what it has kept, and measures anew what is damaged", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const test::TemporaryDirectory directory;
  const ShaderLibrary library = libraryWith(inexactArithmetic());
  const DevicePassport measured = passportOf(*context, library, directory.path());
  REQUIRE_FALSE(std::filesystem::is_empty(directory.path()));
  const DevicePassport kept = passportOf(*context, library, directory.path());
  CHECK(kept.facts == measured.facts);
  CHECK(kept.corrections.division);
  CHECK(kept.renderer == measured.renderer);
  for (const auto& file : std::filesystem::directory_iterator(directory.path())) {
    std::ofstream(file.path(), std::ios::app) << "more\tfacts\t1\n";
  }
  CHECK(passportOf(*context, library, directory.path()).facts == measured.facts);
}

TEST_CASE("changedFacts names facts that differ, are new or are gone", "[unit]") {
  const std::vector<PassportFact> before = {{"same", "1", false}, {"other", "1", false}, {"gone", "1", false}};
  const std::vector<PassportFact> after = {{"same", "1", false}, {"other", "2", false}, {"new", "1", false}};
  CHECK(changedFacts(before, before).empty());
  CHECK(changedFacts(before, after) == std::vector<std::string>{"other", "new", "gone"});
}

TEST_CASE("GpuRenderer draws the CPU's picture on a device with inexact division and root", "[gl]") {
  if (!contextOrSkip(Provider::osmesa)) return;
  CHECK(differingValues("cornell.toml", inexactArithmetic()) == 0);
  CHECK(differingValues("roughness-row.toml", inexactArithmetic()) == 0);
}

// Not in cornell: its radiance is a product of albedos, whatever the last bits of the way there.
TEST_CASE("GpuRenderer draws another picture if inexact division is left as it is", "[gl]") {
  if (!contextOrSkip(Provider::osmesa)) return;
  CHECK(differingValues("roughness-row.toml", withoutCorrection()) > 0);
}
