#pragma once

#include "common/trace/call_trace.h"

namespace twintrace {

/// A traced function as the generated table has it.
struct TracedFunctionRow {
  const char* name;
  const char* result;
  const char* parameters;  ///< `type name;type name`
  const char* place;
};

/// A site as the generated table has it.
struct TraceSiteRow {
  TraceSite::Kind kind;
  int function;
  const char* place;
  const char* slots;  ///< `kind path;kind path`, the kind by its first letter
  const char* text;   ///< of the statement; empty for enter
};

}  // namespace twintrace
