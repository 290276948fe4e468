// Fuzzes the reader of ISCAS netlists: it refuses with a message, or writes a plant.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "automata/error.hpp"
#include "compiler/import/netlist.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const compiler::Netlist netlist = compiler::read_bench(input, "circuit");
    if (compiler::to_tcca(netlist, compiler::FaultModel::strong).empty()) std::abort();
  } catch (const automata::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
