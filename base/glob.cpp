// Patterns, folder by folder.
// SPDX-License-Identifier: MIT
#include "base/glob.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace rmpl::base {
namespace {

namespace fs = std::filesystem;

/// The first folder of a path, and what follows it.
struct Split {
  std::string first;
  std::string_view rest;
  bool last;  ///< it is the file
};

Split split(std::string_view path) {
  const std::size_t slash = path.find('/');
  if (slash == std::string_view::npos) return {std::string(path), {}, true};
  return {std::string(path.substr(0, slash)), path.substr(slash + 1), false};
}

bool part_matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), FNM_PERIOD) == 0;
}

void collect(const fs::path& folder, std::string_view pattern, std::vector<std::string>& found) {
  const Split part = split(pattern);
  if (part.first == "**" && !part.last) collect(folder, part.rest, found);
  if (part.first == "." || part.first == ".." || part.first.empty()) {
    if (!part.last) collect(folder / part.first, part.rest, found);
    return;
  }
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code unknown;
    if (part.first == "**" && !part.last) {
      const bool below = entry->is_directory(unknown) && !entry->is_symlink(unknown) && name.front() != '.';
      if (below) collect(entry->path(), pattern, found);
    } else if (part_matches(part.first, name)) {
      if (part.last && entry->is_regular_file(unknown)) found.push_back(entry->path().lexically_normal().string());
      if (!part.last && entry->is_directory(unknown)) collect(entry->path(), part.rest, found);
    }
  }
}

}  // namespace

bool name_matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::vector<std::string> files_matching(const std::string& folder, const std::string& pattern) {
  std::vector<std::string> found;
  collect(folder.empty() ? "." : folder, pattern, found);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace rmpl::base
