// The reference for schlick.glsl: Schlick, "An Inexpensive BRDF Model for Physically-based
// Rendering", 1994, equation 15.
#pragma once

#include <cmath>

double schlick(double cosine, double f0) {
  return f0 + (1 - f0) * std::pow(1 - cosine, 5);
}

double schlickFast(double cosine, double f0) {
  return schlick(cosine, f0);
}
