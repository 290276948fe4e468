// Probabilities of closed loops, cycle by cycle.
// SPDX-License-Identifier: MIT
#include "tests/reference/loop_probability.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/product.hpp"

namespace rmpl::reference {

using automata::Assignment;
using automata::ClockId;
using automata::LocationId;
using automata::ModeId;
using automata::Modes;
using automata::SystemState;
using automata::Ticks;

namespace {

constexpr std::size_t most_at_one_time = 3000;

/// What tells what may follow, at the start of a cycle.
struct Now {
  std::set<LocationId> marking;
  std::map<ClockId, Ticks> clocks;  ///< what they read
  Modes modes;
  std::vector<Ticks> ages;
  std::optional<std::set<automata::VariableId>> no_plan;  ///< of the cycle before: the modes that its goal spoke of
  Adviser::Position position = 0;
  auto operator<=>(const Now&) const = default;
};
using Distribution = std::map<Now, Rational>;

class Sum {
 public:
  Sum(const automata::Program& program, const Step& step, const Adviser& adviser, const Question& question,
      Ticks period)
      : program_(program),
        step_(step),
        plant_(step.plant()),
        adviser_(adviser),
        question_(question),
        period_(period),
        asked_(knowledge_asked_by(program)) {}

  std::optional<Rational> run(std::size_t steps) {
    std::vector<std::vector<std::pair<ModeId, Rational>>> lists;
    for (const automata::Component& component : plant_.components) {
      auto& list = lists.emplace_back();
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        if (component.initial[m] > 0) list.emplace_back(m, Rational(component.initial[m]));
      }
      // The only one is certain, whatever its weight.
      if (list.size() == 1) list.front().second = 1;
    }
    const std::vector<Ticks> ages(plant_.components.size());
    const Sequencer sequencer(program_, step_.models());
    for (const auto& [modes, probability] : scaled(lists)) {
      arrive({sequencer.marking(), {}, modes, ages, std::nullopt, 0}, probability);
    }
    for (std::size_t i = 0; i < steps; ++i) {
      Distribution here = std::move(next_);
      next_.clear();
      if (here.size() > most_at_one_time) return std::nullopt;
      for (const auto& [now, probability] : here) cycle(now, probability);
    }
    return wanted_;
  }

 private:
  using Options = std::vector<std::vector<std::pair<ModeId, Rational>>>;

  /// All combinations that are possible, scaled to 1; none where there is none.
  [[nodiscard]] std::vector<std::pair<Modes, Rational>> scaled(const Options& options) const {
    std::vector<std::pair<Modes, Rational>> result;
    Rational all = 0;
    base::for_each_combination(options, [&](const std::vector<std::pair<ModeId, Rational>>& chosen) {
      Modes modes;
      Rational probability = 1;
      for (const auto& [mode, own] : chosen) {
        modes.push_back(mode);
        probability *= own;
      }
      if (probability == 0 || !step_.possible(modes)) return;
      all += probability;
      result.emplace_back(std::move(modes), probability);
    });
    for (auto& [modes, probability] : result) probability /= all;
    return result;
  }

  void arrive(Now now, const Rational& probability) {
    const auto store = assumptions_of(plant_, now.modes);
    const bool wanted = question_.entailed ? step_.models().entails(store, question_.target)
                                           : step_.models().allows(store, question_.target);
    if (wanted) {
      wanted_ += probability;
    } else {
      next_[std::move(now)] += probability;
    }
  }

  /// Of all that the program asks of the executive's knowledge, what is so where the estimate is the truth.
  [[nodiscard]] std::vector<automata::Formula> so(const Now& now) const {
    const auto store = assumptions_of(plant_, now.modes);
    std::vector<automata::Formula> result;
    for (const automata::Formula& atom : asked_) {
      bool is_so = false;
      if (atom.knowing == automata::Knowing::no_plan)
        is_so = now.no_plan && (!atom.about_one || now.no_plan->contains(atom.variable));
      if (atom.knowing == automata::Knowing::possible) is_so = step_.models().allows(store, atom.operands[0]);
      if (atom.knowing == automata::Knowing::likely) is_so = step_.models().entails(store, atom.operands[0]);
      if (is_so) result.push_back(atom);
    }
    return result;
  }

  void cycle(const Now& now, const Rational& probability) {
    if (now.marking.empty()) return;
    Sequencer sequencer(program_, step_.models());
    std::map<ClockId, Ticks> started;
    for (const auto& [clock, reading] : now.clocks) started[clock] = Ticks{0} - reading;
    sequencer.resume(now.marking, started);
    sequencer.know(so(now));
    const Sequencer::Goal asserted = sequencer.begin(assumptions_of(plant_, now.modes), Ticks{0}).front();
    std::vector<Assignment> goal;
    if (!asserted.contradictory) goal.assign(asserted.assignments.begin(), asserted.assignments.end());
    const Advice advice = adviser_.says(now.modes, goal, now.position);
    if (!step_.models().consistent(assumptions_of(plant_, now.modes, advice.action))) return;
    SystemState state{now.modes, {}};
    for (const Ticks age : now.ages) state.clock_starts.push_back(Ticks{0} - age);
    Options options;
    for (std::size_t c = 0; c < now.modes.size(); ++c) {
      auto& own = options.emplace_back();
      const std::vector<Rational> distribution = exact_distribution(step_, c, state, advice.action, Ticks{0}, period_);
      for (std::size_t m = 0; m < distribution.size(); ++m) {
        if (distribution[m] > 0) own.emplace_back(m, distribution[m]);
      }
    }
    for (const auto& [modes, share] : scaled(options)) {
      Now then{{}, {}, modes, now.ages, std::nullopt, adviser_.knows(now.modes, goal, now.position, modes)};
      for (std::size_t c = 0; c < modes.size(); ++c) {
        const bool goes_on = modes[c] == now.modes[c] && !step_.restarts(c, now.modes, advice.action);
        then.ages[c] = goes_on && is_timed(c, modes[c]) ? now.ages[c] + period_ : Ticks{0};
      }
      if (advice.no_plan) {
        then.no_plan.emplace();
        for (const Assignment& of : goal) then.no_plan->insert(of.variable);
      }
      Sequencer after = sequencer;
      after.know(so(then));
      after.finish(assumptions_of(plant_, modes));
      then.marking = after.marking();
      for (const auto& [clock, start] : after.started()) {
        const auto known = now.clocks.find(clock);
        then.clocks[clock] = period_ + (known == now.clocks.end() ? Ticks{0} : known->second);
      }
      arrive(std::move(then), probability * share);
    }
  }

  [[nodiscard]] bool is_timed(std::size_t component, ModeId mode) const {
    const auto& transitions = plant_.components[component].transitions;
    return std::any_of(transitions.begin(), transitions.end(),
                       [&](const automata::Transition& t) { return t.from == mode && t.timing; });
  }

  const automata::Program& program_;
  const Step& step_;
  const automata::Plant& plant_;
  const Adviser& adviser_;
  const Question& question_;
  Ticks period_;
  std::vector<automata::Formula> asked_;
  Distribution next_;
  Rational wanted_ = 0;
};

}  // namespace

std::optional<Rational> loop_probability(const automata::Program& program, const Step& step, const Adviser& adviser,
                                         const Question& question, Ticks period, std::size_t steps) {
  return Sum(program, step, adviser, question, period).run(steps);
}

}  // namespace rmpl::reference
