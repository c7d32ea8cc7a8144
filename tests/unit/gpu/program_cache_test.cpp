#include "gpu/program_cache.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/unit/gpu/gl_fixture.h"

namespace twintrace {

namespace {

const char* const kText =
    "uniform float value;\nout vec4 color;\nvoid main() { color = vec4(value); }\n";

/// An empty directory that goes with the test.
class TemporaryDirectory {
 public:
  TemporaryDirectory() { std::filesystem::remove_all(path_); }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }

  const std::filesystem::path& path() const { return path_; }

  /// The files in it.
  std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> result;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      result.push_back(entry.path());
    }
    return result;
  }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("twintrace_program_cache_test_" + std::to_string(getpid())) / "programs";
};

void flipBit(const std::filesystem::path& file, std::streamoff at) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekg(at);
  const int byte = stream.get();
  stream.seekp(at);
  stream.put(static_cast<char>(byte ^ 1));
}

float drawnValue(Context& context, Program& program, float value) {
  program.set("value", value);
  return drawnPixels(context, program, 1, 1)[0];
}

/// A context whose driver gives program binaries, and a directory with the binary of kText.
class StoredProgram {
 public:
  StoredProgram() : context(contextOrSkip(Provider::osmesa)) {
    if (!context) return;
    ProgramCache cache(*context, directory.path());
    const auto program = cache.get(Stage::fragment, sourceOf(kText));
    if (!program->binary()) {
      WARN("skipped: the driver gives no program binaries");
      return;
    }
    const auto files = directory.files();
    REQUIRE(files.size() == 1);
    file = files.front();
  }

  /// What a new cache makes of the file.
  ProgramCache::Counts countsOfNewCache() {
    ProgramCache cache(*context, directory.path());
    const auto program = cache.get(Stage::fragment, sourceOf(kText));
    CHECK(drawnValue(*context, *program, 0.5f) == 0.5f);
    return cache.counts();
  }

  TemporaryDirectory directory;
  std::unique_ptr<Context> context;
  std::filesystem::path file;
};

}  // namespace

TEST_CASE("ProgramCache compiles a source once", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  ProgramCache cache(*context, {});
  const auto first = cache.get(Stage::fragment, sourceOf(kText));
  CHECK(cache.get(Stage::fragment, sourceOf(kText)) == first);
  CHECK(cache.get(Stage::fragment, sourceOf(std::string("\n") + kText)) != first);
  CHECK(cache.counts().compiled == 2);
  CHECK(cache.counts().fromMemory == 1);
}

TEST_CASE("ProgramCache finds a program on disk again", "[gl]") {
  StoredProgram stored;
  if (stored.file.empty()) return;
  CHECK(stored.countsOfNewCache().fromDisk == 1);
}

TEST_CASE("ProgramCache compiles when the file on disk is damaged", "[gl]") {
  StoredProgram stored;
  if (stored.file.empty()) return;
  // The checksum comes first: the driver's bytes behind it stay good, so only we can notice.
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(stored.file));
  for (const std::streamoff at : {std::streamoff{0}, size - 1}) {
    flipBit(stored.file, at);
    CHECK(stored.countsOfNewCache().compiled == 1);
    CHECK(stored.countsOfNewCache().fromDisk == 1);
  }
}

TEST_CASE("ProgramCache compiles when the file on disk is cut off", "[gl]") {
  StoredProgram stored;
  if (stored.file.empty()) return;
  for (const std::uintmax_t size : {0u, 10u, 16u, 100u}) {
    std::filesystem::resize_file(stored.file, size);
    CHECK(stored.countsOfNewCache().compiled == 1);
  }
}

TEST_CASE("fromBinary gives nothing when the driver rejects the bytes", "[gl]") {
  StoredProgram stored;
  if (stored.file.empty()) return;
  Program program(*stored.context, Stage::fragment, sourceOf(kText));
  ProgramBinary binary = *program.binary();
  std::fill(binary.bytes.begin(), binary.bytes.end(), '\0');
  CHECK(Program::fromBinary(*stored.context, binary) == nullptr);
  binary.format = 0;
  CHECK(Program::fromBinary(*stored.context, binary) == nullptr);
}

TEST_CASE("ProgramCache works where its directory can't be made", "[gl]") {
  const auto context = contextOrSkip(Provider::osmesa);
  if (!context) return;
  ProgramCache cache(*context, "/dev/null/twintrace");
  const auto program = cache.get(Stage::fragment, sourceOf(kText));
  CHECK(drawnValue(*context, *program, 0.25f) == 0.25f);
}

}  // namespace twintrace
