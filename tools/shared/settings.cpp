// Reading rmpl.ini by Boost.Program_options, and saying what is wrong with it.
// SPDX-License-Identifier: MIT
#include "tools/shared/settings.hpp"

#include <array>
#include <boost/program_options/errors.hpp>
#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;
using compiler::LintGroup;
using grammar::Severity;

constexpr std::array groups = {LintGroup::impossible,    LintGroup::suspicious, LintGroup::unused,
                               LintGroup::observability, LintGroup::timing,     LintGroup::style,
                               LintGroup::allowance};

/// Reads keys and values; `path` is for messages.
class Reader {
 public:
  Reader(const std::string& path, const std::string& text) : text_(text) { settings_.path = path; }

  Settings run() {
    std::set<std::string> seen;
    for (const auto& [key, value] : entries()) {
      if (!seen.insert(key).second) fail(key, "'" + key + "' is given twice");
      take(key, value);
    }
    // A code has the last word over its group.
    for (const auto& [group, level] : by_group_) {
      for (const compiler::LintCode& code : compiler::lint_codes()) {
        if (code.group == group) settings_.lint.levels.emplace(code.code, level);
      }
    }
    return std::move(settings_);
  }

 private:
  using Level = std::optional<Severity>;

  std::vector<std::pair<std::string, std::string>> entries() const {
    namespace options = boost::program_options;
    std::istringstream stream(text_);
    std::vector<std::pair<std::string, std::string>> found;
    try {
      const options::options_description none;
      const auto parsed = options::parse_config_file(stream, none, true);
      for (const auto& option : parsed.options) {
        found.emplace_back(option.string_key, option.value.empty() ? "" : option.value.front());
      }
    } catch (const options::invalid_config_file_syntax& error) {
      // Not what(): it fills in the line again and again where the line has the name of its own placeholder.
      throw base::InputError(settings_.path + ": expected lines 'key = value' and '[section]', found '" +
                             error.tokens() + "'");
    }
    return found;
  }

  void take(const std::string& key, const std::string& value) {
    constexpr std::string_view section = "lint.";
    static const std::set<std::string> options = {"color", "quiet", "verbose", "max-input"};
    if (options.count(key) > 0) {
      settings_.options.emplace(key, value);
    } else if (key.starts_with(section)) {
      take_lint(key, key.substr(section.size()), value);
    } else {
      unknown(key);
    }
  }

  void take_lint(const std::string& key, const std::string& name, const std::string& value) {
    if (name == "level") {
      settings_.level = level(key, value);
      if (!settings_.level) fail(key, "'" + key + "' is note, warning or error");
      return;
    }
    if (name == "cycle") return take_cycle(key, value);
    for (const LintGroup group : groups) {
      if (name == compiler::to_string(group)) {
        by_group_[group] = level(key, value);
        return;
      }
    }
    const auto code = name.starts_with("RMPL") ? grammar::find_code(name) : std::nullopt;
    if (!code || compiler::find_lint_code(*code) == nullptr) unknown(key);
    settings_.lint.levels[*code] = level(key, value);
  }

  void take_cycle(const std::string& key, const std::string& value) {
    const auto cycle = automata::parse_duration(value);
    if (!cycle || cycle->is_infinite() || *cycle <= automata::Ticks{0}) {
      fail(key, "'" + value + "' is no length of time; expected a finite duration above 0, as in 0.5 s");
    }
    settings_.lint.cycle = *cycle;
  }

  Level level(const std::string& key, const std::string& value) const {
    if (value == "off") return std::nullopt;
    for (const Severity severity : {Severity::note, Severity::warning, Severity::error}) {
      if (value == grammar::to_string(severity)) return severity;
    }
    fail(key, "'" + key + "' is off, note, warning or error, not '" + value + "'");
  }

  [[noreturn]] void unknown(const std::string& key) const {
    std::vector<std::string> names = {"color", "quiet", "verbose", "max-input", "lint.level", "lint.cycle"};
    for (const LintGroup group : groups) names.push_back(std::string("lint.") + compiler::to_string(group));
    for (const compiler::LintCode& code : compiler::lint_codes()) names.push_back("lint." + to_string(code.code));
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    fail(key, "unknown key '" + key + "'" + suggestion_or_list(key, candidates));
  }

  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    throw base::InputError(settings_.path + ":" + std::to_string(line_of(key)) + ": " + what);
  }

  /// The last line that gives a key, for messages.
  std::size_t line_of(const std::string& key) const {
    std::istringstream stream(text_);
    std::string section;
    std::size_t found = 1;
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      const std::size_t first = line.find_first_not_of(" \t");
      if (first == std::string::npos) continue;
      if (line[first] == '[') {
        section = line.substr(first + 1, line.find(']', first) - first - 1) + ".";
        continue;
      }
      const std::size_t end = line.find_first_of(" \t=", first);
      if (section + line.substr(first, end - first) == key) found = number;
    }
    return found;
  }

  const std::string& text_;
  Settings settings_;
  std::map<LintGroup, Level> by_group_;
};

}  // namespace

Settings read_settings(const std::string& path, const std::string& text) { return Reader(path, text).run(); }

Settings find_settings(const std::string& first_file) {
  std::error_code error;
  const fs::path start = first_file.empty() || first_file == "-" ? fs::path() : fs::path(first_file).parent_path();
  fs::path folder = fs::weakly_canonical(fs::current_path(error) / start, error);
  if (error) return {};
  while (true) {
    const fs::path candidate = folder / "rmpl.ini";
    if (fs::is_regular_file(candidate, error))
      return read_settings(candidate.string(), base::read_file(candidate.string()));
    if (!folder.has_relative_path()) return {};
    folder = folder.parent_path();
  }
}

}  // namespace rmpl::tools
