#include <iostream>

#include "experiments/cli/command_line.h"

int main(int argc, char** argv) {
  return twintrace::runCommandLine({argv + 1, argv + argc}, {std::cout, std::cerr});
}
