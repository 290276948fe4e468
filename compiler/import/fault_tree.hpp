// A fault tree as its file gives it: events, gates, and how parts stand in for each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compiler/import/netlist.hpp"

namespace rmpl::compiler {

/// A position in `FaultTree::nodes`.
using TreeNodeId = std::size_t;

/// An event or a gate. Gates have failed as their inputs say.
struct TreeNode {
  enum class Kind {
    basic,        ///< fails by itself
    house,        ///< has failed from the start, or never fails
    conjunction,  ///< all
    disjunction,  ///< one
    negation,     ///< not the one
    exclusive,    ///< an odd number
    vote,         ///< `at_least` of them
    pand,         ///< all, each no sooner than the one before it
    por,          ///< the first, before any other
    spare,        ///< all; each stands in for those before it
    fdep,         ///< no input of anything; the first one takes the others with it, with `probability`
    seq           ///< all; each can fail only after the one before it
  };
  std::string name;
  Kind kind = Kind::basic;
  std::vector<TreeNodeId> inputs;
  std::size_t at_least = 0;
  bool together = true;               ///< of `pand`, `por`: what fails at one moment is in order
  bool failed = false;                ///< of a house event
  std::optional<double> probability;  ///< of a basic event: of having failed from the start; of `fdep`: none is 1
  double rate = 0;                    ///< of a basic event without that: per second
  double dormancy = 1;                ///< the part of its rate while it stands by
  grammar::Span place = {};
};

struct FaultTree {
  std::string name;
  std::vector<TreeNode> nodes;
  std::optional<TreeNodeId> top;
};

/// Reads a fault tree in the Galileo format, as DFTCalc and Storm do. A unit of time is a second. Nothing where it has
/// errors; then they have been reported.
std::optional<FaultTree> read_galileo(const grammar::Sources& sources, std::uint32_t file,
                                      grammar::Diagnostics& diagnostics);

/// Reads a fault tree in the Open-PSA Model Exchange Format 2.0: formulas, house and basic events, parameters,
/// common-cause groups with beta factors. A rate counts in the unit that its mission time or its parameter states, else
/// as above.
std::optional<FaultTree> read_open_psa(const grammar::Sources& sources, std::uint32_t file,
                                       grammar::Diagnostics& diagnostics);

/// Reports inputs in number or kind that a gate cannot have, and loops. Whether there was none.
bool check_tree(const FaultTree& tree, NetlistErrors& errors);

/// The tree as a plant in the surface language: an instance for each basic event and each gate with a memory, an
/// attribute for each other gate. Throws base::InputError where a name cannot be said.
std::string to_tcca(const FaultTree& tree);

}  // namespace rmpl::compiler
