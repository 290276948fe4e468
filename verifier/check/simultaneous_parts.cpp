// Parts of a target that are wanted at one time.
// SPDX-License-Identifier: MIT
#include "verifier/check/simultaneous_parts.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "base/partition.hpp"
#include "verifier/check/soonest.hpp"
#include "verifier/check/target_tests.hpp"
#include "verifier/plant/timetable.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ControlAction;
using automata::Formula;

namespace {

/// Beyond so many rounds, or ways to share faults out, the parts are left to be searched as one.
constexpr std::size_t most_meeting_rounds = 256;
constexpr std::size_t most_shares = 64;

constexpr unsigned any_number = std::numeric_limits<unsigned>::max();

/// A run of a part, event by event, beside those of others.
class Course {
 public:
  Course(const Witness& run, const Cone& cone, const ControlAction& idle) : run_(run), cone_(cone), idle_(idle) {
    end_ = run.events.size();
    // That time has come is no step.
    const Event& last = run.events.back();
    const bool changes_nothing = end_ > 1 && last.modes == run.events[end_ - 2].modes && last.restarted.empty();
    if (changes_nothing && last.action == idle) --end_;
  }
  [[nodiscard]] bool over() const { return next_ == end_; }
  [[nodiscard]] automata::Ticks time() const { return run_.events[next_].time; }
  [[nodiscard]] bool commands() const { return run_.events[next_].action != idle_; }

  void step(Event& event) {
    const Event& own = run_.events[next_++];
    for (const ComponentId c : cone_) event.modes[c.index()] = own.modes[c.index()];
    event.restarted.insert(event.restarted.end(), own.restarted.begin(), own.restarted.end());
    for (std::size_t i = 0; i < idle_.size(); ++i) {
      if (own.action[i] != idle_[i]) event.action[i] = own.action[i];
    }
  }

 private:
  const Witness& run_;
  const Cone& cone_;
  const ControlAction& idle_;
  std::size_t end_;
  std::size_t next_ = 0;
};

}  // namespace

SimultaneousParts::SimultaneousParts(Slices& slices, const Target& target, const SearchScope::Terms& terms)
    : slices_(slices), target_(target), terms_(terms) {
  const std::vector<Formula> parts = automata::conjuncts_of(target.formula);
  base::Partition partition(parts.size());
  std::vector<Cone> cones;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    cones.push_back(slices.cone({&parts[i], 1}));
    for (std::size_t j = 0; j < i; ++j) {
      Cone common;
      std::set_intersection(cones[i].begin(), cones[i].end(), cones[j].begin(), cones[j].end(),
                            std::back_inserter(common));
      if (!common.empty()) partition.join(i, j);
    }
  }
  for (std::size_t root = 0; root < parts.size(); ++root) {
    std::vector<Formula> formulas;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (partition.root(i) == root) formulas.push_back(parts[i]);
    }
    if (formulas.empty()) continue;
    Formula formula = automata::conjunction(formulas);
    Cone cone = slices.cone({&formula, 1});
    groups_.push_back({std::move(formula), std::move(cone)});
  }
}

SimultaneousParts::Result SimultaneousParts::look(const Shows& shows) {
  const std::vector<Faults> shares =
      terms_.faults == any_number ? std::vector<Faults>{Faults(groups_.size(), any_number)} : shares_of(terms_.faults);
  if (shares.size() > most_shares) return {};
  Result best{true, std::nullopt};
  for (const Faults& share : shares) {
    Result result = meet(share, shows);
    if (result.witness && !target_.fastest) return result;
    if (!result.never && !result.witness) return {};
    best.never = best.never && result.never;
    const bool sooner =
        result.witness && (!best.witness || result.witness->events.back().time < best.witness->events.back().time);
    if (sooner) best.witness = std::move(result.witness);
  }
  return best;
}

/// All ways to share so many faults out, the last group getting what is left; one more than are looked at, at most.
std::vector<SimultaneousParts::Faults> SimultaneousParts::shares_of(unsigned faults) const {
  std::vector<Faults> shares;
  Faults share(groups_.size(), 0);
  share.back() = faults;
  while (shares.size() <= most_shares) {
    shares.push_back(share);
    // The last group but one that has something behind it gets one more; those behind it begin anew.
    unsigned behind = share.back();
    std::size_t next = share.size() - 1;
    while (next > 0 && behind == 0) behind += share[--next];
    if (next == 0) break;
    std::fill(share.begin() + static_cast<std::ptrdiff_t>(next), share.end(), 0);
    ++share[next - 1];
    share.back() = behind - 1;
  }
  return shares;
}

SimultaneousParts::Result SimultaneousParts::meet(const Faults& share, const Shows& shows) {
  const TimeModel& time = terms_.time;
  Interval window = interval_of(target_.window, time);
  std::vector<std::optional<Witness>> runs(groups_.size());
  bool missed = false;  // they came together once, and could not be together
  const auto in_time = [&](const std::optional<Witness>& run) {
    return run && time.at_least(run->events.back().time) == window.lower;
  };
  for (std::size_t round = 0; round < most_meeting_rounds; ++round) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (in_time(runs[g])) continue;
      runs[g] = earliest(g, share[g], window);
      if (!runs[g]) return {!cut_off_.ends() && !missed, std::nullopt};
      window.lower = time.at_least(runs[g]->events.back().time);
    }
    if (!std::all_of(runs.begin(), runs.end(), in_time)) continue;
    std::vector<Witness> parts;
    parts.reserve(runs.size());
    for (const auto& run : runs) parts.push_back(*run);
    if (Witness witness = together(parts); shows(witness)) return {false, std::move(witness)};
    if (target_.fastest) return {};
    missed = true;
    ++window.lower;
    if (window.lower > window.upper) return {};
  }
  return {};
}

/// The run to where the part is as wanted soonest within the window.
std::optional<Witness> SimultaneousParts::earliest(std::size_t group, unsigned faults, Interval window) {
  SearchScope& scope = this->scope(group, faults);
  const Formula& wanted = std::get<Target>(scope.wanted()).formula;
  const Situations::FewerSteps fewer(scope.situations(), {});
  const auto search = [&](const Interval& within) -> std::optional<Witness> {
    PlantSystem system(scope.situations(),
                       Observer::reach(holds(scope.step(), wanted, terms_.options.entailed), within), scope.symmetry(),
                       scope.start());
    if (const auto path = any_path(system, terms_.options.merge, terms_.meter)) {
      return scope.out(earliest_witness(*path, system));
    }
    cut_off_ |= system.cut_off();
    return std::nullopt;
  };
  if (window.lower > window.upper) return std::nullopt;
  std::optional<Witness> best = search(window);
  hasten(best, window, terms_.time, search);
  return best;
}

SearchScope& SimultaneousParts::scope(std::size_t group, unsigned faults) {
  auto& made = scopes_[{group, faults}];
  if (!made) {
    const Group& own = groups_[group];
    SearchScope::Terms terms{terms_.time, terms_.options, faults, terms_.meter};
    made = std::make_unique<SearchScope>(slices_.part(own.cone, {&own.formula, 1}),
                                         slices_.start(terms_.options.from).value(), Target{own.formula, {}, false},
                                         terms);
  }
  return *made;
}

/// One run of the plant of a run of each part, all of which end at one time. What comes at one time comes in one step,
/// but for commands where one at a time is free.
Witness SimultaneousParts::together(const std::vector<Witness>& parts) const {
  const ControlAction idle = automata::idle_action(slices_.plant());
  std::vector<Course> courses;
  for (std::size_t g = 0; g < parts.size(); ++g) courses.emplace_back(parts[g], groups_[g].cone, idle);
  Witness witness;
  witness.events.push_back({{}, slices_.start(terms_.options.from).value(), idle});
  for (Course& course : courses) course.step(witness.events.front());
  const auto over = [](const Course& course) { return course.over(); };
  while (!std::all_of(courses.begin(), courses.end(), over)) {
    Event event{automata::Ticks::infinite(), witness.events.back().modes, idle};
    for (const Course& course : courses) {
      if (!course.over()) event.time = std::min(event.time, course.time());
    }
    bool commanded = false;
    for (Course& course : courses) {
      if (course.over() || course.time() != event.time) continue;
      if (course.commands() && std::exchange(commanded, true) && terms_.options.commands != Commands::any) continue;
      course.step(event);
    }
    witness.events.push_back(std::move(event));
  }
  const automata::Ticks end = parts.front().events.back().time;
  if (end > witness.events.back().time) witness.events.push_back({end, witness.events.back().modes, idle});
  return witness;
}

}  // namespace rmpl::verifier
