#include "gpu/provider.h"

#include "gpu/platform.h"

#include <cstdlib>
#include <string>

namespace twintrace {

std::unique_ptr<Context> createContext(Provider provider, int threads) {
  if (threads > 0) setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  return std::make_unique<Context>(provider == Provider::osmesa ? createOsmesaPlatform()
                                                                : createEglPlatform());
}

}  // namespace twintrace
