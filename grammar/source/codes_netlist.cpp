// Codes of the registry: netlists that are imported.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array netlist_table = {
    CodeInfo{Code::netlist_syntax, "neither netlist nor fault tree",
             "The text has no gates, or it is in none of the supported formats:\n\n- `.bench` netlists: INPUT(n), "
             "OUTPUT(n), n = GATE(a, b), one statement a line,\n- system catalogues of the diagnostic competition,\n- "
             "fault trees in the format of Galileo or Open-PSA.",
             R"(// inverter.bench
INPUT(a)
OUTPUT b
b = NOT(a))",
             R"(// inverter.bench
INPUT(a)
OUTPUT(b)
b = NOT(a))"},
    CodeInfo{Code::netlist_gate, "unsupported gate",
             "The gates of a circuit are AND, NAND, OR, NOR, XOR and XNOR with two or more inputs, and NOT and BUFF "
             "with one. Look-up tables, multiplexers and constants are not supported. A circuit is imported without "
             "memory. Cut each flip-flop and latch: make its output an input of the circuit, and its input an "
             "output.\n\nThe gates of a fault tree are and, or, not, xor and k of n, and in Galileo also pand, por, "
             "spares, fdep and seq. Spares, the dependents of an fdep and the nodes that a seq holds back must be "
             "basic events. The importer rejects what a plant cannot express, and never leaves it out.",
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
    CodeInfo{
        Code::netlist_driver, "not defined exactly once",
        "A net may have only one driver: an input of the circuit or a gate. A net that is read needs a driver. In the "
        "same way, a node of a fault tree may be defined only once, and a node that is read needs a definition.",
        R"(// gate.bench
INPUT(a)
OUTPUT(c)
c = AND(a, b))",
        R"(// gate.bench
INPUT(a)
INPUT(b)
OUTPUT(c)
c = AND(a, b))"},
    CodeInfo{Code::netlist_loop, "loop of gates",
             "A gate reads its own output, directly or through other gates. Such a circuit stores a value or "
             "oscillates. As a plant it would permit several values, or none. Cut the loop at the net that stores the "
             "value: make the net an output of the circuit, and let its readers read a new input.",
             R"(// latch.bench
INPUT(set)
INPUT(reset)
OUTPUT(q)
q = NOR(reset, p)
p = NOR(set, q))",
             R"(// latch.bench
INPUT(set)
INPUT(reset)
INPUT(q_before)
OUTPUT(q)
q = NOR(reset, p)
p = NOR(set, q_before))"},
};

}  // namespace

std::span<const CodeInfo> netlist_codes() { return netlist_table; }

}  // namespace rmpl::grammar
