// A whole Markov decision process, and what of it graphs alone decide.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "verifier/markov/process.hpp"

namespace rmpl::verifier {

/// Who chooses.
enum class Aim { least, greatest };

/// All states, by number. Those that are wanted have no rows: a run is over there, as it is where nothing can follow.
struct DecisionProcess {
  std::vector<std::vector<Row>> rows;
  std::vector<bool> wanted;
  std::vector<Process::Start> start;

  [[nodiscard]] std::size_t size() const { return rows.size(); }
  /// Whether no state has a choice.
  [[nodiscard]] bool is_chain() const;
  /// What is so at the start, for values by state.
  [[nodiscard]] Enclosure at_start(const std::vector<Enclosure>& values) const;
};

/// Meets all states of a process that keeps no clocks apart, or those that so many steps lead to; what the last of
/// these steps leads to has no rows. Throws LimitReached.
DecisionProcess explore(Process& process, std::optional<Units> steps, Meter& meter);

/// States from which a wanted one may be reached: from all others it is not, whatever is chosen. What is left out may
/// lead anywhere.
std::vector<bool> may_reach(const DecisionProcess& decisions);
/// States in which choices exist that never reach one.
std::vector<bool> may_avoid(const DecisionProcess& decisions);
/// States from which a wanted one is reached with probability 1, whatever is chosen, or (greatest) by some choices
/// (C. Baier, J.-P. Katoen: Principles of Model Checking, 10.6.1).
std::vector<bool> surely_reach(const DecisionProcess& decisions, Aim aim);

/// Sets of states in which some choices stay for ever, as large as they can be, without wanted ones (L. de Alfaro:
/// Formal Verification of Probabilistic Systems, 1997, 3.3). By state: the number of its set, or 0.
std::vector<std::uint32_t> end_components(const DecisionProcess& decisions, Meter& meter);

}  // namespace rmpl::verifier
