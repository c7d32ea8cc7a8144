#pragma once

#include <memory>

#include "common/trace/options.h"
#include "gpu/context.h"

namespace twintrace {

/// Opens a GL 4.5 core context through the given provider, whose library is loaded now.
///
/// @param threads worker threads of llvmpipe, 0 = its own choice (all). Goes through the
/// environment
///   variable LP_NUM_THREADS, which Mesa reads when a provider is first used: later contexts of the
///   same provider keep the first count, and no other thread may use the environment meanwhile.
/// @throws DeviceError that says which library or extension is missing, and which package has it.
std::unique_ptr<Context> createContext(Provider provider, int threads);

}  // namespace twintrace
