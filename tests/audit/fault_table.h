#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace twintrace::test {

/// A mistake to plant in a copy of the shaders: one text in the place of another.
struct LogicFault {
  std::string name;
  std::string shader;  ///< path below shaders/
  std::string from;    ///< stands in that shader exactly once
  std::string to;
  /// What explain names instead of the damaged function, and why that is right; empty = the damaged
  /// function itself. A difference that no sample shows has the name `no sample`.
  std::string pointsTo;
  std::string because;
};

/// A small picture that compare renders.
struct PictureChoice {
  std::string name;
  std::string scene;    ///< file, from the root of the repository
  std::string options;  ///< as `--a` takes them, on top of the scene's own; may be empty
};

/// The faults, and what the checks look at.
struct AuditTable {
  std::vector<PictureChoice> pictures;  ///< in the order in which they are tried
  std::vector<std::string> families;    ///< of rays, for cast
  std::vector<LogicFault> faults;
};

/// @throws IoError if the file can't be read; FileError with all that is wrong in it.
AuditTable readAuditTable(const std::string& path);

/// The indices of the faults of these names, of all if none is given.
/// @throws UsageError for a name that no fault has, with the nearest one.
std::vector<std::size_t> chooseFaults(const AuditTable& table,
                                      const std::vector<std::string>& names);

}  // namespace twintrace::test
