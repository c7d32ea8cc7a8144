#pragma once

#include <memory>
#include <set>
#include <string>

#include "experiments/probe/trial.h"
#include "gpu/context.h"
#include "tests/audit/damage.h"
#include "tests/audit/finding.h"

namespace twintrace::test {

/// `probe` against damaged shaders: the functions with the fault, then those of its file that call
/// them, until one differs from its twin.
class ProbeCheck {
 public:
  /// @throws DeviceError without a GL.
  ProbeCheck();

  /// @throws std::logic_error if a function differs without the fault too.
  Finding find(const Damage& damage);

 private:
  bool differs(const probe::ShaderFunction& function, const ShaderLibrary& library) const;
  void requireSound(const probe::ShaderFunction& function);

  std::unique_ptr<Context> context_;
  std::set<std::string> sound_;  ///< signatures of functions that agree without a fault
};

}  // namespace twintrace::test
