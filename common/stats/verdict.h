#pragma once

#include <cstdint>
#include <string_view>

#include "common/stats/equivalence.h"
#include "common/stats/family_test.h"

namespace twintrace {

enum class Verdict { identical, equivalent, different, inconclusive };

/// The name as written in reports and JSON.
std::string_view verdictName(Verdict verdict);

/// True for identical and equivalent, which exit with 0; the others exit with 1.
bool agrees(Verdict verdict);

/// Verdict on arms that drew the same samples: their bits decide, in native maths as well.
Verdict pairedVerdict(std::int64_t differingPixels);

/// Verdict on independent arms: `different` if the family test rejects, else `equivalent` if the
/// means are equal within the bound, else `inconclusive`.
Verdict unpairedVerdict(const FamilyTest& family, const Equivalence& equivalence);

}  // namespace twintrace
