#pragma once

#include <set>
#include <string>
#include <vector>

#include "common/trace/options.h"
#include "experiments/cast/jury.h"
#include "tests/audit/damage.h"
#include "tests/audit/finding.h"

namespace twintrace::test {

/// `cast` against damaged shaders: the GPU before exact arithmetic and beside the CPU's bits, first
/// with the robust intersector, then with the report's, of which only the bits count.
class CastCheck {
 public:
  /// @param families of rays.
  /// @throws UsageError if there is no such family.
  CastCheck(const std::vector<std::string>& families, const ShaderTexts& texts);

  /// @throws DeviceError without a GL; std::logic_error if the jury finds a mistake in sound
  /// shaders.
  Finding find(const Damage& damage);

 private:
  void requireSound();
  Finding hear(const std::vector<ShaderReplacement>& shaders) const;
  Finding hear(Intersector intersector, const std::vector<ShaderReplacement>& shaders) const;

  struct Docket {
    Family family;
    CaseSet cases;
  };
  std::vector<Docket> dockets_;
  std::set<std::string> reached_;
  bool sound_ = false;
};

}  // namespace twintrace::test
