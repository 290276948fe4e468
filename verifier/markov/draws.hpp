// What all components draw in one step, with probabilities: semantics 3 multiplied out.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/markov/enclosure.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/zone/interval.hpp"

namespace rmpl::verifier {

/// Modes that a step may lead to.
struct Draw {
  automata::Modes modes;
  Enclosure probability;
  unsigned faults = 0;  ///< components that go into a fault mode
};

/// All that a step may lead to. Nothing at all: nothing can follow.
struct Draws {
  std::vector<Draw> outcomes;                    ///< each once, the likelier ones first
  Real left_out = 0;                             ///< at most the probability of what is not listed
  std::vector<automata::Modes> impossible = {};  ///< of a part: what contradicts the interconnections
};

/// What is not listed.
struct LeftOut {
  Real less_likely_than = 0;                ///< outcomes of less than this
  std::optional<unsigned> faults_beyond{};  ///< outcomes with more faults than this
};

/// One thing that a component may do.
struct DrawOption {
  automata::ModeId mode;
  Enclosure probability;
  unsigned faults = 0;
  bool operator==(const DrawOption&) const = default;
};

/// The step from some modes under a command, which they permit, whatever clocks read. Keeps a reference.
class StepDraws {
 public:
  StepDraws(automata::PlantStep& step, automata::Modes modes, automata::AllEnabled enabled, automata::Ticks period);

  /// `ages` are the clocks of all components as the step begins, in periods, or below 0 where nothing depends on them
  /// yet. What contradicts the interconnections is dropped, and the rest is scaled to 1. Cost: the outcomes, and those
  /// that are dropped.
  Draws at(const std::vector<Units>& ages, const LeftOut& left_out, Meter& meter);
  /// What may be drawn at any ages is a mixture of these, with nothing left out. Nothing where there are too many.
  std::vector<Draws> extremes(Meter& meter);

  /// Whether the same is enabled in a component.
  [[nodiscard]] bool enables_as(const StepDraws& other, std::size_t component) const;
  /// Whether what a component may do depends on its clock.
  [[nodiscard]] bool is_timed(std::size_t component) const { return timed_[component]; }
  /// What a component may do at that age, in periods, the likelier first.
  [[nodiscard]] std::vector<DrawOption> options(std::size_t component, Units age) const {
    return options_of(component, age);
  }
  /// What all draw, not scaled, where the timed components come to these modes for certain, but for those that are
  /// `joined`, by component: all that such a one may do but for faults is one outcome, told as the first of `nominal`.
  [[nodiscard]] Draws part(const automata::Modes& timed, const std::vector<bool>& joined, const LeftOut& left_out,
                           Meter& meter) const;
  /// The modes that a component may come to, or stay in, without a fault, whatever its clock reads.
  [[nodiscard]] std::vector<automata::ModeId> nominal(std::size_t component) const;
  /// The faults that a component may take; nothing where they depend on its clock, or are not few, or lead where it
  /// may come to without one.
  [[nodiscard]] std::optional<std::vector<DrawOption>> faults(std::size_t component) const;
  /// Whether its clock decides between what it may do without a fault at that age.
  [[nodiscard]] bool decides(std::size_t component, Units age) const;

 private:
  [[nodiscard]] std::vector<DrawOption> options_of(std::size_t component, Units age) const;
  [[nodiscard]] std::vector<DrawOption> joined_options(std::size_t component) const;
  [[nodiscard]] std::vector<std::vector<DrawOption>> extremes_of(std::size_t component) const;

  automata::PlantStep& step_;
  automata::Modes modes_;
  automata::AllEnabled enabled_;
  automata::Ticks period_;
  std::vector<std::vector<DrawOption>> options_;  ///< by component
  std::vector<bool> timed_;                       ///< by component: its options depend on its clock
};

/// The same at an instant, in which rates and densities weigh nothing: of faults only those with a probability a step
/// happen. None of them may have time bounds.
Draws instant_draws(automata::PlantStep& step, const automata::Modes& modes, const automata::AllEnabled& enabled,
                    const LeftOut& left_out, Meter& meter);

/// The initial distribution, with the modes that are given in place of those of their components.
Draws initial_draws(automata::PlantStep& step, const std::vector<automata::Assignment>& from, Meter& meter);

}  // namespace rmpl::verifier
