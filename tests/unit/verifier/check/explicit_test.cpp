// The checker against a search through explicit states, unit by unit of time, on many small random plants.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <random>
#include <set>

#include "tests/unit/verifier/plants.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::verifier {
namespace {

using automata::ControlAction;
using automata::Modes;
using automata::PlantStep;
using automata::SystemState;
using automata::Ticks;
using test::PlantBuilder;
using test::seconds;

/// A plant with up to three components that share a control and constrain an attribute. Bounds are whole seconds.
PlantBuilder random_plant(std::mt19937& random) {
  const auto draw = [&](std::int64_t most) { return std::uniform_int_distribution<std::int64_t>(0, most)(random); };
  const auto pick = [&](std::int64_t of) { return static_cast<std::size_t>(draw(of - 1)); };
  PlantBuilder b;
  const std::vector<std::string> commands = {"idle", "go", "stop"};
  b.control("cmd", commands);
  b.variable("level", {"low", "high"});
  const auto components = static_cast<std::size_t>(1 + draw(2));
  for (std::size_t c = 0; c < components; ++c) {
    auto& component = b.component("c" + std::to_string(c), {"a", "b", "c", "x!"});
    if (draw(2) == 0) component.modes[pick(3)].constraint = b.is("level", draw(1) == 0 ? "low" : "high");
    if (draw(4) == 0) component.initial = {0.5, 0.5, 0, 0};
    const std::int64_t transitions = 2 + draw(3);
    for (std::int64_t t = 0; t < transitions; ++t) {
      const std::size_t from = pick(4);
      const std::size_t to = draw(9) == 0 ? 3 : pick(3);
      if (from == to) continue;
      automata::Formula guard = automata::constant(true);
      switch (draw(4)) {
        case 0:
          guard = b.is("cmd", commands[pick(3)]);
          break;
        case 1:
          guard = automata::negation(b.is("cmd", commands[pick(3)]));
          break;
        case 2:
          guard = b.is("level", draw(1) == 0 ? "low" : "high");
          break;
        default:
          break;
      }
      std::optional<automata::Timing> timing;
      if (draw(2) != 0) {
        const std::int64_t lower = draw(4);
        timing = test::within(lower, lower + draw(3));
        if (draw(5) == 0) *timing = {seconds(lower), Ticks::infinite(), {automata::Density::Kind::exponential, 5, 0}};
      }
      const automata::Weight weight =
          to == 3 ? (draw(1) == 0 ? test::probability(0.25) : test::rate(0.01)) : automata::Weight{};
      PlantBuilder::transition(component, from, to, guard, timing, weight);
    }
  }
  return b;
}

/// All states that are reachable, with clocks that count whole periods.
class Explicit {
 public:
  struct State {
    Modes modes;
    std::vector<std::int64_t> clocks;
    unsigned faults = 0;
    std::int64_t now = 0;    ///< up to `horizon`
    int phase = 0;           ///< of a response: 0 before `after` has held, 1 waiting, 2 done
    std::int64_t watch = 0;  ///< how long in phase 1
    auto operator<=>(const State&) const = default;
  };
  static constexpr std::int64_t horizon = 12;
  static constexpr std::int64_t cap = 12;  ///< above every finite bound

  Explicit(const automata::Plant& plant, const CheckOptions& options, Ticks unit)
      : plant_(plant), step_(plant), options_(options), unit_(unit) {
    for_each_action(plant, options.commands, [&](const ControlAction& action) { actions_.push_back(action); });
    std::vector<std::vector<automata::Move>> initial = step_.initial_moves();
    product(initial, [&](const Modes& modes) {
      if (step_.possible(modes)) starts_.push_back({modes, std::vector<std::int64_t>(modes.size(), 0), 0, 0, 0, 0});
    });
  }

  /// Fewest changes to each state; the formula tests make the phases.
  template <class After, class Then>
  std::map<State, int> reachable(bool track_time, const After& after, const Then& then) {
    const auto observe = [&](State s) {
      if (s.phase == 0 && after(s.modes)) s.phase = 1;
      if (s.phase == 1 && then(s.modes)) s.phase = 2;
      if (s.phase == 0) s.watch = 0;
      if (!track_time) s.now = 0;
      return s;
    };
    std::map<State, int> steps;
    std::deque<std::pair<State, int>> queue;
    for (const State& s : starts_) queue.emplace_back(observe(s), 0);
    while (!queue.empty()) {
      const auto [state, count] = queue.front();
      queue.pop_front();
      if (!steps.emplace(state, count).second) continue;
      if (state.now > horizon || state.watch > cap) continue;
      successors(state, [&, &from = state, n = count](State next) {
        next = observe(next);
        if (next.modes == from.modes) {
          queue.emplace_front(next, n);
        } else {
          queue.emplace_back(next, n + 1);
        }
      });
    }
    return steps;
  }

  /// Whether no step without a fault leads on from a state that was reached, and a response is waited for there.
  [[nodiscard]] bool is_waiting_at_an_end(const State& state) {
    bool goes_on = state.phase != 1;
    if (!goes_on) successors(state, [&](const State& next) { goes_on = goes_on || next.faults == state.faults; });
    return !goes_on;
  }

  [[nodiscard]] bool can_start() const { return !starts_.empty(); }

 private:
  template <class Visit>
  static void product(const std::vector<std::vector<automata::Move>>& all, const Visit& visit) {
    Modes modes;
    const std::function<void()> extend = [&] {
      if (modes.size() == all.size()) return visit(modes);
      for (const automata::Move& move : all[modes.size()]) {
        modes.push_back(move.mode);
        extend();
        modes.pop_back();
      }
    };
    extend();
  }

  State later(State s) const {
    for (auto& clock : s.clocks) clock = std::min(clock + 1, cap);
    ++s.now;
    if (s.phase == 1) ++s.watch;
    return s;
  }

  template <class Visit>
  void jump(const State& s, const std::vector<std::vector<automata::Move>>& all, const Visit& visit) {
    product(all, [&](const Modes& modes) {
      State next = s;
      for (std::size_t c = 0; c < modes.size(); ++c) {
        if (modes[c] == s.modes[c]) continue;
        next.clocks[c] = 0;
        next.faults += plant_.components[c].modes[modes[c].index()].fault ? 1 : 0;
      }
      next.modes = modes;
      if (next.faults <= options_.faults && step_.possible(modes)) visit(next);
    });
  }

  template <class Visit>
  void successors(const State& s, const Visit& visit) {
    if (options_.period) {
      SystemState system{s.modes, {}};
      const Ticks before{1000 * unit_.count};
      for (const std::int64_t clock : s.clocks) system.clock_starts.push_back(Ticks{(1000 - clock) * unit_.count});
      for (const ControlAction& action : actions_) {
        jump(later(s), step_.moves(system, action, before, before + unit_), visit);
      }
      return;
    }
    if (time_may_pass(s)) visit(later(s));
    for (const ControlAction& action : actions_) {
      const auto enabled = step_.enabled(s.modes, action);
      std::vector<std::vector<automata::Move>> all;
      for (std::size_t c = 0; c < s.modes.size(); ++c) {
        const automata::Component& component = plant_.components[c];
        auto& moves = all.emplace_back();
        const auto clock = [&](const Ticks& bound) { return Ticks{s.clocks[c] * unit_.count} <=> bound; };
        for (const auto t : enabled[c].faults) {
          const auto& transition = component.transitions[t.index()];
          const auto& timing = transition.timing;
          if (!timing || (clock(timing->lower) >= 0 && clock(timing->upper) <= 0)) moves.push_back({transition.to, 1});
        }
        for (const auto t : enabled[c].untimed) moves.push_back({component.transitions[t.index()].to, 1});
        if (!enabled[c].untimed.empty()) continue;
        moves.push_back({s.modes[c], 1});
        for (const auto t : enabled[c].timed) {
          const auto& transition = component.transitions[t.index()];
          if (clock(transition.timing->lower) >= 0) moves.push_back({transition.to, 1});
        }
      }
      jump(s, all, [&](const State& next) {
        if (next.modes != s.modes) visit(next);
      });
    }
  }

  bool time_may_pass(const State& s) {
    const auto& enabled = step_.enabled(s.modes, automata::idle_action(plant_));
    for (std::size_t c = 0; c < s.modes.size(); ++c) {
      if (!enabled[c].untimed.empty()) return false;
      for (const auto t : enabled[c].timed) {
        const Ticks upper = plant_.components[c].transitions[t.index()].timing->upper;
        if (Ticks{s.clocks[c] * unit_.count} >= upper) return false;
      }
    }
    return true;
  }

  const automata::Plant& plant_;
  PlantStep step_;
  const CheckOptions& options_;
  Ticks unit_;
  std::vector<ControlAction> actions_;
  std::vector<State> starts_;
};

/// How many steps of a run change a mode.
int changes(const Witness& witness) {
  int result = 0;
  const std::vector<Event>& events = witness.events;
  for (std::size_t e = 1; e < events.size(); ++e) result += events[e].modes == events[e - 1].modes ? 0 : 1;
  return result;
}

/// Compares every question that both can answer; the period 2 s makes bounds fall between the steps.
void compare(std::optional<Ticks> period, unsigned rounds, unsigned seed) {
  std::mt19937 random(seed);
  unsigned reached = 0;
  unsigned missed = 0;
  for (unsigned round = 0; round < rounds; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const PlantBuilder b = random_plant(random);
    const auto& last = b.plant.components.back();
    CheckOptions options;
    options.period = period;
    options.faults = round % 3 == 0 ? 1 : 0;
    options.commands = round % 4 == 0 ? Commands::none : Commands::one;
    const Ticks unit = period.value_or(seconds(1));
    Explicit slow(b.plant, options, unit);
    if (!slow.can_start()) continue;
    const auto in = [&](std::size_t mode) {
      return [mode](const Modes& modes) { return modes.back().index() == mode; };
    };
    const auto never = [](const Modes&) { return false; };
    Slices slices(b.plant);
    // The exploration below knows nothing of time that stands still: tests/reference does, and the properties.
    const Answer dead_end = check(slices, Stuck{}, options, {});
    if (dead_end.witness && dead_end.witness->stop->still) continue;

    // Fewest steps.
    const auto all = slow.reachable(false, never, never);
    for (std::size_t mode = 0; mode < 4; ++mode) {
      std::optional<int> fewest;
      for (const auto& [state, steps] : all) {
        if (in(mode)(state.modes)) fewest = std::min(fewest.value_or(steps), steps);
      }
      const auto target = automata::is(last.mode, automata::ValueId(mode));
      const Answer result = check(slices, Reachability{target, {}, false}, options, {});
      ASSERT_EQ(result.verdict, fewest ? Verdict::holds : Verdict::violated) << mode;
      if (fewest) {
        EXPECT_EQ(changes(*result.witness), *fewest) << mode;
      }
      reached += fewest ? 1 : 0;
    }

    // Times.
    const auto timed = slow.reachable(true, never, never);
    for (std::size_t mode = 0; mode < 3; ++mode) {
      std::set<std::int64_t> times;
      for (const auto& [state, steps] : timed) {
        if (in(mode)(state.modes) && state.now <= Explicit::horizon) times.insert(state.now);
      }
      const auto target = automata::is(last.mode, automata::ValueId(mode));
      if (!times.empty()) {
        const Answer fastest = check(slices, Reachability{target, {}, true}, options, {});
        ASSERT_EQ(fastest.verdict, Verdict::holds);
        EXPECT_EQ(fastest.witness->events.back().time.count, *times.begin() * unit.count);
      }
      for (const auto& [from, to] : {std::pair<std::int64_t, std::int64_t>{0, 3}, {4, 6}, {9, 9}}) {
        const auto at = times.lower_bound(from);
        const Window window{Ticks{from * unit.count}, Ticks{to * unit.count}};
        EXPECT_EQ(check(slices, Reachability{target, window, false}, options, {}).verdict,
                  at != times.end() && *at <= to ? Verdict::holds : Verdict::violated)
            << mode << " in " << from << ".." << to;
      }
    }

    // Responses.
    const auto waiting = slow.reachable(false, in(1), in(2));
    for (const std::int64_t within : {0, 2, 5}) {
      const bool miss = std::any_of(waiting.begin(), waiting.end(), [&](const auto& entry) {
        // Whether it goes on waiting, or the response came too late; or nothing can follow that would not.
        return entry.first.watch > within || (entry.first.watch == within && slow.is_waiting_at_an_end(entry.first));
      });
      const Response response{automata::is(last.mode, automata::ValueId(1)),
                              automata::is(last.mode, automata::ValueId(2)), Ticks{within * unit.count}};
      EXPECT_EQ(check(slices, response, options, {}).verdict, miss ? Verdict::violated : Verdict::holds) << within;
      missed += miss ? 1 : 0;
    }
  }
  EXPECT_GT(reached, rounds);
  EXPECT_GT(missed, rounds / 8);
}

TEST(AgainstExplicitStates, DenseTime) { compare(std::nullopt, 150, 11); }
TEST(AgainstExplicitStates, SampledAtOneSecond) { compare(seconds(1), 150, 12); }
TEST(AgainstExplicitStates, SampledBetweenTheBounds) { compare(seconds(2), 150, 13); }

}  // namespace
}  // namespace rmpl::verifier
