// From one top-level diagnosis to all diagnoses with the same sections.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/reasoning/diagnose/circuit.hpp"
#include "runtime/reasoning/diagnose/sections.hpp"
#include "runtime/reasoning/diagnose/simulate.hpp"

namespace rmpl::runtime {

/// Expands the undominated gates of a top-level diagnosis of minimum cardinality into their sections.
///
/// Such a gate gives the opposite of what its inputs ask for: if it gave that, it would not be needed. So the faulty
/// gates determine the value of every net. Another gate of a section explains as much if it, flipped, brings the
/// section's output to the value that it has, and which one it is does not matter to other sections: the diagnoses are
/// the product of the sections' choices.
class Expansion {
 public:
  /// `nominal`: the value of every net where no gate is faulty. `cone`: all gates that depend on a gate to be expanded,
  /// ascending. What is passed by reference must outlive this object.
  Expansion(const Circuit& circuit, const Sections& sections, const Known& known, const std::vector<Word>& nominal,
            std::vector<std::size_t> cone);

  /// Per gate of `tops` (ascending), the gates of its section that may be faulty in its place, itself the last. Throws
  /// std::logic_error where the gates are no diagnosis of minimum cardinality.
  const std::vector<std::vector<std::size_t>>& choices(std::span<const std::size_t> tops);

 private:
  void simulate(std::span<const std::size_t> tops);
  void choose(std::size_t top, std::vector<std::size_t>& chosen);

  const Circuit& circuit_;
  const Sections& sections_;
  const Known& known_;
  std::vector<std::size_t> cone_;
  std::vector<Word> words_;  ///< per net
  std::vector<Word> saved_;  ///< of a section, while it is simulated again
  std::vector<std::vector<std::size_t>> choices_;
  GateEvaluator evaluate_;
};

}  // namespace rmpl::runtime
