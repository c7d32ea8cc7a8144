#include "tests/audit/fault_table.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <numeric>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/scene/toml_table.h"

namespace twintrace::test {
namespace {

/// Text of any kind: shaders have line ends.
std::string readShaderText(TableReader& reader, std::string_view key) {
  const std::string expected = "a text of the shader";
  const toml::node* node = reader.find(key, expected, Need::required);
  if (node == nullptr) return "";
  if (const auto* text = node->as_string()) return text->get();
  reader.faults().add(node->source().begin, describe(*node), expected);
  return "";
}

LogicFault readFault(const toml::table& table, Faults& faults) {
  TableReader reader(table, table.source().begin, faults);
  LogicFault fault;
  reader.read("name", fault.name, "a name", Need::required);
  reader.read("shader", fault.shader, "a shader", Need::required);
  fault.from = readShaderText(reader, "from");
  fault.to = readShaderText(reader, "to");
  reader.read("points_to", fault.pointsTo, "a function");
  reader.read("because", fault.because, "a reason",
              fault.pointsTo.empty() ? Need::optional : Need::required);
  reader.finish();
  return fault;
}

PictureChoice readPicture(const toml::table& table, Faults& faults) {
  TableReader reader(table, table.source().begin, faults);
  PictureChoice picture;
  reader.read("name", picture.name, "a name", Need::required);
  reader.read("scene", picture.scene, "a scene file", Need::required);
  reader.read("options", picture.options, "options");
  reader.finish();
  return picture;
}

std::string readWholeFile(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw IoError(path + ": found no file that can be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

AuditTable readAuditTable(const std::string& path) {
  const toml::table root = parseToml(readWholeFile(path), path);
  Faults faults(path);
  TableReader reader(root, {1, 1}, faults);
  AuditTable table;
  for (const toml::table* row : reader.readTables("pictures")) {
    table.pictures.push_back(readPicture(*row, faults));
  }
  for (const toml::table* row : reader.readTables("families")) {
    TableReader family(*row, row->source().begin, faults);
    family.read("name", table.families.emplace_back(), "a family", Need::required);
    family.finish();
  }
  for (const toml::table* row : reader.readTables("faults")) {
    table.faults.push_back(readFault(*row, faults));
  }
  reader.finish();
  faults.throwIfAny();
  return table;
}

std::vector<std::size_t> chooseFaults(const AuditTable& table,
                                      const std::vector<std::string>& names) {
  std::vector<std::size_t> chosen(names.empty() ? table.faults.size() : 0);
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  std::vector<std::string> known;
  for (const LogicFault& fault : table.faults) known.push_back(fault.name);
  for (const std::string& name : names) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      throw UsageError("found fault " + quote(name) + ", expected one of the table" +
                       didYouMean(name, known));
    }
    chosen.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  return chosen;
}

}  // namespace twintrace::test
