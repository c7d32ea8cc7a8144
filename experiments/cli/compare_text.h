#pragma once

#include <string>
#include <vector>

#include "experiments/compare_arms.h"

namespace twintrace {

struct ArmNames {
  std::string a;
  std::string b;
};

/// What tells two arms apart: back end, and options that differ.
ArmNames armNames(const ArmOptions& options);

/// The verdict with its reasons, line by line.
std::string verdictText(const Comparison& comparison, const ComparisonSettings& settings);

/// Times of both arms and their ratio.
std::string armsText(const ArmsComparison& result, const ArmNames& names);

/// The lines of a text.
std::vector<std::string> sheetHeader(const std::string& text);

}  // namespace twintrace
