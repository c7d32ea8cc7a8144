#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace twintrace {

/// An option or argument that a command takes; each call below narrows it, as in CLI::Option.
class OptionSyntax {
 public:
  explicit OptionSyntax(CLI::Option* option) : option_(option) {}

  OptionSyntax required() const;
  /// @param name stands for the value in the help, as in FILE.png
  OptionSyntax typeName(const std::string& name) const;
  /// The numbers allowed, both ends included.
  OptionSyntax range(std::uint64_t least, std::uint64_t most) const;
  /// Shows in the help the value that stands if the option is not given.
  OptionSyntax showDefault() const;
  /// @param name heading under which the help lists it
  OptionSyntax group(const std::string& name) const;
  /// Given several times, the last one counts.
  OptionSyntax takeLast() const;
  /// May be given several times with one value each.
  OptionSyntax repeatable() const;

 private:
  CLI::Option* option_;
};

/// What a subcommand takes on the command line. It keeps CLI11, whose header takes longer to
/// compile than any command, out of the commands' files.
class CommandSyntax {
 public:
  /// Adds a subcommand to a program or command.
  /// @param help says what it does
  CommandSyntax(CLI::App& program, const std::string& name, const std::string& help);

  /// Adds an option, or an argument if the name has no dash.
  /// @param names such as `-o,--output`
  /// @param value is set on parsing, and must outlive it; a std::string, a std::vector of them, a
  /// double, an int, a std::uint32_t or _64_t, or a std::optional of a std::int64_t or std::string
  template <class T>
  OptionSyntax option(const std::string& names, T& value, const std::string& help);
  /// Adds an option whose value goes to a function.
  OptionSyntax callback(const std::string& names,
                        const std::function<void(const std::string&)>& take,
                        const std::string& help);
  /// Adds an option without a value.
  OptionSyntax flag(const std::string& names, bool& value, const std::string& help);

  CLI::App* app() const { return app_; }

 private:
  CLI::App* app_;
};

}  // namespace twintrace
