// Writes the sky image of the scene `open`: twintrace_make_sky experiments/scenes/sky.exr

#include <cstdio>
#include <exception>

#include "common/film/image_io.h"
#include "experiments/tools/sky.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: twintrace_make_sky FILE.exr\n");
    return 2;
  }
  try {
    twintrace::ExrContent content;
    content.image = twintrace::makeSky();
    twintrace::writeExr(argv[1], content);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
  }
  return 0;
}
