// Fuzzes the reader of Open-PSA fault trees.
// SPDX-License-Identifier: MIT
#include "tests/fuzz/tree_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rmpl::read_as_tree(rmpl::compiler::read_open_psa, data, size);
  return 0;
}
