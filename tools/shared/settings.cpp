// Reading rmpl.ini by Boost.Program_options, and saying what is wrong with it.
// SPDX-License-Identifier: MIT
#include "tools/shared/settings.hpp"

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
#include "tools/shared/command.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;

/// Reads keys and values; `path` is for messages.
class Reader {
 public:
  Reader(const std::string& path, const std::string& text, LintLevels levels)
      : text_(text), levels_(std::move(levels)) {
    settings_.path = path;
  }

  Settings run() {
    std::set<std::string> seen;
    for (const auto& [key, value] : entries()) {
      if (!seen.insert(key).second) fail(key, "'" + key + "' is given twice");
      take(key, value);
    }
    settings_.lint = levels_.settings();
    settings_.level = levels_.level();
    return std::move(settings_);
  }

 private:
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
    bool known = false;
    try {
      known = levels_.take(name, value);
    } catch (const BadValue& bad) {
      fail(key, "'" + key + "' " + bad.what());
    }
    if (!known) unknown(key);
  }

  [[noreturn]] void unknown(const std::string& key) const {
    std::vector<std::string> names = {"color", "quiet", "verbose", "max-input"};
    for (const std::string& name : LintLevels::keys()) names.push_back("lint." + name);
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
  LintLevels levels_;
};

/// The nearest file of a name in a folder and those above it, by an absolute path.
std::optional<fs::path> nearest_file(fs::path folder, const char* name) {
  std::error_code error;
  while (true) {
    if (fs::is_regular_file(folder / name, error)) return folder / name;
    if (!folder.has_relative_path()) return std::nullopt;
    folder = folder.parent_path();
  }
}

/// The folder where a search for settings begins, by an absolute path; nothing where there is none.
std::optional<fs::path> first_folder(const std::string& first_file) {
  std::error_code error;
  fs::path start;
  if (!first_file.empty() && first_file != "-") {
    start = fs::is_directory(first_file, error) ? fs::path(first_file) : fs::path(first_file).parent_path();
  }
  fs::path folder = fs::weakly_canonical(fs::current_path(error) / start, error);
  if (error) return std::nullopt;
  return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace

Settings read_settings(const std::string& path, const std::string& text, const LintLevels& below) {
  return Reader(path, text, below).run();
}

std::optional<std::string> find_manifest(const std::string& first_file) {
  const auto folder = first_folder(first_file);
  const auto found = folder ? nearest_file(*folder, manifest_name) : std::nullopt;
  if (!found) return std::nullopt;
  std::error_code error;
  const fs::path named = fs::proximate(*found, error);
  return error ? found->string() : named.string();
}

Settings find_settings(const std::string& first_file) {
  std::optional<Manifest> manifest;
  if (const auto path = find_manifest(first_file)) manifest = read_manifest(*path, base::read_file(*path));
  const LintLevels below = manifest ? manifest->lint : LintLevels();
  const auto folder = first_folder(first_file);
  const auto found = folder ? nearest_file(*folder, "rmpl.ini") : std::nullopt;
  Settings settings = found ? read_settings(found->string(), base::read_file(found->string()), below)
                            : Settings{.lint = below.settings(), .level = below.level()};
  settings.manifest = std::move(manifest);
  return settings;
}

}  // namespace rmpl::tools
