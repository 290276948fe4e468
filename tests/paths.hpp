// Where the tree and the programs under test are. Not a macro: objects are then the same wherever the tree stands.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rmpl::paths {

std::string source();    ///< the root of the tree
std::string programs();  ///< the folder of rmplc, rmpl-run and tcca-check

}  // namespace rmpl::paths
