#include <thread>

#include "gpu/gl_api.h"
#include "gpu/shared_library.h"
#include "tests/unit/gpu/gl_fixture.h"

namespace twintrace {

namespace {

constexpr Provider kProviders[] = {Provider::osmesa, Provider::egl};

/// What a 1x1 target shows of a program that writes a constant.
float drawnConstant(Context& context, const std::string& value) {
  Program program(context, Stage::fragment,
                  sourceOf("out vec4 color;\nvoid main() { color = vec4(" + value + "); }\n"));
  return drawnPixels(context, program, 1, 1)[0];
}

}  // namespace

TEST_CASE("createContext gives OpenGL 4.5 or later and says what runs it", "[gl]") {
  inEachContext([](Context& context) {
    CHECK(context.version() >= "4.5");
    CHECK_FALSE(context.renderer().empty());
    CHECK_FALSE(context.vendor().empty());
    CHECK_FALSE(context.source().empty());
  });
}

TEST_CASE("egl leaves software devices to the surfaceless platform", "[gl]") {
  const auto context = contextOrSkip(Provider::egl);
  if (!context || context->renderer().find("llvmpipe") == std::string::npos) return;
  CHECK(context->source() == "EGL surfaceless");
}

TEST_CASE("contexts of both providers work one after the other", "[gl]") {
  for (const Provider provider : {Provider::egl, Provider::osmesa, Provider::egl}) {
    const auto context = contextOrSkip(provider);
    if (context) CHECK(drawnConstant(*context, "0.5") == 0.5f);
  }
}

TEST_CASE("contexts of both providers take turns on one thread", "[gl]") {
  const auto osmesa = contextOrSkip(Provider::osmesa);
  const auto egl = contextOrSkip(Provider::egl);
  if (!osmesa || !egl) return;
  FloatTarget target(*osmesa, 1, 1);
  Program program(*osmesa, Stage::fragment,
                  sourceOf("out vec4 color;\nvoid main() { color = vec4(0.25); }\n"));
  CHECK(drawnConstant(*egl, "0.75") == 0.75f);
  target.draw(program);
  CHECK(drawnConstant(*egl, "0.625") == 0.625f);
  float pixel[4];
  target.read(pixel);
  CHECK(pixel[0] == 0.25f);
}

TEST_CASE("a context outlives another of the same provider", "[gl]") {
  for (const Provider provider : kProviders) {
    const auto context = contextOrSkip(provider);
    if (!context) continue;
    CHECK(drawnConstant(*contextOrSkip(provider), "0.5") == 0.5f);
    CHECK(drawnConstant(*context, "0.25") == 0.25f);
  }
}

TEST_CASE("a context moves to another thread", "[gl]") {
  inEachContext([](Context& context) {
    float pixel = 0;
    std::thread([&] { pixel = drawnConstant(context, "0.5"); }).join();
    CHECK(pixel == 0.5f);
    CHECK(drawnConstant(context, "0.25") == 0.25f);
  });
}

TEST_CASE("check names the GL error and what was going on", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  const auto current = context->use();
  context->gl().Enable(0x1234);
  const std::string message = messageOf<DeviceError>([&] { context->check("testing"); });
  CHECK(message.find("GL error GL_INVALID_ENUM while testing") == 0);
  CHECK(message.find("glEnable") != std::string::npos);
  context->check("going on after an error");
}

TEST_CASE("SharedLibrary names the library and package that are missing", "[unit]") {
  const std::string message =
      messageOf<DeviceError>([] { SharedLibrary({"libtwintrace-none.so.1"}, "libnone1"); });
  CHECK(message.find("libtwintrace-none.so.1 can't be loaded (Debian package libnone1)") !=
        std::string::npos);
}

TEST_CASE("SharedLibrary names the function that is missing", "[unit]") {
  const SharedLibrary library({"libm.so.6"}, "libc6");
  CHECK(library.function<double(double)>("cos")(0.0) == 1.0);
  CHECK(messageOf<DeviceError>([&] { library.function<void()>("twintraceNone"); }) ==
        "library libm.so.6 lacks the function twintraceNone");
}

}  // namespace twintrace
