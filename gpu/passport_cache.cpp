#include "gpu/passport_cache.h"

#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "common/base/error.h"
#include "common/film/atomic_file.h"
#include "gpu/context.h"

namespace twintrace {
namespace {

/// The digest, what is corrected, then a fact per line.
std::string textOf(const DevicePassport& passport) {
  std::string text = passport.digest() + '\n';
  text += passport.corrections.division ? '1' : '0';
  text += passport.corrections.root ? "1\n" : "0\n";
  for (const PassportFact& fact : passport.facts) {
    text += fact.name + '\t' + fact.value + '\t' + (fact.breaksStrict ? '1' : '0') + '\n';
  }
  return text;
}

std::optional<DevicePassport> read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string digest;
  std::string corrected;
  if (!std::getline(stream, digest) || !std::getline(stream, corrected)) return std::nullopt;
  if (corrected.size() != 2) return std::nullopt;
  DevicePassport passport;
  passport.corrections = {corrected[0] == '1', corrected[1] == '1'};
  std::string line;
  while (std::getline(stream, line)) {
    std::istringstream parts(line);
    PassportFact fact;
    std::string breaks;
    if (!std::getline(parts, fact.name, '\t') || !std::getline(parts, fact.value, '\t') ||
        !std::getline(parts, breaks)) {
      return std::nullopt;
    }
    fact.breaksStrict = breaks == "1";
    passport.facts.push_back(fact);
  }
  if (passport.digest() != digest) return std::nullopt;
  return passport;
}

void write(const std::filesystem::path& path, const DevicePassport& passport) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  try {
    AtomicFile file(path.string());
    std::ofstream stream(file.partialPath());
    stream << textOf(passport);
    stream.close();
    if (stream) file.commit();
  } catch (const IoError&) {
    // The next program measures again.
  }
}

}  // namespace

DevicePassport passportOf(Context& context, const ShaderLibrary& library,
                          const std::filesystem::path& directory) {
  if (directory.empty()) return measurePassport(context, library);
  const std::filesystem::path file = directory / ("passport-" + passportKey(context, library));
  if (auto known = read(file)) {
    known->renderer = context.renderer();
    known->version = context.version();
    return *known;
  }
  const DevicePassport passport = measurePassport(context, library);
  write(file, passport);
  return passport;
}

}  // namespace twintrace
