// Runs of a plant without end.
// SPDX-License-Identifier: MIT
#include "verifier/plant/endless_run.hpp"

#include <algorithm>

#include "verifier/plant/timetable.hpp"
#include "verifier/search/lasso.hpp"
#include "verifier/witness/plant_run.hpp"

namespace rmpl::verifier {

using automata::Modes;
using automata::Ticks;

namespace {

/// A loop whose rounds cannot all take the same times comes back to the same readings after some rounds.
constexpr std::size_t most_rounds = 64;

/// What may go on for ever in a plant; a loop counts on which the response is owed.
class PlantRuns : public Runs {
 public:
  explicit PlantRuns(PlantSystem& system) : system_(system), situations_(system.situations()) {}

  TransitionSystem& system() override { return system_; }
  [[nodiscard]] bool counts(const SymbolicState& state) const override {
    return system_.observer().owes(PlantSystem::phase_of(state.discrete));
  }
  Modes modes(std::uint64_t discrete) override { return situations_.modes(PlantSystem::situation_of(discrete)); }
  Passage passage(const SymbolicState& from, const SymbolicState& to, const Label& label) override {
    const SituationId id = PlantSystem::situation_of(from.discrete);
    const Exits& idle = situations_.idle_exits(id);
    if (label.move == PlantSystem::no_move) return {&idle, nullptr, false};
    const unsigned left = system_.faults_left(from);
    if (discrete_ != from.discrete || left_ != left || !moves_) {
      moves_ = situations_.moves(id, system_.late(from), left);
    }
    discrete_ = from.discrete;
    left_ = left;
    const bool waited = PlantSystem::progressed(to.discrete);
    // In dense time a command lasts an instant: what stays enabled does while time passes.
    const JointStep& move = (*moves_)[label.move];
    if (situations_.time().is_dense()) return {waited ? &idle : nullptr, nullptr, waited, move.restarted};
    return {&situations_.exits(move.exits), waited ? &idle : nullptr, true, move.restarted};
  }

 private:
  PlantSystem& system_;
  Situations& situations_;
  std::uint64_t discrete_ = 0;
  unsigned left_ = 0;                                    ///< faults that may still happen
  std::shared_ptr<const std::vector<JointStep>> moves_;  ///< of that state
};

/// Whether the components that move between two events, or whose clocks start anew, read the same at both.
bool same_readings(automata::PlantStep& step, const TimeModel& time, const Witness& witness, std::size_t first,
                   std::size_t second) {
  const std::vector<Event>& events = witness.events;
  std::optional<Ticks> period;
  if (!time.is_dense()) period.emplace(time.unit());
  const std::vector<Ticks> before = state_at(step, events, first, period).clock_starts;
  const std::vector<Ticks> after = state_at(step, events, second, period).clock_starts;
  for (std::size_t c = 0; c < before.size(); ++c) {
    bool moves = before[c] != after[c];
    for (std::size_t e = first; e < second; ++e) moves = moves || events[e].modes[c] != events[e + 1].modes[c];
    if (moves && events[first].time - before[c] != events[second].time - after[c]) return false;
  }
  return true;
}

/// The run up to the end of its last round, which began at an event.
Witness cut(Witness witness, std::size_t begin, std::size_t end) {
  witness.events.resize(end + 1);
  witness.repeats_from = begin + 1;
  return witness;
}

}  // namespace

std::optional<Witness> find_endless_run(PlantSystem& system, Meter& meter) {
  PlantRuns runs(system);
  const auto lasso = find_lasso(runs, meter);
  if (!lasso) return std::nullopt;
  const auto round = lasso->path.begin() + static_cast<std::ptrdiff_t>(lasso->repeats_from) + 1;
  const std::vector<PathState> again(round, lasso->path.end());
  std::vector<PathState> path = lasso->path;
  std::optional<Witness> first;
  for (std::size_t rounds = 1;; rounds *= 2) {
    const TimedPath timed = earliest_path(path, system);
    std::vector<std::size_t> ends;  // of rounds, the begin of the first among them
    for (std::size_t r = 0; r <= rounds; ++r) ends.push_back(timed.entered[lasso->repeats_from + r * again.size()]);
    for (std::size_t end = 1; end < ends.size(); ++end) {
      for (std::size_t begin = end; begin-- > 0;) {
        if (same_readings(system.situations().step(), system.situations().time(), timed.witness, ends[begin],
                          ends[end])) {
          return cut(timed.witness, ends[begin], ends[end]);
        }
      }
    }
    if (!first) first = cut(timed.witness, ends[0], ends[1]);
    if (rounds >= most_rounds) return first;
    for (std::size_t more = 0; more < rounds; ++more) path.insert(path.end(), again.begin(), again.end());
  }
}

Witness resting(Witness witness, const automata::Plant& plant, Ticks step) {
  const Event& last = witness.events.back();
  witness.events.push_back({last.time + step, last.modes, automata::idle_action(plant)});
  witness.repeats_from = witness.events.size() - 1;
  return witness;
}

}  // namespace rmpl::verifier
