#include "experiments/machine.h"

#include <tbb/version.h>

#include <array>
#include <fstream>
#include <string_view>
#include <thread>

#include "common/base/error.h"
#include "common/film/image_io.h"
#include "cpu/embree_caster.h"
#include "cpu/tracer.h"
#include "gpu/context.h"
#include "gpu/provider.h"

namespace twintrace {
namespace {

std::string cpuModel() {
  constexpr std::string_view kKey = "model name";
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line)) {
    if (!line.starts_with(kKey)) continue;
    const std::size_t start = line.find_first_not_of(" \t:", kKey.size());
    return start == std::string::npos ? "" : line.substr(start);
  }
  return "unknown";
}

ProviderFacts probe(Provider provider, std::string name) {
  ProviderFacts facts;
  facts.name = std::move(name);
  try {
    const std::unique_ptr<Context> context = createContext(provider, 0);
    facts.available = true;
    facts.renderer = context->renderer();
    facts.version = context->version();
    facts.source = context->source();
  } catch (const DeviceError& error) {
    facts.reason = error.what();
  }
  return facts;
}

}  // namespace

CpuFacts cpuFacts() {
  CpuFacts facts;
  facts.model = cpuModel();
  facts.threads = std::thread::hardware_concurrency();
  const InstructionSet best = bestInstructionSet();
  for (const InstructionSet set :
       {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set <= best) facts.instructionSets.emplace_back(instructionSetName(set));
  }
  facts.usedInstructionSet = instructionSetName(best);
  facts.lanes = laneCount(best);
  return facts;
}

std::vector<ProviderFacts> providerFacts() {
  return {probe(Provider::osmesa, "osmesa"), probe(Provider::egl, "egl")};
}

LibraryVersions libraryVersions() {
  return {{"embree", embreeVersion()},
          {"openimageio", imageLibraryVersion()},
          {"tbb", TBB_VERSION_STRING}};
}

}  // namespace twintrace
