// What the observations of one moment say of faults: the constraint store behind a diagnosis.
//
// A component has a status: nominal, or one of its fault modes. Which nominal mode it is in is left to the store, so
// that assignments that differ in nominal modes alone are one, and conflicts speak of statuses.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {

/// The statuses of a component: status 0 is nominal, status i + 1 its i-th fault mode.
struct Statuses {
  automata::VariableId variable;          ///< the mode itself where there is one nominal mode
  std::vector<automata::ValueId> values;  ///< of that variable, per status
  std::vector<automata::ModeId> faults;
  std::vector<automata::ModeId> nominals;
  std::vector<double> priors;  ///< per status, as `Diagnosis::probability` says; they sum to 1

  [[nodiscard]] automata::Assignment is(std::size_t status) const { return {variable, values[status]}; }
};

/// The statuses of a component but for their variable and values: its fault modes, with the priors of
/// `Diagnosis::probability`.
Statuses statuses_of(const automata::Component& component);

/// The plant with a status for each component, under one observation. `counted` is for `at_most`: how many
/// faults can be told apart; each costs a variable a component.
class Snapshot {
 public:
  Snapshot(const automata::Plant& plant, const automata::Observation& observation, std::size_t counted = 0);

  [[nodiscard]] const std::vector<Statuses>& statuses() const { return statuses_; }
  /// Nothing where statuses (one a component) explain the observation, else some of them that cannot hold with it.
  /// What follows from a candidate is kept for the next, which differs in few statuses.
  std::optional<Conflict> refute(std::span<const std::uint32_t> candidate);
  /// Statuses that explain the observation with at most `faults` faults, below `counted`, and were not excluded;
  /// nothing where there are none.
  std::optional<std::vector<std::uint32_t>> at_most(std::size_t faults);
  /// Whether any statuses explain the observation.
  bool explicable() { return theory_.consistent({}); }
  /// Leaves out of `at_most` these statuses and all that have the same faults and more.
  void exclude(std::span<const std::uint32_t> candidate);

 private:
  automata::Variables extend(const automata::Plant& plant, std::size_t counted);
  [[nodiscard]] std::uint32_t status_of(automata::Assignment assignment) const;
  void tell_statuses(const automata::Plant& plant);
  void tell_counter();

  std::vector<Statuses> statuses_;
  /// Per component, per j below `counted`: whether it and those before it have more than j faults.
  std::vector<std::vector<automata::VariableId>> more_than_;
  std::vector<std::uint32_t> component_of_;  ///< per variable, of status variables
  automata::Theory theory_;
  std::vector<automata::Assignment> assumptions_;
};

}  // namespace rmpl::runtime
