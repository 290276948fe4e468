// Gates that are not supported, by what they lack.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>

#include "compiler/check/vocabulary.hpp"
#include "compiler/import/netlist.hpp"

namespace rmpl::compiler {
namespace {

struct GateKind {
  std::string_view begins;  ///< in capitals; digits and parameters may follow
  std::string_view reason;
};

constexpr std::string_view memory =
    " keeps its value from one clock to the next, and a circuit is imported without memory: cut it, with its output as "
    "an INPUT and its input as an OUTPUT";
constexpr std::string_view table =
    " is a look-up table, and tables are not supported: have the circuit written with AND, OR, NOT and their like";
constexpr std::string_view selection =
    " is a multiplexer, which is not supported: write it with AND, OR and NOT; o = OR(AND(s, a), AND(NOT(s), b))";
constexpr std::string_view constant =
    " is a constant, which is not supported: make it an INPUT, which is then observed";
constexpr std::string_view high_impedance =
    " can leave its output undriven, which is not supported: a net is true or false";

constexpr std::array<GateKind, 19> kinds{{{"DFF", memory},
                                          {"SDFF", memory},
                                          {"TFF", memory},
                                          {"JKFF", memory},
                                          {"FF", memory},
                                          {"DLATCH", memory},
                                          {"LATCH", memory},
                                          {"FLOP", memory},
                                          {"FLIPFLOP", memory},
                                          {"REG", memory},
                                          {"LUT", table},
                                          {"MUX", selection},
                                          {"VDD", constant},
                                          {"GND", constant},
                                          {"VCC", constant},
                                          {"VSS", constant},
                                          {"CONST", constant},
                                          {"TIE", constant},
                                          {"TRI", high_impedance}}};

}  // namespace

std::optional<std::string> why_unsupported(std::string_view gate) {
  std::string word;
  for (const char c : gate.substr(0, gate.find_first_of(" \t"))) {
    word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  if (word == "0" || word == "1") return backquoted(gate) + std::string(constant);
  for (const GateKind& kind : kinds) {
    if (!word.starts_with(kind.begins)) continue;
    const std::string_view rest = std::string_view(word).substr(kind.begins.size());
    const bool parameters = rest.find_first_not_of("0123456789_RSENXP") == std::string_view::npos;
    if (parameters) return backquoted(gate) + std::string(kind.reason);
  }
  return std::nullopt;
}

}  // namespace rmpl::compiler
