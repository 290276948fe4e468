// What depends on which files: for make and ninja, and by what git says has changed.
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

namespace rmpl::tools {

/// A rule of make, which ninja reads, too: `target: files`. Blanks, `#` and `$` in names are escaped.
std::string dependency_rule(const std::string& target, const std::vector<std::string>& files);

/// The files in the repository of a folder that differ from a revision, those that git does not know yet among them, by
/// absolute paths without links. Throws base::InputError where git is not there, or says that there is no such
/// revision.
std::set<std::string> changed_since(const std::string& revision, const std::string& folder);

/// A path as `changed_since` has it.
std::string changed_name(const std::string& path);

}  // namespace rmpl::tools
