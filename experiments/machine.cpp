#include "experiments/machine.h"

#include <fmt/format.h>
#include <tbb/version.h>

#include <charconv>
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

/// Film 100 bytes, frame sums 12, mean, variance and count 28, and half of that again to write
/// them.
constexpr std::int64_t kBytesPerPixel = 220;

/// The value of the first line `key : value` of one of the system's files, or nothing.
std::optional<std::string> systemFact(const char* path, std::string_view key) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (!line.starts_with(key)) continue;
    const std::size_t start = line.find_first_not_of(" \t:", key.size());
    if (start != std::string::npos) return line.substr(start);
  }
  return std::nullopt;
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
  facts.model = systemFact("/proc/cpuinfo", "model name").value_or("unknown");
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

std::optional<std::int64_t> availableMemory() {
  const auto text = systemFact("/proc/meminfo", "MemAvailable");
  std::int64_t kibibytes = 0;
  if (!text) return std::nullopt;
  const auto parsed = std::from_chars(text->data(), text->data() + text->size(), kibibytes);
  if (parsed.ec != std::errc{}) return std::nullopt;
  return kibibytes * 1024;
}

void checkFilmMemory(int width, int height, std::optional<std::int64_t> availableBytes) {
  const std::int64_t needed = std::int64_t{width} * height * kBytesPerPixel;
  if (!availableBytes || needed <= *availableBytes) return;
  throw UsageError(
      fmt::format("found a film of {} x {} pixels, which takes {:.1f} GiB of memory, expected at "
                  "most {:.1f} GiB",
                  width, height, double(needed) / (1 << 30), double(*availableBytes) / (1 << 30)));
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
