// Who reads whom in a plant, in one place, and what has to do with what once some of it is known.
//
// Two variables are linked where something reads both. What is known already links nothing: it cannot pass anything on.
// The quotients differ in what is known, and in what counts as reading:
//
//   quotient  known                        linked by                     whose question             asked by
//   --------  ---------------------------  ----------------------------  ------------------------- --------------------
//   islands   modes                        each conjunct of Q and of     is the store consistent,   store/support
//                                          modes' constraints            what does it imply?
//   regions   modes, controls              the same                      which attributes can make  nominal/regions,
//                                                                        a formula true or false?  store/support
//   parts     nothing                      each formula of Q; all that   what can a command touch,  the tests of lint
//                                          a component's constraints     now or later?
//                                          and guards read, with its
//                                          mode
//   groups    controls that only guards    as parts                      whose beliefs depend on    estimate/groups
//             read and nobody observes                                   each other?
//   cones     (no partition, a closure)    islands that a component      what can decide these      slice/slices
//                                          shares, supports of its       formulas?
//                                          guards
//
// So regions refine islands, islands refine what parts say of attributes, and groups refine parts.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/dependencies/constraints.hpp"
#include "automata/dependencies/plant_index.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// A partition of the variables that are not known. Classes are numbered from 0, by their first variable.
struct Classes {
  std::vector<std::optional<std::size_t>> of;  ///< by variable; none for one that is known
  std::size_t count = 0;

  [[nodiscard]] std::optional<std::size_t> operator[](VariableId variable) const { return of[variable.index()]; }
};

/// Keeps a reference to the plant.
class Dependencies {
 public:
  /// A conjunct with the variables that it reads, ascending; the mode that it is told under is not among them.
  struct Reading {
    Constraint constraint;
    std::vector<VariableId> variables;
  };

  explicit Dependencies(const Plant& plant) : Dependencies(plant, constraints_of(plant)) {}
  /// With these in place of the plant's own constraints.
  Dependencies(const Plant& plant, std::vector<Constraint> constraints);

  [[nodiscard]] const Plant& plant() const { return plant_; }
  [[nodiscard]] const PlantIndex& index() const { return index_; }
  /// In the order in which they were given; as `constraints_of` lists them.
  [[nodiscard]] const std::vector<Reading>& constraints() const { return constraints_; }
  /// Whether an interconnection or a mode's constraint reads it.
  [[nodiscard]] bool read_by_store(VariableId variable) const { return read_by_store_[variable.index()]; }
  /// Whether it is a control whose value matters to guards alone, and that nobody observes.
  [[nodiscard]] bool only_commanded(VariableId variable) const;

  // The quotients of the table above.
  [[nodiscard]] Classes islands() const;
  [[nodiscard]] Classes regions() const;
  [[nodiscard]] Classes parts() const;
  [[nodiscard]] Classes groups() const;

 private:
  template <class Known>
  [[nodiscard]] Classes linked_by_conjuncts(const Known& known) const;
  template <class Known>
  [[nodiscard]] Classes linked_by_components(const Known& known) const;

  const Plant& plant_;
  PlantIndex index_;
  std::vector<Reading> constraints_;
  std::vector<bool> read_by_store_;  ///< by variable
  std::vector<bool> observed_;       ///< by variable
};

}  // namespace rmpl::automata
