// Codes of the registry: netlists that are imported.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array netlist_table = {
    CodeInfo{
        Code::netlist_syntax, "neither netlist nor fault tree",
        "The text is no `.bench` netlist (INPUT(n), OUTPUT(n), n = GATE(a, b), a statement a line), no system "
        "catalogue of the diagnostic competition, and no fault tree in the format of Galileo or Open-PSA; or it has "
        "no gates.",
        R"(// inverter.bench
INPUT(a)
OUTPUT b
b = NOT(a))",
        R"(// inverter.bench
INPUT(a)
OUTPUT(b)
b = NOT(a))"},
    CodeInfo{
        Code::netlist_gate, "gate that there is not",
        "Gates are AND, NAND, OR, NOR, XOR and XNOR of two inputs or more, and NOT and BUFF of one. A circuit is "
        "imported without memory: flip-flops and latches are cut, their outputs made inputs of the circuit and their "
        "inputs outputs. Look-up tables, multiplexers and constants are not supported. Fault trees have and, or, not, "
        "xor, "
        "k of n, and of Galileo pand, por, spares, fdep and seq: spares, what depends on a trigger and what is held "
        "back "
        "are basic events. What cannot be said as a plant is refused, never left out.",
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
        Code::netlist_driver, "no one definition",
        "Each net is driven once, by an input of the circuit or by a gate; one that is read has a driver. So it is for "
        "the nodes of a fault tree: each that is read is defined, and none twice.",
        R"(// gate.bench
INPUT(a)
OUTPUT(c)
c = AND(a, b))",
        R"(// gate.bench
INPUT(a)
INPUT(b)
OUTPUT(c)
c = AND(a, b))"},
    CodeInfo{
        Code::netlist_loop, "loop of gates",
        "A gate reads its own output, by way of other gates or at once. Such a circuit holds a value or swings, "
        "which takes memory or time; a plant made of it would allow several values, or none. Cut the loop where the "
        "value is held: the net becomes an input of the circuit for whoever reads it, and an output.",
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
