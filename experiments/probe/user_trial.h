#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/probe/ulp_histogram.h"
#include "experiments/probe/user_reference.h"
#include "experiments/results_json.h"
#include "gpu/context.h"

namespace twintrace::probe {

struct UserTrialSettings {
  std::size_t samples = 100000;  ///< random records, beyond the special ones
  std::uint64_t seed = 1;
  /// Largest distance that counts as agreement. The default, 256 ulp or 3e-5 of the value, leaves
  /// room for some dozen roundings and the driver's own sin and pow, not for another formula.
  std::uint32_t tolerance = 256;
  std::string reference;  ///< name, header (FILE.h), or empty for the text in double
};

/// One record on which shader and reference were asked.
struct UserRecord {
  std::vector<std::uint32_t> inputs;
  std::vector<std::uint32_t> gpu;
  std::vector<double> reference;
  std::uint32_t ulps = 0;  ///< of the word that is farthest
};

/// What came out for one function.
struct UserTrial {
  UserFunction function;
  std::string reference;  ///< in words
  std::uint32_t tolerance = 0;
  std::size_t records = 0;
  std::size_t beyond = 0;  ///< records farther apart than the tolerance
  UlpHistogram ulps;
  std::optional<UserRecord> worst;  ///< the first of the largest distance above 0

  bool agrees() const { return beyond == 0; }
};

/// Records of a function's inputs: special values first, then random ones, all in their ranges.
std::vector<std::uint32_t> drawUserInputs(const UserFunction& function, std::size_t randomCount,
                                          std::uint64_t seed);

/// Runs each function of a user's file on the GPU, as the driver compiles it, and compares.
/// @throws as the references do; DeviceError if the driver rejects the program.
std::vector<UserTrial> tryUserShader(Context& context, const RenderOptions& options,
                                     const UserShader& shader, const UserTrialSettings& settings);

Json userTrialJson(const UserTrial& trial);
std::string userTrialText(const UserTrial& trial);

}  // namespace twintrace::probe
