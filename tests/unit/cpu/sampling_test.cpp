#include "cpu/kernel/sampling.h"

#include <random>

#include "common/base/flush_denormals.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

using Vector = kernel::Vec3<float>;

TEST_CASE("sampleCosineHemisphere stays above any surface for the least random number") {
  const FlushDenormals flush;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> part(-1.0f, 1.0f);
  int below = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vector n = kernel::normalize3(Vector(part(random), part(random), part(random)));
    const Vector local = kernel::sampleCosineHemisphere(0.0f, 0.5f + 0.5f * part(random));
    const Vector d = kernel::tangentToWorld(n, local);
    const double height = double(d.x) * n.x + double(d.y) * n.y + double(d.z) * n.z;
    below += height > 0.0 ? 0 : 1;
  }
  CHECK(below == 0);
}

}  // namespace
}  // namespace twintrace
