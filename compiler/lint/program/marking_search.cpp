// Breadth first through markings, readings of clocks, and the truth of the conditions that matter.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/marking_search.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "compiler/lint/program/clock_order.hpp"

namespace rmpl::compiler {

using automata::ClockId;
using automata::ClockTimes;
using automata::Condition;
using automata::Formula;
using automata::Location;
using automata::LocationId;
using automata::Marking;
using automata::Program;
using automata::Ticks;

namespace {

/// The start of a cycle.
struct Start {
  Marking marking;
  std::vector<bool> violated;  ///< per marked location: its maintenance condition fails
  std::vector<std::optional<std::size_t>>
      clocks;                      ///< per clock: which of its cuts it reads, or is past; none: inactive
  std::vector<std::size_t> ranks;  ///< per clock that runs and is compared with something: by its start; else 0
  std::size_t stage = 0;           ///< of the state of the plant
  auto operator<=>(const Start&) const = default;
};

/// A cycle that was met, and how.
struct Node {
  Start start;
  std::size_t before = 0;  ///< the cycle that led here; the first leads to itself
  Truths truths;           ///< of that one's end
  std::size_t depth = 1;
  std::set<LocationId> fresh;       ///< marked, and not in some cycle that led here
  std::set<LocationId> undisputed;  ///< asserting a goal that no other contradicts
};

/// What the rules ask, by what was chosen.
class Chosen final : public automata::ProgramAnswers {
 public:
  using Judge = std::function<bool(const Condition&)>;
  Chosen(const Program& program, const std::vector<bool>& violated, const Judge& judge)
      : program_(program), violated_(violated), judge_(judge) {}
  bool maintained(LocationId location) override { return !violated_[location.index()]; }
  bool guard_holds(LocationId location, std::size_t arc) override {
    return judge_(program_.locations[location.index()].arcs[arc].guard);
  }
  bool achieved(LocationId location) override { return judge_({true, goal_of(program_.locations[location.index()])}); }

 private:
  const Program& program_;
  const std::vector<bool>& violated_;  ///< per location
  const Judge& judge_;
};

class Search {
 public:
  Search(const Program& program, FreeConditions& conditions, const std::vector<bool>& relevant,
         const SearchLimits& limits)
      : program_(program),
        relevant_(relevant),
        limits_(limits),
        rules_(program),
        conditions_(conditions),
        cuts_(cuts_of(conditions_in(program))),
        order_(conditions_in(program)) {}

  std::vector<GoalClash> run() {
    const ClockTimes inactive(program_.clocks.size());
    const std::size_t clocks = program_.clocks.size();
    enter(rules_.initial(), inactive, {{}, {}, Indices(clocks), std::vector<std::size_t>(clocks), 0}, {}, 0, 1);
    for (std::size_t next = 0; next < nodes_.size() && steps_ < limits_.steps; ++next) follow(next);
    complete_ = complete_ && steps_ < limits_.steps;
    judge_certainty();
    return std::move(clashes_);
  }

 private:
  using Indices = std::vector<std::optional<std::size_t>>;

  [[nodiscard]] const Ticks* reading(const Indices& clocks, ClockId clock) const {
    const auto cuts = cuts_.find(clock);
    return !clocks[clock.index()] || cuts == cuts_.end() ? nullptr : &cuts->second[*clocks[clock.index()]];
  }
  [[nodiscard]] Formula read(const Formula& formula, const Indices& clocks) const {
    return has_clock(formula) ? with_clocks(formula, [&](ClockId clock) { return reading(clocks, clock); }) : formula;
  }

  /// A cycle: what it asserts, and every way that it can end.
  void follow(std::size_t number) {
    const Start start = nodes_[number].start;
    std::vector<bool> violated(program_.locations.size(), false);
    for (std::size_t m = 0; m < start.marking.size(); ++m) violated[start.marking[m].index()] = start.violated[m];
    ClockTimes started(program_.clocks.size());
    for (std::size_t c = 0; c < started.size(); ++c) {
      if (start.clocks[c]) started[c] = Ticks{0};
    }
    automata::HalfCycle half;
    automata::Asserted asserted;
    const Chosen::Judge none = [](const Condition&) { return false; };
    Chosen before(program_, violated, none);
    rules_.begin(start.marking, started, Ticks{0}, before, half, asserted);
    for (const automata::GoalConflict& conflict : asserted.conflicts) add_clash(conflict, number);
    note_undisputed(half, asserted, number);

    const auto open = open_at_end(half, start.clocks);
    if (!open) {
      complete_ = false;
      return;
    }
    const std::size_t stage = conditions_.after(start.stage);
    conditions_.for_each(*open, {}, stage, [&](const Truths& truths) {
      if (++steps_ > limits_.steps) return false;
      const Chosen::Judge judge = [&](const Condition& condition) {
        if (condition.is_trivial()) return true;
        return conditions_.holds(read(condition.constraint, start.clocks), truths) == condition.entailed;
      };
      Chosen answers(program_, violated, judge);
      ClockTimes after = started;
      Marking next = rules_.finish(half, answers, after);
      enter(std::move(next), after, {{}, {}, start.clocks, start.ranks, stage}, truths, number,
            nodes_[number].depth + 1);
      return true;
    });
  }

  void note_undisputed(const automata::HalfCycle& half, const automata::Asserted& asserted, std::size_t number) {
    std::set<LocationId> disputed;
    for (const automata::GoalConflict& conflict : asserted.conflicts) {
      disputed.insert(conflict.first);
      disputed.insert(conflict.second);
    }
    for (const LocationId id : nodes_[number].start.marking) {
      const bool asserts = half.working[id.index()] && !half.violated[id.index()];
      if (asserts && !disputed.count(id)) nodes_[number].undisputed.insert(id);
    }
  }

  /// What once begins to be asserted without dispute makes no clash certain.
  void judge_certainty() {
    std::set<LocationId> free;
    for (const Node& node : nodes_) {
      std::set_intersection(node.fresh.begin(), node.fresh.end(), node.undisputed.begin(), node.undisputed.end(),
                            std::inserter(free, free.end()));
    }
    for (GoalClash& clash : clashes_) {
      clash.certain = complete_ && (!free.count(clash.conflict.first) || !free.count(clash.conflict.second));
    }
  }

  /// The questions that the end of a cycle asks; nothing where there are too many of them.
  std::optional<std::vector<std::size_t>> open_at_end(const automata::HalfCycle& half, const Indices& clocks) {
    std::set<std::size_t> open;
    const auto ask = [&](const Formula& formula) {
      if (const auto question = conditions_.question(read(formula, clocks))) open.insert(*question);
    };
    for (std::size_t l = 0; l < program_.locations.size(); ++l) {
      if (!half.working[l]) continue;
      const Location& location = program_.locations[l];
      if (location.has_goal()) ask(goal_of(location));
      for (const automata::Arc& arc : location.arcs) ask(arc.guard.constraint);
    }
    if (open.size() > limits_.questions) return std::nullopt;
    return std::vector(open.begin(), open.end());
  }

  /// A marking that was come to, with each way that its clocks can read and its maintenance conditions can be.
  void enter(Marking marking, const ClockTimes& started, Start before, const Truths& truths, std::size_t from,
             std::size_t depth) {
    std::erase_if(marking, [&](LocationId location) { return !relevant_[location.index()]; });
    if (marking.empty()) return;
    Start start{std::move(marking), {}, Indices(started.size()), {}, before.stage};
    for (std::size_t c = 0; c < started.size(); ++c) {
      if (started[c]) start.clocks[c] = before.clocks[c].value_or(0);
    }
    start.ranks = ranks_of(start, before);
    const std::vector<std::size_t> seen = clocks_read_by(start);
    choose_readings(start, seen, 0, truths, from, depth);
  }

  /// Those that began to run in the cycle that is over come last.
  [[nodiscard]] std::vector<std::size_t> ranks_of(const Start& start, const Start& before) const {
    std::map<std::size_t, std::vector<std::size_t>> by_start;
    for (const auto& [clock, readings] : cuts_) {
      const std::size_t c = clock.index();
      if (start.clocks[c]) by_start[before.clocks[c] ? before.ranks[c] : start.clocks.size()].push_back(c);
    }
    std::vector<std::size_t> ranks(start.clocks.size(), 0);
    std::size_t rank = 0;
    for (const auto& [old, clocks] : by_start) {
      for (const std::size_t c : clocks) ranks[c] = rank;
      ++rank;
    }
    return ranks;
  }

  /// Whether clocks can read at once what was chosen for those that are seen; the others then read no less than that
  /// takes.
  bool settle_readings(Start& start, const std::vector<std::size_t>& seen) const {
    std::vector<RunningClock> clocks;
    for (const auto& [clock, readings] : cuts_) {
      if (!start.clocks[clock.index()]) continue;
      const bool is_seen = std::find(seen.begin(), seen.end(), clock.index()) != seen.end();
      clocks.push_back({clock, start.ranks[clock.index()], readings[*start.clocks[clock.index()]], !is_seen});
    }
    if (clocks.size() < 2) return true;
    const std::vector<Ticks> least = order_.least(clocks);
    for (std::size_t i = 0; i < least.size(); ++i) {
      if (!clocks[i].at_least) continue;
      const std::vector<Ticks>& readings = cuts_.at(clocks[i].clock);
      // Of the stretches that the readings stand for, the last that begins no later.
      auto& index = *start.clocks[clocks[i].clock.index()];
      while (index + 1 < readings.size() && order_.first(clocks[i].clock, readings[index + 1]) <= least[i]) ++index;
    }
    return !least.empty();
  }

  static std::vector<const Formula*> conditions_in(const Program& program) {
    std::vector<const Formula*> read;
    for (const Location& location : program.locations) {
      read.push_back(&location.maintenance.constraint);
      for (const automata::Arc& arc : location.arcs) read.push_back(&arc.guard.constraint);
    }
    return read;
  }

  [[nodiscard]] std::vector<std::size_t> clocks_read_by(const Start& start) const {
    std::vector<const Formula*> formulas;
    for (const LocationId id : start.marking) {
      const Location& location = program_.locations[id.index()];
      formulas.push_back(&location.maintenance.constraint);
      for (const automata::Arc& arc : location.arcs) formulas.push_back(&arc.guard.constraint);
    }
    std::vector<std::size_t> clocks;
    for (const auto& [clock, readings] : cuts_of(formulas)) {
      if (start.clocks[clock.index()]) clocks.push_back(clock.index());
    }
    return clocks;
  }

  void choose_readings(Start& start, const std::vector<std::size_t>& seen, std::size_t next, const Truths& truths,
                       std::size_t from, std::size_t depth) {
    if (next == seen.size()) {
      Start settled = start;
      if (settle_readings(settled, seen)) choose_maintenance(std::move(settled), truths, from, depth);
      return;
    }
    auto& index = start.clocks[seen[next]];
    const std::size_t least = *index;
    const std::size_t count = cuts_.at(ClockId(seen[next])).size();
    for (index = least; *index < count; ++*index) choose_readings(start, seen, next + 1, truths, from, depth);
    index = least;
  }

  void choose_maintenance(Start start, const Truths& truths, std::size_t from, std::size_t depth) {
    std::set<std::size_t> open;
    for (const LocationId id : start.marking) {
      const Formula& constraint = program_.locations[id.index()].maintenance.constraint;
      if (const auto question = conditions_.question(read(constraint, start.clocks))) open.insert(*question);
    }
    if (open.size() > limits_.questions) {
      complete_ = false;
      return;
    }
    conditions_.for_each({open.begin(), open.end()}, truths, start.stage, [&](const Truths& all) {
      start.violated.clear();
      for (const LocationId id : start.marking) {
        const Condition& condition = program_.locations[id.index()].maintenance;
        const bool kept = condition.is_trivial() ||
                          conditions_.holds(read(condition.constraint, start.clocks), all) == condition.entailed;
        start.violated.push_back(!kept);
      }
      meet(start, all, from, depth);
      return true;
    });
  }

  void meet(const Start& start, const Truths& truths, std::size_t from, std::size_t depth) {
    const auto [known, is_new] = known_.emplace(start, nodes_.size());
    if (is_new && nodes_.size() >= limits_.states) {
      known_.erase(known);
      complete_ = false;
      return;
    }
    if (is_new) nodes_.push_back({start, from, truths, depth, {}, {}});
    const Marking none;
    const Marking& before = depth == 1 ? none : nodes_[from].start.marking;
    auto& fresh = nodes_[known->second].fresh;
    std::set_difference(start.marking.begin(), start.marking.end(), before.begin(), before.end(),
                        std::inserter(fresh, fresh.end()));
  }

  void add_clash(const automata::GoalConflict& conflict, std::size_t number) {
    if (!clashing_.insert({conflict.first, conflict.second}).second) return;
    GoalClash clash{conflict, false, nodes_[number].depth, {}};
    for (std::size_t n = number; nodes_[n].depth > 1; n = nodes_[n].before) {
      clash.history.push_back(conditions_.text(nodes_[n].truths));
    }
    std::reverse(clash.history.begin(), clash.history.end());
    clashes_.push_back(std::move(clash));
  }

  const Program& program_;
  const std::vector<bool>& relevant_;
  const SearchLimits& limits_;
  const automata::ProgramRules rules_;
  FreeConditions& conditions_;
  const ClockCuts cuts_;
  const ClockOrder order_;
  std::vector<Node> nodes_;
  std::map<Start, std::size_t> known_;  ///< with their nodes
  std::set<std::pair<LocationId, LocationId>> clashing_;
  std::vector<GoalClash> clashes_;
  std::size_t steps_ = 0;
  bool complete_ = true;
};

}  // namespace

std::vector<GoalClash> find_goal_clashes(const Program& program, FreeConditions& conditions,
                                         const std::vector<bool>& relevant, const SearchLimits& limits) {
  return Search(program, conditions, relevant, limits).run();
}

}  // namespace rmpl::compiler
