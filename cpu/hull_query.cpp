#include "cpu/hull_query.h"

#include <stdexcept>

#include "common/base/error.h"
#include "common/hulls/hull_structure.h"
#include "cpu/embree_hull.h"
#include "cpu/hull_walk.h"
#include "cpu/tracer.h"

namespace twintrace {

int HullQuery::closest(const HullQueryRay<float>&, float&) const {
  throw std::logic_error("a ray in float for a query in double");
}

int HullQuery::closest(const HullQueryRay<double>&, double&) const {
  throw std::logic_error("a ray in double for a query in float");
}

void HullQuery::count(const HullQueryRay<float>&, HullCounts&) const {}

void HullQuery::count(const HullQueryRay<double>&, HullCounts&) const {}

std::unique_ptr<HullQuery> makeHullWalk(const FlatScene& scene, const RenderOptions& options) {
  if (scene.hulls != nullptr && scene.hulls->arrangement == HullArrangement::wide) {
    if (options.precision == Precision::float64 || options.maths == Maths::native) {
      throw UsageError("hull bvh8 with precision double or maths native; expected hull bvh");
    }
    return bestInstructionSet() == InstructionSet::sse2 ? makeBvh8Sse2(scene, options)
                                                        : makeBvh8Avx2(scene, options);
  }
  auto walk = bestInstructionSet() == InstructionSet::sse2 ? makeHullWalkBaseline(scene, options)
                                                           : makeHullWalkAvx2(scene, options);
  if (walk == nullptr) throw std::logic_error("no test for the hulls of " + scene.hulls->strategy);
  return walk;
}

std::unique_ptr<HullQuery> makeHullQuery(const FlatScene& scene, const RenderOptions& options) {
  if (options.hull == "embree") return makeEmbreeHull(scene, options);
  if (scene.hulls != nullptr) return makeHullWalk(scene, options);
  return nullptr;
}

}  // namespace twintrace
