#include "common/trace/call_trace.h"

#include <optional>
#include <string_view>

namespace twintrace {
namespace {

std::optional<WordKind> scalarKind(std::string_view type) {
  if (type == "float" || type == "double") return WordKind::real;
  if (type == "int") return WordKind::integer;
  if (type == "uint") return WordKind::natural;
  if (type == "bool") return WordKind::truth;
  return std::nullopt;
}

/// The element type of a GLSL vector, and its length; length 0 for other types.
struct Vector {
  WordKind kind = WordKind::real;
  int length = 0;
};

Vector vectorOf(std::string_view type) {
  const std::size_t at = type.find("vec");
  if (at == std::string_view::npos || at > 1 || type.size() != at + 4) return {};
  const int length = type.back() - '0';
  if (length < 2 || length > 4) return {};
  if (at == 0) return {WordKind::real, length};
  switch (type.front()) {
    case 'i':
      return {WordKind::integer, length};
    case 'u':
      return {WordKind::natural, length};
    case 'b':
      return {WordKind::truth, length};
    case 'd':
      return {WordKind::real, length};
    default:
      return {};
  }
}

void addSlots(const TraceStructs& structs, const TraceVariable& variable,
              std::vector<TraceSlot>& slots) {
  if (const auto kind = scalarKind(variable.type)) {
    slots.push_back({variable.name, *kind});
    return;
  }
  const Vector vector = vectorOf(variable.type);
  for (int i = 0; i < vector.length; ++i) {
    slots.push_back({variable.name + "." + "xyzw"[i], vector.kind});
  }
  const auto found = structs.find(variable.type);
  if (found == structs.end()) return;
  for (const TraceVariable& member : found->second) {
    addSlots(structs, {member.type, variable.name + "." + member.name}, slots);
  }
}

}  // namespace

bool isTraceable(const TraceStructs& structs, const std::string& type) {
  return scalarKind(type) || vectorOf(type).length > 0 || structs.contains(type);
}

std::vector<TraceSlot> traceSlots(const TraceStructs& structs, const TraceVariable& variable) {
  std::vector<TraceSlot> slots;
  addSlots(structs, variable, slots);
  return slots;
}

std::string signatureOf(const TraceFunction& function) {
  std::string types;
  for (const TraceVariable& p : function.parameters) {
    types += (types.empty() ? "" : ", ") + p.type;
  }
  return function.name + "(" + types + ")";
}

}  // namespace twintrace
