#pragma once

#include <string>

namespace twintrace {

/// Whether the name stands for something that is neither a regular file nor a directory, such as a
/// pipe or a device.
bool isDevice(const std::string& path);

/// Writes a file under a temporary name beside its final one and renames it when it is complete, so
/// that a reader or a killed run never sees half a file. Without commit() nothing is left behind.
/// What exists and is no regular file, such as a pipe or /dev/null, is written to directly and
/// stays what it is; a link stays and its target is replaced.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write; ends like the final name, since image libraries choose the format by that.
  const std::string& partialPath() const { return direct_ ? path_ : partialPath_; }

  /// Gives the complete file its name. @throws IoError if that fails.
  void commit();

 private:
  std::string path_;  ///< without links
  bool direct_;
  std::string partialPath_;
};

}  // namespace twintrace
