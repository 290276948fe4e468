// Asking git, and writing rules.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/dependencies.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "tools/shared/child_process.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;

/// What git prints.
std::string git(const std::string& folder, const std::vector<std::string>& words) {
  std::vector<std::string> arguments = {"git", "-C", folder.empty() ? "." : folder};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const std::optional<ChildEnd> end = run_child({arguments});
  if (!end) throw base::InputError("--changed-since: git is not installed");
  if (end->status != 0) throw base::InputError("--changed-since: " + end->errors);
  return end->output;
}

/// A name as make reads it.
std::string escaped(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (c == ' ' || c == '#') result += '\\';
    if (c == '$') result += '$';
    result += c;
  }
  return result;
}

}  // namespace

std::string dependency_rule(const std::string& target, const std::vector<std::string>& files) {
  std::string rule = escaped(target) + ":";
  for (const std::string& file : files) rule += " \\\n  " + escaped(file);
  return rule + "\n";
}

std::string changed_name(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::weakly_canonical(path, error);
  return error ? path : absolute.string();
}

std::set<std::string> changed_since(const std::string& revision, const std::string& folder) {
  std::string root = git(folder, {"rev-parse", "--show-toplevel"});
  while (root.ends_with('\n')) root.pop_back();
  // As a revision and nothing else, whatever it begins with.
  std::string commit = git(folder, {"rev-parse", "--verify", "--end-of-options", revision + "^{commit}"});
  while (commit.ends_with('\n')) commit.pop_back();
  const std::string names = git(root, {"diff", "--name-only", "-z", commit, "--"}) +
                            git(root, {"ls-files", "--others", "--exclude-standard", "-z"});
  std::set<std::string> changed;
  for (std::size_t at = 0; at < names.size();) {
    const std::size_t end = names.find('\0', at);
    changed.insert(changed_name(root + "/" + names.substr(at, end - at)));
    at = end == std::string::npos ? names.size() : end + 1;
  }
  return changed;
}

}  // namespace rmpl::tools
