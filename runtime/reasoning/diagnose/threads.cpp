// Thread by thread, the likeliest way to each marking first (Dijkstra).
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/threads.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <utility>

#include "automata/logic/theory.hpp"
#include "automata/step/marking_rules.hpp"
#include "base/limit_error.hpp"
#include "base/partition.hpp"
#include "base/product.hpp"

namespace rmpl::runtime {
namespace {

using automata::Formula;
using automata::LocationId;
using automata::Marking;
using automata::MarkingMoves;
using automata::MarkingOutcome;
using automata::ModelProgram;

void join_arcs(base::Partition& parts, std::size_t source, const std::vector<automata::GuardedArc>& arcs) {
  for (const automata::GuardedArc& arc : arcs) parts.join(source, arc.target.index());
}

/// What belongs to one thread; the program itself belongs to none, unless it may end or be entered as a whole: then all
/// is one.
base::Partition divide(const ModelProgram& program, const MarkingMoves& start) {
  base::Partition parts(program.locations.size());
  const automata::ModelLocation& root = program.locations.front();
  bool as_one = !root.maintenance.is_trivial() || !root.arcs.empty();
  for (std::size_t l = 1; l < program.locations.size(); ++l) {
    const automata::ModelLocation& location = program.locations[l];
    if (location.parent->index() > 0) parts.join(l, location.parent->index());
    join_arcs(parts, l, location.arcs);
    for (const automata::TransitionFunction& function : location.functions) {
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
    for (const automata::Interconnection& told : program.constraints) theory_.tell(told.constraint);
  }

  std::vector<Thread> run() {
    std::vector<Thread> threads;
    for (std::size_t l = 0; l < program_.locations.size(); ++l) {
      if (parts_.root(l) != l || (l == 0 && parts_.root(1 % program_.locations.size()) != 0)) continue;
      Thread thread = explore(l);
      const bool idle = thread.faults.empty() && thread.likely == std::vector<Marking>{{}};
      if (!idle) threads.push_back(std::move(thread));
    }
    return threads;
  }

 private:
  [[nodiscard]] std::vector<Formula> told(const Marking& marking) const {
    std::vector<Formula> result;
    for (const LocationId l : marking) result.push_back(program_.locations[l.index()].told);
    return result;
  }
  bool possible(std::vector<Formula> formulas) {
    return theory_.allows({}, theory_.encode(automata::conjunction(std::move(formulas))));
  }

  Thread explore(std::size_t part) {
    best_.clear();
    come_to(part_of(start_, part), 1);
    Thread thread;
    std::map<Marking, double> known;
    while (!open_.empty()) {
      const auto [probability, marking] = open_.top();
      open_.pop();
      if (!known.try_emplace(marking, probability).second) continue;
      if (known.size() > most_thread_markings) {
        throw base::LimitError("the thread of '" + program_.locations[part].label + "' has more than " +
                               std::to_string(most_thread_markings) + " markings; expected a smaller one");
      }
      std::vector<signed char> holds(rules_.conditions().size(), -1);
      leave(marking, probability, holds);
    }
    for (auto& [marking, probability] : known) {
      if (probability == 1) {
        thread.likely.push_back(marking);
      } else {
        thread.faults.push_back({marking, probability});
      }
    }
    return thread;
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
  void leave(const Marking& marking, double probability, std::vector<signed char>& holds) {
    std::optional<std::size_t> asked;
    const MarkingMoves moves = rules_.moves(marking, [&](std::size_t condition) {
      if (holds[condition] < 0 && !asked) asked = condition;
      return holds[condition] == 1;
    });
    if (!asked) {
      come_to(moves, probability);
      return;
    }
    for (signed char answer = 0; answer < 2; ++answer) {
      holds[*asked] = answer;
      if (may_hold(marking, holds)) leave(marking, probability, holds);
    }
    holds[*asked] = -1;
  }

  /// Whether some store tells what the marking tells, and more, in which the conditions hold and fail like this.
  bool may_hold(const Marking& marking, const std::vector<signed char>& holds) {
    if (++valuations_ > most_valuations) {
      throw base::LimitError("the conditions of '" + program_.name + "' may hold in more than " +
                             std::to_string(most_valuations) + " ways; expected a smaller program");
    }
    std::vector<Formula> entailed = told(marking), open;
    for (std::size_t c = 0; c < holds.size(); ++c) {
      if (holds[c] < 0) continue;
      const automata::Condition& condition = rules_.conditions()[c];
      ((holds[c] == 1) == condition.entailed ? entailed : open).push_back(condition.constraint);
    }
    if (!possible(entailed)) return false;
    return std::all_of(open.begin(), open.end(), [&](const Formula& formula) {
      std::vector<Formula> fails = entailed;
      fails.push_back(automata::negation(formula));
      return possible(std::move(fails));
    });
  }

  void come_to(const MarkingMoves& moves, double probability) {
    base::for_each_combination(moves.parts, [&](const std::vector<MarkingOutcome>& outcomes) {
      Marking target = moves.certain;
      double way = probability;
      for (const MarkingOutcome& outcome : outcomes) {
        target.insert(target.end(), outcome.marked.begin(), outcome.marked.end());
        if (outcome.improbable > 0) way *= outcome.probability;
      }
      std::sort(target.begin(), target.end());
      double& best = best_[target];
      if (way <= best || !possible(told(target))) return;
      best = way;
      open_.push({way, std::move(target)});
    });
  }

  const ModelProgram& program_;
  automata::MarkingRules rules_;
  automata::Theory theory_;
  MarkingMoves start_;
  base::Partition parts_;
  std::map<Marking, double> best_;  ///< way to a marking
  std::priority_queue<std::pair<double, Marking>> open_;
  std::size_t valuations_ = 0;
};

}  // namespace

std::vector<Thread> threads_of(const ModelProgram& program) { return Exploration(program).run(); }

}  // namespace rmpl::runtime
