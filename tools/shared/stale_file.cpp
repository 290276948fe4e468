// Removes an output file of an earlier run, and says so.
// SPDX-License-Identifier: MIT
#include "tools/shared/stale_file.hpp"

#include "base/output_file.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

void remove_stale(const std::string& path) {
  if (path.empty() || !base::remove_stale_file(path)) return;
  tell(path + ": removed, because it was written by an earlier run");
}

}  // namespace rmpl::tools
