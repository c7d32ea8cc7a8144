// Audits the checks: plants the mistakes of a table in copies of the shaders, one at a time, and
// asks probe, compare, cast and explain about each. Prints the table fault x check. Exits with 1
// unless each mistake is caught by one check or more and explain names the damaged function
// wherever a picture shows it, with 2 for an invalid table or unknown names. Usage:
// twintrace_audit_checks [--table FILE] [FAULT...]; all faults of the table unless named.

#include <algorithm>
#include <cstdio>
#include <utility>

#include "common/base/error.h"
#include "tests/audit/cast_check.h"
#include "tests/audit/fault_table.h"
#include "tests/audit/picture_check.h"
#include "tests/audit/probe_check.h"

namespace twintrace::test {
namespace {

/// What the checks make of one fault.
struct Row {
  LogicFault fault;
  std::string where;
  Finding probe;
  Finding cast;
  PictureFinding pictures;
  bool explainedRight = true;  ///< also if no picture differs

  int catches() const {
    int count = 0;
    for (const Finding* finding : {&probe, &pictures.compare, &cast}) {
      count += finding->answer == Answer::yes ? 1 : 0;
    }
    return count;
  }
};

bool isExplained(const Row& row, const Damage& damage) {
  const std::set<std::string>& named = row.pictures.explained.functions;
  if (row.pictures.compare.answer != Answer::yes) return row.fault.pointsTo.empty();
  if (!row.fault.pointsTo.empty()) return named == std::set{row.fault.pointsTo};
  return std::ranges::all_of(named, [&](const std::string& name) { return damage.damages(name); });
}

/// All checks.
class Audit {
 public:
  explicit Audit(const AuditTable& table)
      : cast_(table.families, texts_), pictures_(table.pictures, TWINTRACE_SOURCE_DIR) {}

  const ShaderTexts& texts() const { return texts_; }

  Row run(const LogicFault& fault, const Damage& damage) {
    Row row{fault, damage.where(), probe_.find(damage), cast_.find(damage), pictures_.find(damage)};
    row.explainedRight = isExplained(row, damage);
    return row;
  }

 private:
  ShaderTexts texts_;
  ProbeCheck probe_;
  CastCheck cast_;
  PictureCheck pictures_;
};

const char* word(const Finding& finding) {
  switch (finding.answer) {
    case Answer::notReached:
      return "-";
    case Answer::no:
      return "no";
    case Answer::yes:
      break;
  }
  return "yes";
}

std::string explainText(const Row& row) {
  if (row.pictures.compare.answer != Answer::yes) return row.explainedRight ? "-" : "-  WRONG";
  std::string text;
  for (const std::string& name : row.pictures.explained.functions) {
    text += (text.empty() ? "" : ", ") + name;
  }
  if (!row.pictures.explained.kind.empty()) text += " (" + row.pictures.explained.kind + ")";
  return text + (row.explainedRight ? "" : "  WRONG");
}

void printRow(const Row& row) {
  std::printf("%-45s | %-21s | %-5s | %-7s | %-4s | %s\n", row.fault.name.c_str(),
              row.fault.shader.c_str(), word(row.probe), word(row.pictures.compare), word(row.cast),
              explainText(row).c_str());
  std::printf("    in %s", row.where.c_str());
  for (const auto& [check, finding] :
       {std::pair{"probe", &row.probe}, {"compare", &row.pictures.compare}, {"cast", &row.cast}}) {
    if (!finding->detail.empty()) std::printf("; %s: %s", check, finding->detail.c_str());
  }
  if (!row.fault.because.empty()) std::printf("\n    explain: %s", row.fault.because.c_str());
  std::printf("\n");
  std::fflush(stdout);
}

struct Totals {
  std::size_t caught = 0;
  std::size_t shown = 0;      ///< in a picture
  std::size_t located = 0;    ///< of these, in the damaged function
  std::size_t elsewhere = 0;  ///< of these, where the table says and gives a reason
};

Totals totalsOf(const std::vector<Row>& rows) {
  Totals totals;
  for (const Row& row : rows) {
    totals.caught += row.catches() > 0 ? 1 : 0;
    if (row.pictures.compare.answer != Answer::yes) continue;
    ++totals.shown;
    if (!row.explainedRight) continue;
    ++(row.fault.pointsTo.empty() ? totals.located : totals.elsewhere);
  }
  return totals;
}

void printLonely(const std::vector<Row>& rows, const char* check,
                 const Finding& (*of)(const Row&)) {
  std::string names;
  int count = 0;
  for (const Row& row : rows) {
    if (row.catches() != 1 || of(row).answer != Answer::yes) continue;
    names += "\n  " + row.fault.name;
    ++count;
  }
  std::printf("caught by %s alone: %d%s\n", check, count, names.c_str());
}

/// @return whether all is as it should be.
bool printSummary(const std::vector<Row>& rows) {
  const Totals totals = totalsOf(rows);
  printLonely(rows, "probe", [](const Row& row) -> const Finding& { return row.probe; });
  printLonely(rows, "compare",
              [](const Row& row) -> const Finding& { return row.pictures.compare; });
  printLonely(rows, "cast", [](const Row& row) -> const Finding& { return row.cast; });
  bool right = totals.caught == rows.size();
  for (const Row& row : rows) {
    if (row.catches() == 0) std::printf("NOT CAUGHT: %s\n", row.fault.name.c_str());
    right = right && row.explainedRight;
  }
  std::printf("%zu of %zu faults caught; %zu change a picture, and explain names\n", totals.caught,
              rows.size(), totals.shown);
  std::printf("the damaged function for %zu of them, what the table gives a reason for in %zu\n",
              totals.located, totals.elsewhere);
  return right;
}

int audit(const std::string& file, const std::vector<std::string>& names) {
  const AuditTable table = readAuditTable(file);
  const std::vector<std::size_t> chosen = chooseFaults(table, names);
  Audit audit(table);
  // All of them even if few are tried, so that each run checks that all faults still have a place.
  const std::vector<Damage> damages = plantAll(table.faults, audit.texts());
  std::printf("%-45s | %-21s | %-5s | %-7s | %-4s | %s\n", "fault", "shader", "probe", "compare",
              "cast", "explain points to");
  std::vector<Row> rows;
  for (const std::size_t index : chosen) {
    rows.push_back(audit.run(table.faults[index], damages[index]));
    printRow(rows.back());
  }
  return printSummary(rows) ? 0 : 1;
}

}  // namespace
}  // namespace twintrace::test

int main(int argc, char** argv) {
  std::string file = TWINTRACE_SOURCE_DIR "/tests/audit/logic_faults.toml";
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.size() >= 2 && names[0] == "--table") {
    file = names[1];
    names.erase(names.begin(), names.begin() + 2);
  }
  try {
    return twintrace::test::audit(file, names);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "twintrace_audit_checks: %s\n", error.what());
    return 2;
  }
}
