// RMPL as a tree of our own, its text, and its THCA straight from the table of semantics 2: the compiler's twin.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/program.hpp"

namespace rmpl::reference {

struct Statement {
  enum class Kind {
    goal,         ///< `goal`
    clock_start,  ///< `clock` = 0
    sequence,     ///< parts, one after the other
    parallel,     ///< parts, at least two, side by side
    if_then,      ///< if constraint thennext parts[0]
    if_else,      ///< … elsenext parts[1]
    unless,
    when,
    whenever,
    always,
    repeat,
    next,
    nothing,      ///< { }
    each,         ///< parts, each with goals of its own
    watching,     ///< do parts[0] watching constraint
    maintaining,  ///< parts[0] maintaining constraint
    call          ///< of definitions[callee]
  };
  Kind kind = Kind::goal;
  std::vector<Statement> parts = {};
  automata::Formula constraint = {};
  std::vector<automata::Assignment> goal = {};
  automata::ClockId clock = {};
  std::size_t callee = 0;
};

/// Definitions over the variables of a table; the first is the program, and none calls itself or an earlier one. The
/// clock behind the last of `clocks` is the definition's own, where it has one.
struct Rmpl {
  std::vector<Statement> definitions;
  std::vector<std::string> clocks;
  std::vector<bool> has_own;  ///< per definition
};

/// The name of a definition's own clock in the text.
inline constexpr const char* own_clock = "own";

/// The name of a definition in the text.
std::string name_of_definition(std::size_t position);

/// In the surface syntax; definitions that the first does not lead to are left out.
std::string to_text(const Rmpl& source, const automata::Variables& variables);

/// The THCA; without labels and origins, arcs in no particular order.
automata::Program lower(const Rmpl& source, const automata::Variables& variables);

}  // namespace rmpl::reference
