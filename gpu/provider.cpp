#include "gpu/provider.h"

#include "gpu/platform.h"

#include <cstdlib>
#include <string>

#include "common/base/flush_denormals.h"

namespace twintrace {

std::unique_ptr<Context> createContext(Provider provider, int threads) {
  if (threads > 0) setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  // llvmpipe flushes denormals in its fragment threads but not in its compute threads; those it
  // starts here, and they inherit the setting of this thread.
  const FlushDenormals flush;
  return std::make_unique<Context>(provider == Provider::osmesa ? createOsmesaPlatform()
                                                                : createEglPlatform());
}

}  // namespace twintrace
