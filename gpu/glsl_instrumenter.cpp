#include "gpu/glsl_instrumenter.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/word_char.h"

namespace twintrace {
namespace {

// A store of every value would take the driver minutes to compile, and a sample is cheap to repeat.
// So each invocation runs the whole sample and keeps the one event whose number is its own, by
// selection into a few variables.
constexpr std::string_view kPrelude =
    "uint traceEvent = 0u;\n"
    "uint traceWanted = 0u;\n"
    "uint traceSite = 0u;\n"
    "bool traceHere = false;\n"
    "bool traceMuted = false;\n"
    "void traceBegin(uint site) { traceHere = !traceMuted && traceEvent == traceWanted; "
    "traceEvent = traceMuted ? traceEvent : traceEvent + 1u; "
    "traceSite = traceHere ? site : traceSite; }\n";

/// The variable that a result is kept in; traces name it `result`.
const std::string kResult = "result_";

/// GLSL text that makes a word of a value.
std::string wordOf(const TraceSlot& slot) {
  switch (slot.kind) {
    case WordKind::real:
      return "floatBitsToUint(float(" + slot.path + "))";  // it may be a double
    case WordKind::truth:
      return "(" + slot.path + " ? 1u : 0u)";
    case WordKind::integer:
      return "uint(" + slot.path + ")";
    case WordKind::natural:
      break;
  }
  return slot.path;
}

/// The text with all white space made single blanks.
std::string withSingleBlanks(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!blank) {
      result += c;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  return result;
}

/// The words of a statement's beginning, without qualifiers, and what follows them.
struct StatementHead {
  std::vector<std::string_view> words;
  std::string_view follows;
};

StatementHead headOf(std::string_view statement) {
  StatementHead head;
  while (true) {
    const std::size_t first = statement.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return head;
    statement.remove_prefix(first);
    if (!isWordChar(statement.front())) break;
    std::size_t end = 0;
    while (end < statement.size() && isWordChar(statement[end])) ++end;
    const std::string_view word = statement.substr(0, end);
    if (word != "precise" && word != "const") head.words.push_back(word);
    statement.remove_prefix(end);
  }
  head.follows = statement;
  return head;
}

/// Whether a statement that begins with one name gives it, or a member of it, a value.
bool assigns(std::string_view follows) {
  std::size_t at = 0;
  while (at < follows.size() && (follows[at] == '.' || isWordChar(follows[at]))) ++at;
  while (at < follows.size() && follows[at] == ' ') ++at;
  const std::string_view rest = follows.substr(at);
  if (rest.starts_with("==")) return false;
  return rest.starts_with("=") || (rest.size() > 1 && rest[1] == '=' &&
                                   std::string_view("+-*/|&^%").find(rest[0]) != rest.npos);
}

class Instrumenter {
 public:
  Instrumenter(const ShaderSource& source, const InstrumentSettings& settings)
      : source_(source), settings_(settings), parsed_(parseGlsl(source.text, "shader")) {
    std::size_t at = 0;
    do {
      lineStarts_.push_back(at);
      at = source_.text.find('\n', at);
    } while (at++ != std::string::npos);
  }

  InstrumentedShader run() {
    for (const GlslStruct& structure : parsed_.structs) addStruct(structure);
    for (const GlslFunction& function : parsed_.functions) addFunction(function);
    result_.source = source_;
    result_.source.text = withInsertions();
    addPrelude();
    return std::move(result_);
  }

 private:
  void insert(std::size_t at, std::string text) { insertions_.emplace_back(at, std::move(text)); }

  void addStruct(const GlslStruct& structure) {
    std::vector<TraceVariable> members;
    for (const GlslVariable& field : structure.fields) {
      if (!isTraceable(structs_, field.type)) return;
      members.push_back({field.type, field.name});
    }
    structs_[structure.name] = std::move(members);
  }

  void addFunction(const GlslFunction& function) {
    if (!isTraceable(structs_, function.result)) return;
    for (const GlslVariable& p : function.parameters) {
      if (!isTraceable(structs_, p.type) || p.direction != GlslDirection::in) return;
    }
    if (settings_.calls && !settings_.calls(function)) return;
    result_.program.functions.push_back(describe(function));
    addEntry(function);
    const bool statements = settings_.statements && settings_.statements(function);
    addStatements(function, statements);
  }

  TraceFunction describe(const GlslFunction& function) const {
    TraceFunction traced{function.name, function.result, {}, place(function.place)};
    for (const GlslVariable& p : function.parameters) traced.parameters.push_back({p.type, p.name});
    return traced;
  }

  /// `file:line` of an offset of the text.
  std::string place(std::size_t offset) const {
    const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
    const auto index = static_cast<std::size_t>(next - lineStarts_.begin()) - 1;
    const ShaderSource::Line line = source_.lines.at(index);
    return fmt::format("{}:{}", source_.files[line.file], line.number);
  }

  /// Adds a site and returns the text that records its values.
  /// @param statement without its semicolon; empty on entry.
  std::string record(TraceSite::Kind kind, std::size_t offset, std::string_view statement,
                     const std::vector<TraceVariable>& values) {
    TraceSite site{
        kind, static_cast<int>(result_.program.functions.size()) - 1, place(offset), {}, ""};
    if (!statement.empty()) site.text = withSingleBlanks(statement) + ";";
    for (const TraceVariable& value : values) {
      for (TraceSlot& slot : traceSlots(structs_, value)) site.slots.push_back(std::move(slot));
    }
    std::string text = fmt::format(" traceBegin({}u);", result_.program.sites.size());
    for (std::size_t i = 0; i < site.slots.size(); ++i) {
      text += fmt::format(" traced{0} = traceHere ? {1} : traced{0};", i, wordOf(site.slots[i]));
    }
    result_.width = std::max(result_.width, static_cast<int>(site.slots.size()));
    result_.program.sites.push_back(std::move(site));
    return text;
  }

  void addEntry(const GlslFunction& function) {
    const TraceFunction& traced = result_.program.functions.back();
    insert(function.body.begin + 1,
           record(TraceSite::Kind::enter, function.place, "", traced.parameters));
  }

  /// Goes through a function's statements: returns are rewritten, and values recorded if asked for.
  void addStatements(const GlslFunction& function, bool values) {
    std::map<std::string, std::string, std::less<>> types;
    for (const GlslVariable& p : function.parameters) types[p.name] = p.type;
    const std::string& text = parsed_.text;
    int depth = 0;
    std::size_t begin = function.body.begin + 1;
    for (std::size_t at = begin; at < function.body.end; ++at) {
      const char c = text[at];
      if (c == '(' || c == '[') ++depth;
      if (c == ')' || c == ']') --depth;
      if (depth > 0) continue;
      if (c == ';') addStatement(function, begin, at, values, types);
      if (c == ';' || c == '{' || c == '}') begin = at + 1;
    }
  }

  template <class Types>
  void addStatement(const GlslFunction& function, std::size_t begin, std::size_t end, bool values,
                    Types& types) {
    const std::size_t whole = withoutBlanks(begin, end);
    begin = behindConditions(begin, end);
    const StatementHead head = headOf(statement(begin, end));
    if (head.words.empty()) return;
    if (head.words[0] == "return") return addReturn(function, begin, end);
    if (!values) return;
    if (head.words.size() == 2 && isTraceable(structs_, std::string(head.words[0]))) {
      types[std::string(head.words[1])] = head.words[0];
      if (head.follows.starts_with("=")) addLocal(head.words[1], {begin, end}, false, types);
    } else if (head.words.size() == 1 && assigns(head.follows)) {
      addLocal(head.words[0], {begin, end}, begin != whole, types);
    }
  }

  /// Behind the `if (...)`, `else`, `for (...)` and `while (...)` that a statement hangs on.
  std::size_t behindConditions(std::size_t begin, std::size_t end) const {
    const std::string& text = parsed_.text;
    while (true) {
      begin = withoutBlanks(begin, end);
      std::size_t word = begin;
      while (word < end && isWordChar(text[word])) ++word;
      const std::string_view name = std::string_view(text).substr(begin, word - begin);
      if (name == "else" || name == "do") {
        begin = word;
      } else if (name == "if" || name == "for" || name == "while") {
        begin = behindBracket(word, end);
      } else {
        return begin;
      }
    }
  }

  std::size_t withoutBlanks(std::size_t begin, std::size_t end) const {
    return std::min(parsed_.text.find_first_not_of(" \t\r\n", begin), end);
  }

  std::string_view statement(std::size_t begin, std::size_t end) const {
    return std::string_view(parsed_.text).substr(begin, end - begin);
  }

  std::size_t behindBracket(std::size_t at, std::size_t end) const {
    int depth = 0;
    for (; at < end; ++at) {
      if (parsed_.text[at] == '(') ++depth;
      if (parsed_.text[at] == ')' && --depth == 0) return at + 1;
    }
    return end;
  }

  void addReturn(const GlslFunction& function, std::size_t begin, std::size_t end) {
    // A name of its own, so that it hides none of the function's variables in the expression.
    const std::string text =
        record(TraceSite::Kind::leave, begin, statement(begin, end), {{function.result, kResult}});
    for (TraceSlot& slot : result_.program.sites.back().slots) {
      slot.path.erase(kResult.size() - 1, 1);
    }
    // Only inserted into: comments and all else of the driver's text stay as they are.
    insert(begin, fmt::format("{{ {}{} {} = (", precise(), function.result, kResult));
    erased_.emplace_back(begin, begin + std::string_view("return").size());
    insert(end, fmt::format(");{} return {}", text, kResult));
    insert(end + 1, " }");
  }

  /// In native maths the text has no `precise`.
  std::string_view precise() const {
    return source_.text.find("precise ") != std::string::npos ? "precise " : "";
  }

  template <class Types>
  void addLocal(std::string_view name, TextRange range, bool hangs, const Types& types) {
    const auto known = types.find(name);
    if (known == types.end()) return;
    if (hangs) insert(range.begin, "{ ");  // the record must hang on the same condition
    insert(range.end + 1,
           record(TraceSite::Kind::local, range.begin, statement(range.begin, range.end),
                  {{known->second, std::string(name)}}));
    if (hangs) insert(range.end + 1, " }");
  }

  std::string withInsertions() {
    std::stable_sort(insertions_.begin(), insertions_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::sort(erased_.begin(), erased_.end());
    std::string text;
    std::size_t from = 0;
    std::size_t next = 0;
    for (const auto& [at, inserted] : insertions_) {
      while (next < erased_.size() && erased_[next].first < at) {
        text += source_.text.substr(from, erased_[next].first - from);
        from = erased_[next++].second;
      }
      text += source_.text.substr(from, at - from);
      text += inserted;
      from = at;
    }
    return text + source_.text.substr(from);
  }

  /// Behind #version, which has to come first.
  void addPrelude() {
    std::string prelude(kPrelude);
    for (int i = 0; i < result_.width; ++i) prelude += fmt::format("uint traced{} = 0u;\n", i);
    prelude += storeFunction();
    ShaderSource& source = result_.source;
    const std::size_t at = source.text.find('\n') + 1;
    source.text.insert(at, prelude);
    source.files.emplace_back("<trace>");
    std::vector<ShaderSource::Line> lines;
    const auto count = static_cast<int>(std::count(prelude.begin(), prelude.end(), '\n'));
    for (int i = 1; i <= count; ++i) lines.push_back({source.files.size() - 1, i});
    source.lines.insert(source.lines.begin() + 1, lines.begin(), lines.end());
  }

  /// Stores the event that was kept, at a record's first word.
  std::string storeFunction() const {
    std::string text = "#define TRACE_STORE(at) traceWords[at] = traceSite;";
    for (int i = 0; i < result_.width; ++i) {
      text += fmt::format(" traceWords[(at) + {}] = traced{};", i + 1, i);
    }
    return text + "\n";
  }

  const ShaderSource& source_;
  const InstrumentSettings& settings_;
  GlslText parsed_;
  std::vector<std::size_t> lineStarts_;
  TraceStructs structs_;
  std::vector<std::pair<std::size_t, std::string>> insertions_;
  std::vector<std::pair<std::size_t, std::size_t>> erased_;
  InstrumentedShader result_;
};

}  // namespace

InstrumentedShader instrumentShader(const ShaderSource& source,
                                    const InstrumentSettings& settings) {
  return Instrumenter(source, settings).run();
}

}  // namespace twintrace
