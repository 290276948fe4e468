// Subcommands and options by CLI11, the one place that hands them on.
// SPDX-License-Identifier: MIT
#include "tools/shared/command.hpp"

#include <CLI/CLI.hpp>

namespace rmpl::tools {
namespace {

/// The parser's word for what an option cannot take.
template <class Given>
std::function<void(const Given&)> refusing(const std::string& name, const std::function<void(const Given&)>& take) {
  return [take, name](const Given& given) {
    try {
      take(given);
    } catch (const BadValue& error) {
      throw CLI::ValidationError(name, error.what());
    }
  };
}

}  // namespace

Option Option::required() {
  option_->required();
  return *this;
}

Option Option::option_text(const std::string& text) {
  option_->option_text(text);
  return *this;
}

Option Option::description(const std::string& text) {
  option_->description(text);
  return *this;
}

Option Option::excludes(Option other) {
  option_->excludes(other.option_);
  return *this;
}

Option Option::needs(Option other) {
  option_->needs(other.option_);
  return *this;
}

Option Option::repeatable() {
  option_->expected(1)->take_all()->allow_extra_args(false);
  return *this;
}

bool Option::given() const { return option_->count() > 0; }

std::string Option::name() const { return option_->get_name(); }

bool Option::is_called(const std::string& name) const { return option_->check_name(name); }

bool Option::is_positional() const { return option_->get_positional(); }

Option Command::add_option(const std::string& name, std::string& value, const std::string& description) {
  return Option(app_->add_option(name, value, description));
}

Option Command::add_option(const std::string& name, std::vector<std::string>& values, const std::string& description) {
  return Option(app_->add_option(name, values, description));
}

Option Command::add_flag(const std::string& name, bool& value, const std::string& description) {
  return Option(app_->add_flag(name, value, description));
}

Option Command::add_flag(const std::string& name, const std::string& description) {
  return Option(app_->add_flag(name, description));
}

Option Command::add_negation(const std::string& name, bool& value, const std::string& description) {
  return Option(app_->add_flag_callback(
      name, [&value] { value = false; }, description));
}

Option Command::add_taken(const std::string& name, const std::function<void(const std::string&)>& take,
                          const std::string& description) {
  return Option(app_->add_option_function<std::string>(name, refusing<std::string>(name, take), description));
}

Option Command::add_all_taken(const std::string& name, const std::function<void(const std::vector<std::string>&)>& take,
                              const std::string& description) {
  using Texts = std::vector<std::string>;
  return Option(app_->add_option_function<Texts>(name, refusing<Texts>(name, take), description));
}

void Command::require_one(Option one, Option other) {
  one.excludes(other);
  app_->parse_complete_callback([one, other] {
    if (!one.given() && !other.given()) throw CLI::ValidationError("expected " + one.name() + " or " + other.name());
  });
}

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::prepend_footer(const std::string& text) { app_->footer(text + "\n\n" + app_->get_footer()); }

Option Command::option(const std::string& name) const { return Option(app_->get_option(name)); }

std::vector<Option> Command::options() const {
  std::vector<Option> result;
  for (CLI::Option* option : app_->get_options()) result.emplace_back(option);
  return result;
}

}  // namespace rmpl::tools
