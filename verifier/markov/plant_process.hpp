// A plant under free commands, in sampled time, as a Markov decision process.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/markov/draws.hpp"
#include "verifier/markov/list_numbers.hpp"
#include "verifier/markov/long_clocks.hpp"
#include "verifier/markov/prospects.hpp"
#include "verifier/property/commands.hpp"

namespace rmpl::verifier {

/// What is asked of a process.
struct Walked {
  automata::Ticks period;
  std::function<bool(const automata::Modes&)> wanted;
  std::vector<automata::Assignment> from;
  LeftOut left_out;  ///< of each step; `faults_beyond` counts the faults of a run
  bool for_ever = false;
  Units longest_in_state = 0;            ///< clocks are kept apart on which nothing depends for more steps
  const Prospects* prospects = nullptr;  ///< null: nothing is known of them
  Units steps = unbounded;               ///< how many matter
};

/// What is unknown of a row is as if it were wanted, in each of many steps.
inline constexpr Real many_steps = 1024;

inline Prospect prospect_of(const Walked& walked, const automata::Modes& modes) {
  return walked.prospects == nullptr ? Prospect{} : walked.prospects->of(modes);
}

/// States are modes, the clocks of components, and faults where they are bounded.
class PlantProcess final : public LongClocks {
 public:
  /// Keeps references. Throws base::InputError where a hazard changes for ever and the question has no end.
  /// `long_clocks`: whether clocks that run for long are kept apart.
  PlantProcess(automata::PlantStep& step, Commands commands, const Walked& walked, bool long_clocks, Meter& meter);

  std::vector<Start> initial() override;
  const std::vector<Row>& rows(StateNumber state, Real less_likely_than) override;
  bool wanted(StateNumber state) override;
  Prospect prospect(StateNumber state) override { return states_[state].prospect; }
  [[nodiscard]] std::size_t states() const override { return numbers_.size(); }

 private:
  struct State {
    automata::Modes modes;
    std::vector<Units> ages;  ///< by component
    unsigned faults = 0;
    std::vector<Units> longest;
    InState in_state;
    Prospect prospect;
    std::int8_t wanted = -1;  ///< below 0: not asked yet
  };

  [[nodiscard]] const std::vector<Units>& longest(StateNumber state) const override { return states_[state].longest; }
  [[nodiscard]] const InState& in_state(StateNumber state) const override { return states_[state].in_state; }
  Settled settle(StateNumber state, const std::vector<Units>& readings) override;
  StateNumber enter(automata::Modes modes, std::vector<Units> ages, unsigned faults);

  automata::PlantStep& step_;
  const Walked& walked_;
  Meter& meter_;
  Ages ages_;
  std::vector<automata::ControlAction> actions_;
  ListNumbers numbers_;
  std::vector<State> states_;
  std::vector<Row> rows_;
};

}  // namespace rmpl::verifier
