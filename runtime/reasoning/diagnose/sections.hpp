// Sections of a circuit: gates that can be seen only through one other gate.
//
// A gate g is dominated by d when every path from g to an observed net passes d. A faulty g can then do nothing that a
// faulty d could not do, so the diagnoses of minimum cardinality are first found among the undominated gates (the
// top-level diagnoses of Siddiqi and Huang 2007), and then expanded into their sections.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/reasoning/diagnose/circuit.hpp"

namespace rmpl::runtime {

struct Sections {
  /// Per gate: the undominated gate of its section (itself, where it is one); nothing where no path leads to an
  /// observed net.
  std::vector<std::optional<std::size_t>> top;
  /// Per undominated gate: its section in topological order, itself last; empty for the others.
  std::vector<std::vector<std::size_t>> members;
};

/// Immediate dominators towards the observed nets, in one backward pass (Cooper, Harvey and Kennedy on a DAG).
Sections sections_of(const Circuit& circuit, const std::vector<bool>& observed);

}  // namespace rmpl::runtime
