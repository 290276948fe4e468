// Reading rmpl.toml by toml++, and saying all that is wrong with it.
// SPDX-License-Identifier: MIT
#include "tools/shared/manifest.hpp"

#include <toml++/toml.h>
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>

#include "base/error.hpp"
#include "base/glob.hpp"
#include "tools/shared/command.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;

ManifestText placed(std::string text, const toml::source_region& at) {
  return {std::move(text), at.begin.line, at.begin.column};
}

/// Where a string of TOML that begins at `at` ends; of one that does not, where its line or the text does.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool long_form = text.substr(at, 3) == three;
  for (std::size_t i = at + (long_form ? 3 : 1); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (long_form && text.substr(i, 3) == three) {
      i += 3;
      for (int more = 0; more < 2 && i < text.size() && text[i] == quote; ++more) ++i;
      return i;
    } else if (!long_form && (text[i] == quote || text[i] == '\n')) {
      return i + 1;
    }
  }
  return text.size();
}

/// Refuses keys of very many parts: each is a table in the one before, and the reader goes as deep into itself.
void check_depth(const std::string& path, std::string_view text) {
  constexpr unsigned most = 16;
  unsigned dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '"' || c == '\'') {
      at = end_of_string(text, at);
      continue;
    }
    if (std::string_view("=,{}[]\n").find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && ++dots > most) {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      throw base::InputError(path + ":" + std::to_string(line) + ": expected keys of at most " + std::to_string(most) +
                             " parts");
    }
    ++at;
  }
}

/// Walks over the tables; complaints are collected.
class ManifestReader {
 public:
  explicit ManifestReader(const std::string& path) { manifest_.path = path; }

  Manifest run(const toml::table& root) {
    each(root, "", {"project", "lint", "set", "rmplc", "rmpl-run", "tcca-check"},
         [&](const std::string& key, const toml::node& value, const ManifestText& at) {
           const toml::table* table = value.as_table();
           if (table == nullptr) return complain(at, "expected a table, as in [" + key + "]");
           if (key == "project") return project(*table);
           if (key == "lint") return lint(*table);
           if (key == "set") return sets(*table);
           program(key, *table);
         });
    // Sets stand in the order of the file, tables of TOML in that of their names.
    std::sort(manifest_.sets.begin(), manifest_.sets.end(),
              [](const ManifestSet& a, const ManifestSet& b) { return a.line < b.line; });
    if (complaints_.empty()) return std::move(manifest_);
    std::sort(complaints_.begin(), complaints_.end());
    std::string text;
    for (const Complaint& one : complaints_) text += (text.empty() ? "" : "\n") + one.text;
    throw base::InputError(text);
  }

 private:
  struct Complaint {
    std::uint32_t line, column;
    std::string text;
    auto operator<=>(const Complaint&) const = default;
  };

  void complain(const ManifestText& at, const std::string& what) {
    complaints_.push_back({at.line, at.column, manifest_.told(at, what)});
  }

  /// Every key of a table that is one of `known`, in the order of the names.
  template <class Take>
  void each(const toml::table& table, const std::string& where, const std::vector<std::string_view>& known,
            const Take& take) {
    for (const auto& [key, value] : table) {
      const std::string name(key.str());
      const ManifestText at = placed(name, key.source());
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        complain(at, "unknown key '" + name + "'" + (where.empty() ? "" : " in [" + where + "]") +
                         suggestion_or_list(name, known));
      } else {
        take(name, value, at);
      }
    }
  }

  std::optional<ManifestText> text(const std::string& key, const toml::node& value, const ManifestText& at) {
    if (const auto text = value.value_exact<std::string>()) return placed(*text, value.source());
    complain(at, "'" + key + "' is a text, as in " + key + " = \"…\"");
    return std::nullopt;
  }

  std::vector<ManifestText> texts(const std::string& key, const toml::node& value, const ManifestText& at) {
    std::vector<ManifestText> found;
    const toml::array* array = value.as_array();
    if (array == nullptr) {
      complain(at, "'" + key + "' is a list of names or patterns, as in " + key + " = [\"…\"]");
      return found;
    }
    for (const toml::node& one : *array) {
      if (auto name = text(key, one, placed("", one.source()))) found.push_back(std::move(*name));
    }
    return found;
  }

  void project(const toml::table& table) {
    each(table, "project", {"name", "requirements"},
         [&](const std::string& key, const toml::node& value, const ManifestText& at) {
           if (key == "requirements") return requirements(texts(key, value, at));
           if (const auto name = text(key, value, at)) manifest_.name = name->text;
         });
  }

  void requirements(std::vector<ManifestText> names) {
    std::set<std::string_view> known;
    for (const ManifestText& name : names) {
      if (name.text.find_first_not_of(" \t\r\n") == std::string::npos) complain(name, "the requirement has no name");
      if (!known.insert(name.text).second) complain(name, "requirement '" + name.text + "' stands twice");
    }
    manifest_.requirements = std::move(names);
  }

  void lint(const toml::table& table) {
    std::vector<std::string> keys = LintLevels::keys();
    keys.emplace_back("baseline");
    each(table, "lint", {keys.begin(), keys.end()},
         [&](const std::string& key, const toml::node& value, const ManifestText& at) {
           const auto level = text(key, value, at);
           if (!level) return;
           if (key == "baseline") {
             manifest_.baseline = level;
             return;
           }
           try {
             manifest_.lint.take(key, level->text);
           } catch (const BadValue& bad) {
             complain(*level, "'" + key + "' " + bad.what());
           }
         });
  }

  void sets(const toml::table& table) {
    for (const auto& [key, value] : table) {
      const std::string name(key.str());
      const ManifestText at = placed(name, key.source());
      if (const toml::table* set = value.as_table()) {
        add_set(name, at, *set);
      } else {
        complain(at, "expected a table, as in [set." + name + "]");
      }
    }
  }

  void add_set(const std::string& name, const ManifestText& at, const toml::table& table) {
    ManifestSet set;
    set.name = name;
    set.line = at.line;
    each(table, "set." + name, {"plant", "program", "main", "scenarios", "properties", "monitors"},
         [&](const std::string& key, const toml::node& value, const ManifestText& where) {
           if (key == "plant") set.plant = text(key, value, where);
           if (key == "program") set.program = text(key, value, where);
           if (key == "main") set.main = text(key, value, where);
           if (key == "scenarios") set.scenarios = texts(key, value, where);
           if (key == "properties") set.properties = texts(key, value, where);
           if (key == "monitors") set.monitors = texts(key, value, where);
         });
    if (table.empty()) complain(at, "set '" + name + "' names no file");
    if (set.main && !set.program) complain(*set.main, "'main' is a definition of the program, and there is none");
    if (!set.monitors.empty() && !set.plant) {
      complain(set.monitors.front(), "monitors speak of a plant: expected 'plant' in the set");
    }
    manifest_.sets.push_back(std::move(set));
  }

  void program(const std::string& name, const toml::table& table) {
    for (const auto& [key, value] : table) {
      const std::string command = name + '.' + std::string(key.str());
      const toml::table* options = value.as_table();
      if (options == nullptr) {
        complain(placed("", key.source()), "expected a table, as in [" + command + "]");
        continue;
      }
      for (const auto& [option, given] : *options) {
        const ManifestText at = placed(std::string(option.str()), option.source());
        if (given.is_table() || given.is_array() || given.is_date() || given.is_time() || given.is_date_time()) {
          complain(at, "'" + at.text + "' is a text, a number, true or false");
          continue;
        }
        std::ostringstream written;
        if (const auto text = given.value_exact<std::string>()) {
          written << *text;
        } else {
          given.visit([&](const auto& one) { written << one; });
        }
        manifest_.options[command][at.text] = placed(written.str(), option.source());
      }
    }
  }

  Manifest manifest_;
  std::vector<Complaint> complaints_;
};

/// A name as seen from where the program runs.
std::string seen(const Manifest& manifest, const std::string& name) {
  return (fs::path(manifest.path).parent_path() / name).lexically_normal().string();
}

std::string only_file(const Manifest& manifest, const std::optional<ManifestText>& name) {
  if (!name) return {};
  std::string path = seen(manifest, name->text);
  std::error_code error;
  if (!fs::is_regular_file(path, error)) manifest.fail(*name, "there is no file " + path);
  return path;
}

std::vector<std::string> all_files(const Manifest& manifest, const std::vector<ManifestText>& names) {
  std::vector<std::string> found;
  for (const ManifestText& name : names) {
    if (name.text.find_first_of("*?[") == std::string::npos) {
      found.push_back(only_file(manifest, name));
      continue;
    }
    const std::vector<std::string> matching = base::files_matching(seen(manifest, "."), name.text);
    if (matching.empty()) manifest.fail(name, "'" + name.text + "' matches no file");
    found.insert(found.end(), matching.begin(), matching.end());
  }
  std::vector<std::string> once;
  for (std::string& path : found) {
    if (std::find(once.begin(), once.end(), path) == once.end()) once.push_back(std::move(path));
  }
  return once;
}

}  // namespace

void Manifest::fail(const ManifestText& at, const std::string& what) const { throw base::InputError(told(at, what)); }

std::string Manifest::told(const ManifestText& at, const std::string& what) const {
  return path + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + what;
}

Manifest read_manifest(const std::string& path, const std::string& text) {
  check_depth(path, text);
  toml::table root;
  try {
    root = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    std::string what(error.description());
    if (!what.empty() && what.front() == 'E') what.front() = 'e';
    Manifest named;
    named.path = path;
    named.fail({"", at.line, at.column}, what);
  }
  return ManifestReader(path).run(root);
}

std::string baseline_of(const Manifest& manifest) { return only_file(manifest, manifest.baseline); }

SetFiles files_of(const Manifest& manifest, const ManifestSet& set) {
  return {.plant = only_file(manifest, set.plant),
          .program = only_file(manifest, set.program),
          .main = set.main ? set.main->text : std::string(),
          .scenarios = all_files(manifest, set.scenarios),
          .properties = all_files(manifest, set.properties),
          .monitors = all_files(manifest, set.monitors)};
}

}  // namespace rmpl::tools
