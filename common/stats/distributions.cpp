#include "common/stats/distributions.h"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace twintrace {

namespace math = boost::math;

double normalTwoSided(double z) {
  if (std::isnan(z)) return 1.0;
  if (std::isinf(z)) return 0.0;
  return 2.0 * math::cdf(math::complement(math::normal(), std::abs(z)));
}

double studentTwoSided(double t, double dof) {
  if (std::isnan(t)) return 1.0;
  return 2.0 * studentUpper(std::abs(t), dof);
}

double studentUpper(double t, double dof) {
  if (std::isnan(t)) return 1.0;
  if (std::isinf(t)) return t > 0 ? 0.0 : 1.0;
  if (std::isinf(dof)) return math::cdf(math::complement(math::normal(), t));
  return math::cdf(math::complement(math::students_t(dof), t));
}

double chiSquareUpper(double x, double dof) {
  if (std::isinf(x)) return 0.0;
  return math::cdf(math::complement(math::chi_squared(dof), x));
}

double binomialUpper(int count, int trials, double p) {
  if (count <= 0) return 1.0;
  return math::cdf(math::complement(math::binomial(trials, p), count - 1));
}

}  // namespace twintrace
