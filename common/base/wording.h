#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace twintrace {

/// The text in single quotes for a message: control characters as \xNN, cut after 60 bytes.
std::string quote(std::string_view text);

/// A choice in words: `a`, `a or b`, `a, b or c`; beyond 30 words the rest is only counted.
std::string oneOf(std::span<const std::string> words);

/// ` (did you mean 'x'?)` for the candidate nearest to the word, or nothing if none is near.
std::string didYouMean(std::string_view word, std::span<const std::string> candidates);

/// `1 vertex`, `3 vertices`.
std::string counted(std::int64_t count, std::string_view one, std::string_view many);

}  // namespace twintrace
