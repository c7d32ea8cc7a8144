#include "experiments/cli/command_syntax.h"

#include <CLI/CLI.hpp>
#include <optional>

namespace twintrace {

OptionSyntax OptionSyntax::required() const {
  option_->required();
  return *this;
}

OptionSyntax OptionSyntax::typeName(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

OptionSyntax OptionSyntax::range(std::uint64_t least, std::uint64_t most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

OptionSyntax OptionSyntax::showDefault() const {
  option_->capture_default_str();
  return *this;
}

OptionSyntax OptionSyntax::group(const std::string& name) const {
  option_->group(name);
  return *this;
}

OptionSyntax OptionSyntax::takeLast() const {
  option_->take_last();
  return *this;
}

OptionSyntax OptionSyntax::repeatable() const {
  option_->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return *this;
}

CommandSyntax::CommandSyntax(CLI::App& program, const std::string& name, const std::string& help)
    : app_(program.add_subcommand(name, help)) {}

template <class T>
OptionSyntax CommandSyntax::option(const std::string& names, T& value, const std::string& help) {
  return OptionSyntax(app_->add_option(names, value, help));
}

template OptionSyntax CommandSyntax::option(const std::string&, std::string&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, std::vector<std::string>&,
                                            const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, double&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, int&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, std::uint32_t&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, std::uint64_t&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, std::optional<std::string>&,
                                            const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, std::optional<std::int64_t>&,
                                            const std::string&);

OptionSyntax CommandSyntax::callback(const std::string& names,
                                     const std::function<void(const std::string&)>& take,
                                     const std::string& help) {
  return OptionSyntax(app_->add_option_function<std::string>(names, take, help));
}

OptionSyntax CommandSyntax::flag(const std::string& names, bool& value, const std::string& help) {
  return OptionSyntax(app_->add_flag(names, value, help));
}

}  // namespace twintrace
