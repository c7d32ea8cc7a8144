#include "experiments/machine.h"

#include "common/base/error.h"
#include "tests/catch.h"

namespace twintrace {

TEST_CASE("checkFilmMemory refuses a film that does not fit", "[experiments]") {
  constexpr std::int64_t kGibibyte = std::int64_t{1} << 30;
  CHECK_NOTHROW(checkFilmMemory(1920, 1080, kGibibyte));
  CHECK_THROWS_AS(checkFilmMemory(16384, 16384, 8 * kGibibyte), UsageError);
  CHECK_NOTHROW(checkFilmMemory(16384, 16384, std::nullopt));
}

TEST_CASE("availableMemory is known on Linux", "[experiments]") {
  REQUIRE(availableMemory().has_value());
  CHECK(*availableMemory() > 0);
}

}  // namespace twintrace
