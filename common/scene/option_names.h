#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "common/trace/options.h"

namespace twintrace {

enum class OptionType { integer, number, text };
using OptionValue = std::variant<std::int64_t, double, std::string>;

/// One field of RenderOptions as users write it: `--name value`, `--a name=value`, and a key of
/// [film] (width, height) or [render] (the rest) in a scene file.
struct Option {
  std::string name;
  OptionType type;
  std::string expected;              ///< allowed values in words, for messages and --help
  std::vector<std::string> choices;  ///< all allowed words, or empty if they can't be listed
  /// Sets the field and what it implies; false, and nothing set, if the value is not allowed. The
  /// value must hold the option's type.
  bool (*set)(RenderOptions& options, const OptionValue& value);
  /// The field as a text that `setOption` reads back to the same value.
  std::string (*get)(const RenderOptions& options);
};

/// All options, in the order of RenderOptions' documentation.
const std::vector<Option>& renderOptionTable();

/// The option of that name, or nullptr.
const Option* findOption(std::string_view name);

/// The text as a value of the type, or nothing if it isn't one.
std::optional<OptionValue> parseOptionValue(OptionType type, std::string_view text);

/// Sets one option from text, for example ("noise", "pcg").
/// @throws UsageError with the allowed names or values, and the nearest one.
void setOption(RenderOptions& options, std::string_view name, std::string_view text);

/// Sets options from `name=value,name=value`, as `--a` and `--b` take them. A part without `=`
/// continues the value before it, so that lists of effects can be given.
/// @throws UsageError as setOption does.
void setOptions(RenderOptions& options, std::string_view list);

/// Name and value of every option, for results.
std::vector<std::pair<std::string, std::string>> listOptions(const RenderOptions& options);

/// What is wrong with the film's size as a whole, as `found ..., expected ...`, or nothing.
std::optional<std::string> filmConflict(const RenderOptions& options);

/// What is wrong with the range of samples as a whole, as `found ..., expected ...`, or nothing.
std::optional<std::string> sampleConflict(const RenderOptions& options);

/// Checks what no option shows alone, once all are set.
/// @throws UsageError for a film or a range of samples that can't be rendered.
void checkOptions(const RenderOptions& options);

}  // namespace twintrace
