// Where the tree and the programs under test are, as the build knows it.
// SPDX-License-Identifier: MIT
#include "tests/paths.hpp"

namespace rmpl::paths {

std::string source() { return RMPL_SOURCE_DIR; }
std::string programs() { return RMPL_BIN_DIR; }

}  // namespace rmpl::paths
