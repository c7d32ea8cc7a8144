#include "experiments/cli/progress_display.h"

#include <sstream>

#include "tests/catch.h"

namespace twintrace {

TEST_CASE("progressText gives share, rate and time left", "[experiments]") {
  CHECK(progressText({0.25, 5'000'000, 2.0}, 10.0) == "25 %, 2.5 Msamples/s, 0:30 left");
  CHECK(progressText({0.5, 0, 0}, 3600.0) == "50 %, 1:00:00 left");
  CHECK(progressText({0, 10, 0}, 1.0) == "0 %");
}

TEST_CASE("ProgressDisplay does not print lines within 2 seconds", "[experiments]") {
  std::ostringstream stream;
  {
    ProgressDisplay display(stream, ProgressDisplay::Style::lines);
    for (int i = 0; i < 100; ++i) display.show({0.01 * i, 1, 1.0});
  }
  CHECK(stream.str().empty());
}

}  // namespace twintrace
