#include "gpu/program_cache.h"

#include <unistd.h>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "gpu/context.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace twintrace {

namespace {

/// What precedes the driver's bytes in a cache file. The checksum is there because drivers are not
/// built to survive a damaged binary.
struct Header {
  std::uint64_t checksum;
  std::uint64_t format;
};

std::uint64_t checksumOf(const ProgramBinary& binary) {
  return XXH3_64bits_withSeed(binary.bytes.data(), binary.bytes.size(), binary.format);
}

std::string hex(XXH128_hash_t hash) {
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, hash);
  std::string text;
  for (const unsigned char byte : bytes.digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

/// Part of every key: raise it when programs change by more than their source, such as the vertex
/// shader.
constexpr const char* kFormat = "1";

/// Covers all that decides the program: stage, text and driver.
std::string keyOf(const Context& context, Stage stage, const ShaderSource& source) {
  std::string all = stage == Stage::fragment ? "fragment" : "compute";
  for (const std::string& part :
       {std::string(kFormat), context.vendor(), context.renderer(), context.version(), source.text}) {
    all += '\0' + part;
  }
  return hex(XXH3_128bits(all.data(), all.size()));
}

std::optional<ProgramBinary> readBinary(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Header header{};
  if (!stream.read(reinterpret_cast<char*>(&header), sizeof header)) return std::nullopt;
  ProgramBinary binary{static_cast<std::uint32_t>(header.format),
                       {std::istreambuf_iterator<char>(stream), {}}};
  if (checksumOf(binary) != header.checksum) return std::nullopt;
  return binary;
}

/// Writes to a temporary file and renames it, so that a reader never sees half a binary.
void writeBinary(const std::filesystem::path& file, const ProgramBinary& binary) {
  std::string temporary = file.string() + ".XXXXXX";
  const int descriptor = mkstemp(temporary.data());
  if (descriptor < 0) return;
  close(descriptor);
  const Header header{checksumOf(binary), binary.format};
  std::ofstream stream(temporary, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(&header), sizeof header);
  stream.write(binary.bytes.data(), static_cast<std::streamsize>(binary.bytes.size()));
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(temporary, file, error);
  if (!stream || error) std::filesystem::remove(temporary, error);
}

}  // namespace

std::filesystem::path defaultProgramCacheDirectory() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && cache[0] == '/') return std::filesystem::path(cache) / "twintrace";
  const char* home = std::getenv("HOME");
  if (home == nullptr || home[0] == '\0') return {};
  return std::filesystem::path(home) / ".cache" / "twintrace";
}

ProgramCache::ProgramCache(Context& context, std::filesystem::path directory)
    : context_(context), directory_(std::move(directory)) {
  std::error_code error;
  if (!directory_.empty()) std::filesystem::create_directories(directory_, error);
}

std::shared_ptr<Program> ProgramCache::get(Stage stage, const ShaderSource& source) {
  const std::string key = keyOf(context_, stage, source);
  std::shared_ptr<Program>& program = programs_[key];
  if (program != nullptr) {
    ++counts_.fromMemory;
  } else if (auto loaded = load(key)) {
    program = std::move(loaded);
    ++counts_.fromDisk;
  } else {
    program = std::make_shared<Program>(context_, stage, source);
    ++counts_.compiled;
    store(key, *program);
  }
  return program;
}

std::unique_ptr<Program> ProgramCache::load(const std::string& key) {
  if (directory_.empty()) return nullptr;
  const auto binary = readBinary(directory_ / key);
  return binary ? Program::fromBinary(context_, *binary) : nullptr;
}

void ProgramCache::store(const std::string& key, const Program& program) const {
  if (directory_.empty()) return;
  try {
    if (const auto binary = program.binary()) writeBinary(directory_ / key, *binary);
  } catch (const DeviceError&) {
    // A driver that can't give the binary still runs the program.
  }
}

}  // namespace twintrace
