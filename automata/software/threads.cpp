// Thread by thread, from the start markings on; then the likeliest way to each marking (Dijkstra).
// SPDX-License-Identifier: MIT
#include "automata/software/threads.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <queue>
#include <utility>

#include "automata/logic/theory.hpp"
#include "automata/step/marking_rules.hpp"
#include "base/limit_error.hpp"
#include "base/partition.hpp"
#include "base/product.hpp"

namespace rmpl::automata {
namespace {

void join_arcs(base::Partition& parts, std::size_t source, const std::vector<GuardedArc>& arcs) {
  for (const GuardedArc& arc : arcs) parts.join(source, arc.target.index());
}

/// What belongs to one thread; the program itself belongs to none, unless it may end or be entered as a whole: then all
/// is one.
base::Partition divide(const ModelProgram& program, const MarkingMoves& start) {
  base::Partition parts(program.locations.size());
  const ModelLocation& root = program.locations.front();
  bool as_one = !root.maintenance.is_trivial() || !root.arcs.empty();
  for (std::size_t l = 1; l < program.locations.size(); ++l) {
    const ModelLocation& location = program.locations[l];
    if (location.parent->index() > 0) parts.join(l, location.parent->index());
    join_arcs(parts, l, location.arcs);
    for (const TransitionFunction& function : location.functions) {
      join_arcs(parts, l, function.arcs);
      for (const LocationId started : function.started) parts.join(l, started.index());
    }
    as_one = as_one || parts.root(l) == 0;
  }
  for (const auto& outcomes : start.parts) {
    std::optional<LocationId> last;
    for (const MarkingOutcome& outcome : outcomes) {
      for (const LocationId l : outcome.marked) {
        parts.join(last.value_or(l).index(), l.index());
        last = l;
      }
    }
  }
  for (std::size_t l = 1; as_one && l < program.locations.size(); ++l) parts.join(0, l);
  return parts;
}

class Exploration {
 public:
  explicit Exploration(const ModelProgram& program)
      : program_(program),
        rules_(program),
        theory_(program.variables),
        start_(rules_.initial()),
        parts_(divide(program, start_)) {
    for (const Interconnection& told : program.constraints) theory_.tell(told.constraint);
  }

  std::vector<Thread> run() {
    std::vector<Thread> threads;
    for (std::size_t l = 0; l < program_.locations.size(); ++l) {
      if (parts_.root(l) != l || (l == 0 && parts_.root(1 % program_.locations.size()) != 0)) continue;
      Thread thread = explore(l);
      const bool idle = thread.markings.size() == 1 && thread.markings.front().marked.empty();
      if (!idle) threads.push_back(std::move(thread));
    }
    return threads;
  }

 private:
  [[nodiscard]] std::vector<Formula> told(const Marking& marking) const {
    std::vector<Formula> result;
    result.reserve(marking.size());
    for (const LocationId l : marking) result.push_back(program_.locations[l.index()].told);
    return result;
  }
  bool possible(std::vector<Formula> formulas) {
    return theory_.allows({}, theory_.encode(conjunction(std::move(formulas))));
  }

  Thread explore(std::size_t part) {
    thread_ = {};
    known_.clear();
    thread_.first = LocationId(part);
    std::vector<ThreadOutcome> start = outcomes_of(part_of(start_, part));
    for (std::size_t m = 0; m < thread_.markings.size(); ++m) {
      if (!thread_.markings[m].possible) continue;
      std::vector<signed char> holds(rules_.conditions().size(), -1);
      under_.clear();
      leave(m, holds);
    }
    thread_.start = std::move(start);
    find_ways(thread_);
    return std::move(thread_);
  }

  MarkingMoves part_of(const MarkingMoves& moves, std::size_t part) {
    const auto own = [&](LocationId l) { return parts_.root(l.index()) == part; };
    MarkingMoves result;
    std::copy_if(moves.certain.begin(), moves.certain.end(), std::back_inserter(result.certain), own);
    for (const auto& outcomes : moves.parts) {
      const bool mine = std::any_of(outcomes.begin(), outcomes.end(), [&](const MarkingOutcome& outcome) {
        return std::any_of(outcome.marked.begin(), outcome.marked.end(), own);
      });
      if (mine) result.parts.push_back(outcomes);
    }
    return result;
  }

  /// All steps out of a marking, for every way in which the conditions that they ask may hold.
  void leave(std::size_t from, std::vector<signed char>& holds) {
    std::optional<std::size_t> asked;
    const Marking marking = thread_.markings[from].marked;
    const MarkingMoves moves = rules_.moves(marking, [&](std::size_t condition) {
      if (holds[condition] < 0 && !asked) asked = condition;
      return holds[condition] == 1;
    });
    if (!asked) {
      ThreadStep step{under_, outcomes_of(moves)};
      thread_.markings[from].steps.push_back(std::move(step));
      return;
    }
    const Condition& condition = rules_.conditions()[*asked];
    for (signed char answer = 0; answer < 2; ++answer) {
      holds[*asked] = answer;
      under_.push_back({(answer == 1) == condition.entailed, condition.constraint});
      if (may_hold(marking)) leave(from, holds);
      under_.pop_back();
    }
    holds[*asked] = -1;
  }

  /// Whether some store tells what the marking tells, and more, in which the conditions are so.
  bool may_hold(const Marking& marking) {
    if (++valuations_ > most_valuations) {
      throw base::LimitError("the conditions of '" + program_.name + "' may hold in more than " +
                             std::to_string(most_valuations) + " ways; expected a smaller program");
    }
    std::vector<Formula> entailed = told(marking);
    for (const Condition& condition : under_) {
      if (condition.entailed) entailed.push_back(condition.constraint);
    }
    if (!possible(entailed)) return false;
    return std::all_of(under_.begin(), under_.end(), [&](const Condition& condition) {
      if (condition.entailed) return true;
      std::vector<Formula> fails = entailed;
      fails.push_back(negation(condition.constraint));
      return possible(std::move(fails));
    });
  }

  std::size_t number(const Marking& marking) {
    const auto [known, fresh] = known_.try_emplace(marking, thread_.markings.size());
    if (!fresh) return known->second;
    if (known_.size() > most_thread_markings) {
      throw base::LimitError("the thread of '" + program_.locations[thread_.first.index()].label + "' has more than " +
                             std::to_string(most_thread_markings) + " markings; expected a smaller one");
    }
    ThreadMarking& added = thread_.markings.emplace_back();
    added.marked = marking;
    added.possible = possible(told(marking));
    return known->second;
  }

  std::vector<ThreadOutcome> outcomes_of(const MarkingMoves& moves) {
    std::map<Marking, ThreadOutcome> all;
    base::for_each_combination(moves.parts, [&](const std::vector<MarkingOutcome>& outcomes) {
      Marking target = moves.certain;
      ThreadOutcome way{0, 1, 1};
      for (const MarkingOutcome& outcome : outcomes) {
        target.insert(target.end(), outcome.marked.begin(), outcome.marked.end());
        way.probability *= outcome.probability;
        if (outcome.improbable > 0) way.rarity *= outcome.probability;
      }
      std::sort(target.begin(), target.end());
      all.emplace(std::move(target), way);
    });
    double sum = 0;
    for (const auto& [target, way] : all) sum += possible(told(target)) ? way.probability : 0;
    std::vector<ThreadOutcome> result;
    result.reserve(all.size());
    for (const auto& [target, way] : all) {
      if (sum > 0 && !possible(told(target))) continue;
      result.push_back({number(target), sum > 0 ? way.probability / sum : way.probability, way.rarity});
    }
    return result;
  }

  const ModelProgram& program_;
  MarkingRules rules_;
  Theory theory_;
  MarkingMoves start_;
  base::Partition parts_;
  Thread thread_;                         ///< in the making
  std::map<Marking, std::size_t> known_;  ///< its markings
  std::vector<Condition> under_;
  std::size_t valuations_ = 0;
};

}  // namespace

void find_ways(Thread& thread) {
  for (ThreadMarking& marking : thread.markings) marking.way = 0;
  std::priority_queue<std::pair<double, std::size_t>> open;
  const auto come_to = [&](const ThreadOutcome& outcome, double before) {
    double& best = thread.markings[outcome.target].way;
    const double way = before * outcome.rarity;
    if (way <= best) return;
    best = way;
    open.emplace(way, outcome.target);
  };
  for (const ThreadOutcome& outcome : thread.start) come_to(outcome, 1);
  while (!open.empty()) {
    const auto [way, at] = open.top();
    open.pop();
    if (way < thread.markings[at].way) continue;
    for (const ThreadStep& step : thread.markings[at].steps) {
      for (const ThreadOutcome& outcome : step.outcomes) come_to(outcome, way);
    }
  }
}

Formula told(const ModelProgram& program, const Marking& marking) {
  std::vector<Formula> parts;
  parts.reserve(marking.size());
  for (const LocationId l : marking) {
    const Formula& formula = program.locations[l.index()].told;
    if (!formula.is_true()) parts.push_back(formula);
  }
  return conjunction(std::move(parts));
}

std::vector<Thread> threads_of(const ModelProgram& program) { return Exploration(program).run(); }

}  // namespace rmpl::automata
