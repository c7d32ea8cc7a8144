#include "experiments/build_info.h"

namespace twintrace {

BuildInfo buildInfo() {
  return {TWINTRACE_VERSION, TWINTRACE_COMPILER, TWINTRACE_BUILD_TYPE, TWINTRACE_BUILD_FLAGS};
}

}  // namespace twintrace
