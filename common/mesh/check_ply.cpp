#include "common/mesh/check_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

#include "common/base/wording.h"
#include "common/mesh/load_mesh.h"

namespace twintrace {
namespace {

enum class Format { ascii, littleEndian, bigEndian };

struct Property {
  std::size_t size = 0;       // bytes of a value
  std::size_t countSize = 0;  // bytes of a list's length; 0: one value
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

constexpr std::string_view kSpace = " \t\r\n";

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t at = line.find_first_not_of(kSpace); at != line.npos;
       at = line.find_first_not_of(kSpace, at)) {
    const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
    result.push_back(line.substr(at, end - at));
    at = end;
  }
  return result;
}

std::optional<std::uint64_t> wholeNumber(std::string_view word) {
  std::uint64_t number = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// Assimp takes a number that begins a name for the count.
bool isName(std::string_view word) {
  return word[0] < '0' || word[0] > '9';
}

/// Bytes of a value; 0 for no type of PLY.
std::size_t sizeOfType(std::string_view type) {
  for (const std::string_view one : {"char", "uchar", "int8", "uint8"}) {
    if (type == one) return 1;
  }
  for (const std::string_view two : {"short", "ushort", "int16", "uint16"}) {
    if (type == two) return 2;
  }
  for (const std::string_view four : {"int", "uint", "float", "int32", "uint32", "float32"}) {
    if (type == four) return 4;
  }
  return type == "double" || type == "float64" ? 8 : 0;
}

/// Walks through a file, value by value.
class PlyWalk {
 public:
  PlyWalk(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  void run() {
    if (words(takeLine()) != std::vector<std::string_view>{"ply"}) {
      fault("no first line 'ply'", "a PLY file");
    }
    readHeader();
    for (const Element& element : elements_) {
      if (element.properties.empty()) continue;
      for (std::uint64_t i = 0; i < element.count; ++i) {
        if (!skip(element)) {
          fault(fmt::format("the end after {} of {} elements {}", i, element.count,
                            quote(element.name)),
                "all of them");
        }
      }
    }
  }

 private:
  [[noreturn]] void fault(const std::string& found, const std::string& expected) const {
    throw MeshError(fmt::format("found {} in {}, expected {}", found, quote(path_), expected));
  }

  std::string_view takeLine() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string_view line = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    return line;
  }

  void readHeader() {
    while (at_ < bytes_.size()) {
      const std::string_view line = takeLine();
      const std::vector<std::string_view> found = words(line);
      if (found.empty() || found[0] == "comment" || found[0] == "obj_info") continue;
      if (found[0] == "end_header") return;
      if (!readHeaderLine(found)) {
        fault("header line " + quote(line), "'format', 'element', 'property' or 'comment'");
      }
    }
    fault("no line 'end_header'", "one");
  }

  bool readHeaderLine(const std::vector<std::string_view>& line) {
    if (line[0] == "format" && line.size() >= 2) return readFormat(line[1]);
    if (line[0] == "element" && line.size() == 3) {
      const std::optional<std::uint64_t> count = wholeNumber(line[2]);
      if (!count || !isName(line[1])) return false;
      elements_.push_back({std::string(line[1]), *count, {}});
      return true;
    }
    if (line[0] != "property" || elements_.empty()) return false;
    Property property;
    if (line.size() == 3) {
      property.size = sizeOfType(line[1]);
    } else if (line.size() == 5 && line[1] == "list") {
      property = {sizeOfType(line[3]), sizeOfType(line[2])};
      if (property.countSize == 0) return false;
    }
    elements_.back().properties.push_back(property);
    return property.size != 0;
  }

  bool readFormat(std::string_view name) {
    if (name == "binary_little_endian") format_ = Format::littleEndian;
    if (name == "binary_big_endian") format_ = Format::bigEndian;
    return name == "ascii" || format_ != Format::ascii;
  }

  /// These step over something; false if the file ends before.
  bool skip(const Element& element) {
    return std::ranges::all_of(element.properties,
                               [this](const Property& property) { return skip(property); });
  }

  bool skip(const Property& property) {
    std::uint64_t count = 1;
    if (property.countSize != 0) {
      const std::optional<std::uint64_t> length = takeLength(property.countSize);
      if (!length) return false;
      count = *length;
    }
    if (format_ == Format::ascii) {
      while (count > 0 && !takeWord().empty()) --count;
      return count == 0;
    }
    if (count > (bytes_.size() - at_) / property.size) return false;
    at_ += count * property.size;
    return true;
  }

  std::optional<std::uint64_t> takeLength(std::size_t size) {
    if (format_ == Format::ascii) return wholeNumber(takeWord());
    if (bytes_.size() - at_ < size) return std::nullopt;
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t place = format_ == Format::bigEndian ? i : size - 1 - i;
      length = length << 8 | static_cast<unsigned char>(bytes_[at_ + place]);
    }
    at_ += size;
    return length;
  }

  std::string_view takeWord() {
    const std::size_t begin = std::min(bytes_.find_first_not_of(kSpace, at_), bytes_.size());
    at_ = std::min(bytes_.find_first_of(kSpace, begin), bytes_.size());
    return bytes_.substr(begin, at_ - begin);
  }

  std::string_view bytes_;
  const std::string& path_;
  std::size_t at_ = 0;
  Format format_ = Format::ascii;
  std::vector<Element> elements_;
};

}  // namespace

void checkPly(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  PlyWalk(bytes.view(), path).run();
}

}  // namespace twintrace
