// What the folders of the workspace hold, open or not: all that uses a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "tools/rmplc/server/workspace.hpp"

namespace rmpl::tools {

/// Every unit that reads the file of this identity: those of the open documents, and of the other files below the roots
/// of the workspace
/// - the scenarios that lead to the file, and the files of its own language that import it;
/// - the programs and properties that name no plant, with each plant that leads to the file and that they fit, in which
///   all their names are known; where one such plant lies beside them, with that alone.
/// Compiles what no open document is part of: seconds, for many files. At most 2,000 files are looked at, in order of
/// their paths.
std::vector<std::shared_ptr<Analysis>> analyses_with(Workspace& workspace, const std::string& identity);

/// Sources below the folders, at most 2,000, in order of their paths.
std::set<std::string> sources_below(const std::vector<std::string>& roots);

}  // namespace rmpl::tools
