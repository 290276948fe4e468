// Patterns for names, in the manner of the shell.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace rmpl::base {

/// Whether a whole name matches: `*` is any text, `?` any character, `[a-z]` one of some; `\` takes the special meaning
/// from the next.
bool name_matches(const std::string& pattern, const std::string& name);

/// The regular files in and below a folder whose paths from there match, sorted. Each has the folder before it, unless
/// that is `.`, the working folder. `*` and the others stay within the name of one folder or file; a folder `**` stands
/// for any number of folders, none too. Only a dot in the pattern matches a dot that begins a name; `**` follows no
/// link. What cannot be read has no files.
std::vector<std::string> files_matching(const std::string& folder, const std::string& pattern);

}  // namespace rmpl::base
