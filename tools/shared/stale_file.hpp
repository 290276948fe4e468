// Removes an output file of an earlier run when this run has nothing to write under its name.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rmpl::tools {

/// Removes it, so that nobody takes it for what this run found, and says so. Nothing where `path` is empty or nothing
/// is there. Throws base::InputError where it cannot be removed.
void remove_stale(const std::string& path);

}  // namespace rmpl::tools
