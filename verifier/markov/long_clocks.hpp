// Clocks that run for long with nothing depending on them: kept apart from states, by the step in which they read 0.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "verifier/markov/process.hpp"

namespace rmpl::verifier {

/// The reading of a clock that is kept apart.
inline constexpr Units kept_apart = -1;
/// The clocks that are part of a state, as far as they run on to where something depends on them.
struct InState {
  Units youngest = unbounded;
  Units oldest = 0;
  Units most_left = 0;  ///< for how many steps one of them runs on at most

  void add(Units reading, Units left) {
    youngest = std::min(youngest, reading);
    oldest = std::max(oldest, reading);
    most_left = std::max(most_left, left);
  }
};

/// The clocks of components as far as they matter: in periods, up to where nothing depends on them any more.
class Ages {
 public:
  /// Those on which nothing depends for more steps than `longest_in_state` are kept apart; none where that is not
  /// given. A hazard that changes for ever has no end; where `for_ever` says that there is to be one, throws
  /// base::InputError.
  Ages(const automata::Plant& plant, automata::Ticks period, std::optional<Units> longest_in_state, bool for_ever);
  /// As the mode is entered.
  [[nodiscard]] Units entered(std::size_t component, automata::ModeId mode) const {
    return quiet_[component][mode.index()] > longest_in_state_ ? kept_apart : 0;
  }
  /// After a period in which the component came from one mode to the other, or a restart started its clock anew.
  [[nodiscard]] Units after(std::size_t component, automata::ModeId from, Units age, automata::ModeId to,
                            bool restarted) const;
  /// For how many steps a clock that reads so much, as a part of a state, has something depend on it yet.
  [[nodiscard]] Units left(std::size_t component, automata::ModeId mode, Units age) const {
    return settled_[component][mode.index()] - age;
  }
  /// What a clock that is kept apart reads at most.
  [[nodiscard]] Units last(std::size_t component, automata::ModeId mode) const {
    return quiet_[component][mode.index()];
  }

 private:
  std::vector<std::vector<Units>> settled_;  ///< by component and mode
  std::vector<std::vector<Units>> quiet_;    ///< up to there the same is drawn
  Units longest_in_state_;
};

/// A process with clocks that are kept apart. States say what each of them reads at most.
class LongClocks : public Process {
 public:
  explicit LongClocks(Units longest_in_state);

  Point follow(const Point& from, const Branch& edge, Units now) final;
  Units lasts_until(const Point& at) final;
  bool has_clocks(const Point& at) final;
  std::optional<Point> as_begun(const Point& at, Units now) final;
  Point later(const Point& at, Units steps) final;

 protected:
  /// Where a long clock of the next state comes from: that one of this state, or else it reads so much now.
  struct Source {
    std::optional<std::size_t> clock;
    Units reading = 0;
    auto operator<=>(const Source&) const = default;
  };
  using Passage = std::vector<Source>;
  /// A state in which its long clocks read so much.
  struct Settled {
    StateNumber state;
    std::vector<Units> readings;
  };

  /// What the long clocks of a state, in order, read at most.
  [[nodiscard]] virtual const std::vector<Units>& longest(StateNumber state) const = 0;
  /// Its other clocks.
  [[nodiscard]] virtual const InState& in_state(StateNumber state) const = 0;
  /// The state that it becomes as its long clocks read so much, some of them more than that.
  virtual Settled settle(StateNumber state, const std::vector<Units>& readings) = 0;

  /// The number for a passage from a state with so many long clocks.
  std::uint32_t number(const Passage& passage, std::size_t before);
  /// A point as a run starts.
  Point at_start(const Settled& settled);

 private:
  using Starts = std::vector<Units>;  ///< by long clock: the step at which it read 0
  std::uint32_t number_of(const Starts& starts);

  Units longest_in_state_;
  std::map<Starts, std::uint32_t> start_numbers_;
  std::vector<const Starts*> starts_;
  std::map<Passage, std::uint32_t> passage_numbers_;
  std::vector<const Passage*> passages_;
};

}  // namespace rmpl::verifier
