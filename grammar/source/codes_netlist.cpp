// Codes of the registry: netlists that are imported.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{Code::netlist_syntax, "not a netlist",
             "The text is no `.bench` netlist (INPUT(n), OUTPUT(n), n = GATE(a, b), a statement a line), or no system "
             "catalogue of the diagnostic competition, or it has no gates.",
             R"(// inverter.bench
INPUT(a)
OUTPUT b
b = NOT(a))",
             R"(// inverter.bench
INPUT(a)
OUTPUT(b)
b = NOT(a))"},
    CodeInfo{Code::netlist_gate, "gate that there is not",
             "Gates are AND, NAND, OR, NOR, XOR and XNOR of two inputs or more, and NOT and BUFF of one.",
             R"(// gate.bench
INPUT(a)
INPUT(b)
OUTPUT(c)
c = NOT(a, b))",
             R"(// gate.bench
INPUT(a)
INPUT(b)
OUTPUT(c)
c = NAND(a, b))"},
    CodeInfo{Code::netlist_driver, "net without one driver",
             "Each net is driven once, by an input of the circuit or by a gate; one that is read has a driver.",
             R"(// gate.bench
INPUT(a)
OUTPUT(c)
c = AND(a, b))",
             R"(// gate.bench
INPUT(a)
INPUT(b)
OUTPUT(c)
c = AND(a, b))"},
};

}  // namespace

std::span<const CodeInfo> netlist_codes() { return table; }

}  // namespace rmpl::grammar
