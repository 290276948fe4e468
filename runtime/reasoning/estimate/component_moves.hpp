// What one component may do in one step, as searches over extensions want it; and a table of what was worked out.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {

/// The modes of a component that are worth something beside their priors: a factor for each mode, above 0.
struct WeightedDomain {
  WeightedDomain(const OptimalSearch::Domain& by_prior, std::span<const double> mode_factors);

  std::vector<double> factors;   ///< by mode
  double least;                  ///< what the best mode costs, which was taken off all costs
  OptimalSearch::Domain domain;  ///< those that are left are at least 0
};

class ComponentMoves {
 public:
  explicit ComponentMoves(const std::vector<automata::Move>& moves);

  /// 0 where the component does not go to the mode.
  [[nodiscard]] double prior(automata::ModeId mode) const {
    return mode.index() < priors_.size() ? priors_[mode.index()] : 0.0;
  }
  [[nodiscard]] double greatest() const { return greatest_; }
  /// As they were given.
  [[nodiscard]] std::span<const automata::Move> moves() const { return moves_; }
  /// By mode; modes after the last possible one left out.
  [[nodiscard]] const std::vector<double>& priors() const { return priors_; }
  /// Its modes as the values of a decision variable, which cost -ln of their priors. Built when it is first asked for:
  /// of most readings of a clock nobody asks.
  [[nodiscard]] const OptimalSearch::Domain& domain() const;
  /// The same with factors. Remembered: there are as many as there are ways to see what one component leaves open.
  [[nodiscard]] const WeightedDomain& weighted(std::span<const double> factors) const;

 private:
  std::vector<automata::Move> moves_;
  std::vector<double> priors_;  ///< by mode; modes after the last possible one left out
  double greatest_ = 0;
  mutable std::optional<OptimalSearch::Domain> domain_;
  mutable std::vector<std::unique_ptr<const WeightedDomain>> weighted_;
};

/// What the components of a state may do in a step, worked out once for all states that agree on a component: its mode,
/// what is enabled, the length of the step, and its clock where that matters.
class MoveTable {
  /// What is enabled tells component and mode, too.
  struct Key {
    const automata::Enabled* enabled;
    std::int64_t clock;  ///< its reading at the end of the step; 0 where it does not matter
    std::int64_t step;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const noexcept;
  };
  using Table = std::unordered_map<Key, ComponentMoves, KeyHash>;

 public:
  using Moves = std::vector<const ComponentMoves*>;  ///< by component
  /// What rests on readings of clocks.
  using Passing = Table;

  /// `ranks`: probabilities as powers of ten.
  explicit MoveTable(const automata::Plant& plant, bool ranks = false) : plant_(plant), ranks_(ranks) {}

  /// For each component; valid until what it rests on is forgotten.
  void look_up(automata::PlantStep& step, const automata::Modes& modes, std::span<const automata::Ticks> clock_starts,
               const automata::ControlAction& action, automata::Ticks before, automata::Ticks now, Moves& moves) {
    look_up(step, modes, clock_starts, action, before, now, passing_, moves);
  }
  /// The same, where what rests on readings of clocks belongs to the caller: to be asked about one update alone.
  void look_up(automata::PlantStep& step, const automata::Modes& modes, std::span<const automata::Ticks> clock_starts,
               const automata::ControlAction& action, automata::Ticks before, automata::Ticks now, Passing& passing,
               Moves& moves);
  /// The components whose clocks took part in the last answer, ascending.
  [[nodiscard]] const std::vector<std::size_t>& timed() const { return timed_; }
  /// Of one of these, with another clock, beside what the last answer was about.
  const ComponentMoves* look_up_timed(automata::PlantStep& step, std::size_t component, automata::Ticks clock_start,
                                      automata::Ticks before, automata::Ticks now);

  /// Forgets what rests on readings of clocks once that is much: where steps are alike, clocks that started one after
  /// the other come to the same readings.
  void limit_timed() {
    constexpr std::size_t most = 1u << 13;
    if (passing_.size() > most) passing_.clear();
  }
  /// Forgets the rest, and lets go of it bit by bit, so that no single step pays for all of it.
  void forget() {
    retired_.clear();
    std::swap(lasting_, retired_);
  }
  [[nodiscard]] std::size_t size() const { return lasting_.size(); }

 private:
  const ComponentMoves* entry(automata::PlantStep& step, Table& table, std::size_t component,
                              automata::Ticks clock_start, bool timed, automata::Ticks before, automata::Ticks now);

  const automata::Plant& plant_;
  const bool ranks_;
  Table lasting_;
  Table retired_;  ///< of what was forgotten: what is still to be let go of
  Table passing_;
  std::vector<std::size_t> timed_;
  automata::Modes modes_;         ///< of the last answer,
  automata::AllEnabled enabled_;  ///< and what they enable
};

}  // namespace rmpl::runtime
