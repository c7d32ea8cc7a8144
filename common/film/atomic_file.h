#pragma once

#include <string>

namespace twintrace {

/// Writes a file under a temporary name beside its final one and renames it when it is complete, so
/// that a reader or a killed run never sees half a file. Without commit() nothing is left behind.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write; ends like the final name, since image libraries choose the format by that.
  const std::string& partialPath() const { return partialPath_; }

  /// Gives the complete file its name. @throws IoError if that fails.
  void commit();

 private:
  std::string path_;
  std::string partialPath_;
};

}  // namespace twintrace
