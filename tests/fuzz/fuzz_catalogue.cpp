// Fuzzes the reader of system catalogues.
// SPDX-License-Identifier: MIT
#include "tests/fuzz/netlist_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rmpl::read_as_netlist(rmpl::compiler::read_catalogue, data, size);
  return 0;
}
