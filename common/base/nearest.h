#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace twintrace {

/// Edits that turn one word into the other: insertions, deletions, replacements and swaps of
/// neighbours, each of cost 1 (optimal string alignment distance; Damerau 1964). Bytes, not
/// characters, are compared.
int editDistance(std::string_view a, std::string_view b);

/// The candidate most like the word, the first of equals, or nothing if all are further away than
/// a third of the word's length rounded up: beyond that a suggestion is a guess.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace twintrace
