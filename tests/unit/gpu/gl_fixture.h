#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "gpu/buffers.h"
#include "gpu/program.h"
#include "gpu/provider.h"
#include "gpu/shader_source.h"
#include "tests/catch.h"

namespace twintrace {

/// A context, or nullptr with a message that says what is missing; the test then has nothing to do.
inline std::unique_ptr<Context> contextOrSkip(Provider provider) {
  try {
    return createContext(provider, 0);
  } catch (const DeviceError& error) {
    WARN("skipped: " << error.what());
    return nullptr;
  }
}

/// Does an action in a context of each provider that is there.
template <class Action>
void inEachContext(Action action) {
  for (const Provider provider : {Provider::osmesa, Provider::egl}) {
    if (const auto context = contextOrSkip(provider)) action(*context);
  }
}

/// A program text that needs nothing from the shader library.
inline ShaderSource sourceOf(const std::string& text) {
  ShaderRequest request;
  request.main = "main.glsl";
  request.virtualFiles["main.glsl"] = text;
  return assembleShader(ShaderLibrary(), request);
}

/// Red, green, blue and alpha of each pixel of a target that the program has been drawn to.
inline std::vector<float> drawnPixels(Context& context, const Program& program, int width,
                                      int height) {
  FloatTarget target(context, width, height);
  target.draw(program);
  std::vector<float> pixels(static_cast<std::size_t>(4 * width * height));
  target.read(pixels);
  return pixels;
}

/// The text of the exception that an action throws, or "" if it throws none.
template <class Exception, class Action>
std::string messageOf(Action action) {
  try {
    action();
  } catch (const Exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace twintrace
