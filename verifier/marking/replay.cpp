// For each step draws are looked for that lead just where the witness says, those that mark anything else left out.
// SPDX-License-Identifier: MIT
#include "verifier/marking/replay.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "automata/logic/theory.hpp"
#include "automata/step/marking_rules.hpp"
#include "automata/time/checked_ticks.hpp"
#include "base/product.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::GuardedArc;
using automata::LocationId;
using automata::Marking;
using automata::ModelLocation;
using automata::ModelProgram;
using automata::Theory;

namespace {

using Locations = std::set<LocationId>;
using ImprobableDraws = std::vector<ImprobableDraw>;

/// What a branch that may have been drawn brings about.
struct Candidate {
  std::vector<std::pair<LocationId, LocationId>> arcs;  ///< taken: from, to
  Locations active;                                     ///< composites that something in is marked or started
  std::optional<ImprobableDraw> draw;                   ///< where it is one
};

Theory store_of(const ModelProgram& program, const Marking& marking) {
  Theory store(program.variables);
  for (const automata::Interconnection& told : program.constraints) store.tell(told.constraint);
  for (const LocationId l : marking) store.tell(program.locations[l.index()].told);
  return store;
}

void holders(const ModelProgram& program, LocationId location, Locations& result) {
  for (auto up = program.locations[location.index()].parent; up; up = program.locations[up->index()].parent) {
    result.insert(*up);
  }
}

/// The primitive locations that are marked with it.
void mark(const ModelProgram& program, LocationId target, Locations& marked) {
  if (!program.locations[target.index()].composite) marked.insert(target);
  for (std::size_t l = target.index() + 1; l < program.locations.size(); ++l) {
    if (program.locations[l].parent == target && program.locations[l].start) mark(program, LocationId(l), marked);
  }
}

/// One step, out of the store of one instant.
class Step {
 public:
  Step(const ModelProgram& program, const Marking& from, std::vector<Assignment> command, const Marking& to)
      : program_(program), command_(std::move(command)), store_(store_of(program, from)), to_(to.begin(), to.end()) {
    if (!store_.consistent(command_)) return;
    possible_ = true;
    for (const LocationId l : from) candidates_.push_back(candidates_of(l));
  }

  /// As few improbable draws as lead there; nothing where none do.
  std::optional<ImprobableDraws> draws() {
    if (!possible_) return std::nullopt;
    std::vector<const Candidate*> taken;
    std::size_t improbable = 0;
    std::optional<ImprobableDraws> best;
    const auto take = [&](std::size_t l, std::size_t c) {
      const Candidate& candidate = candidates_[l][c];
      if (best && improbable + (candidate.draw ? 1 : 0) >= best->size()) return false;
      improbable += candidate.draw ? 1 : 0;
      taken.push_back(&candidate);
      return true;
    };
    const auto put_back = [&](std::size_t, std::size_t) {
      improbable -= taken.back()->draw ? 1 : 0;
      taken.pop_back();
    };
    base::multiply_out(candidates_, take, put_back, [&] {
      if (!leads_there(taken)) return false;
      best.emplace();
      for (const Candidate* candidate : taken) {
        if (candidate->draw) best->push_back(*candidate->draw);
      }
      return best->empty();
    });
    return best;
  }

 private:
  [[nodiscard]] bool holds(const automata::Condition& condition) {
    return store_.entails(command_, store_.encode(condition.constraint)) == condition.entailed;
  }

  bool left(LocationId location) {
    Locations around;
    holders(program_, location, around);
    return std::any_of(around.begin(), around.end(),
                       [&](LocationId l) { return !holds(program_.locations[l.index()].maintenance); });
  }

  /// Whether all that is marked so is marked in the end.
  bool take_arcs(LocationId from, const std::vector<GuardedArc>& arcs, Candidate& candidate) {
    for (const GuardedArc& arc : arcs) {
      if (!std::all_of(arc.guard.begin(), arc.guard.end(), [&](const auto& guard) { return holds(guard); })) continue;
      Locations marked;
      mark(program_, arc.target, marked);
      if (!std::includes(to_.begin(), to_.end(), marked.begin(), marked.end())) return false;
      candidate.arcs.emplace_back(from, arc.target);
    }
    return true;
  }

  /// Of branches that bring about the same one of the likeliest.
  std::vector<Candidate> candidates_of(LocationId location) {
    std::vector<Candidate> result;
    const auto& functions = program_.locations[location.index()].functions;
    const bool gone = left(location);
    for (const bool improbable : {false, true}) {
      for (const automata::TransitionFunction& function : functions) {
        if (!(function.probability > 0) || is_improbable(function, functions) != improbable) continue;
        Candidate candidate;
        holders(program_, location, candidate.active);
        if (improbable) candidate.draw = ImprobableDraw{location, function.probability};
        bool fits = gone || take_arcs(location, function.arcs, candidate);
        for (const LocationId started : gone ? std::vector<LocationId>{} : function.started) {
          holders(program_, started, candidate.active);
          if (fits && !left(started)) {
            fits = take_arcs(started, program_.locations[started.index()].functions.front().arcs, candidate);
          }
        }
        const auto same = [&](const Candidate& known) {
          return known.arcs == candidate.arcs && known.active == candidate.active;
        };
        if (fits && std::none_of(result.begin(), result.end(), same)) result.push_back(std::move(candidate));
      }
    }
    return result;
  }

  /// Composites end from the inside out.
  bool leads_there(const std::vector<const Candidate*>& taken) {
    Candidate all;
    for (const Candidate* candidate : taken) {
      all.arcs.insert(all.arcs.end(), candidate->arcs.begin(), candidate->arcs.end());
      all.active.insert(candidate->active.begin(), candidate->active.end());
    }
    for (auto c = all.active.rbegin(); c != all.active.rend(); ++c) {
      const auto into = [&](const auto& arc) {
        Locations source, target{arc.second};
        holders(program_, arc.first, source);
        holders(program_, arc.second, target);
        return source.contains(*c) && target.contains(*c);
      };
      if (std::any_of(all.arcs.begin(), all.arcs.end(), into) || left(*c)) continue;
      if (!take_arcs(*c, program_.locations[c->index()].arcs, all)) return false;
    }
    Locations marked;
    for (const auto& [from, to] : all.arcs) mark(program_, to, marked);
    return marked == to_;
  }

  const ModelProgram& program_;
  std::vector<Assignment> command_;
  Theory store_;
  Locations to_;
  bool possible_ = false;
  std::vector<std::vector<Candidate>> candidates_;  ///< per location that is marked
};

/// The draws before time 0 that lead to a start marking, as few improbable ones as will do.
std::optional<ImprobableDraws> draws_of_start(const ModelProgram& program, const Marking& start) {
  Locations always;
  mark(program, LocationId(0), always);
  std::vector<std::vector<std::size_t>> branches;
  for (const automata::InitialDraw& draw : program.initial) {
    auto& own = branches.emplace_back();
    for (std::size_t b = 0; b < draw.branches.size(); ++b) {
      Locations marked = always;
      for (const LocationId l : draw.branches[b].started) mark(program, l, marked);
      const bool fits = std::includes(start.begin(), start.end(), marked.begin(), marked.end());
      if (fits && draw.branches[b].probability > 0) own.push_back(b);
    }
  }
  std::optional<ImprobableDraws> best;
  base::for_each_combination(branches, [&](const std::vector<std::size_t>& taken) {
    Locations marked = always;
    ImprobableDraws draws;
    for (std::size_t d = 0; d < taken.size(); ++d) {
      const automata::InitialDraw& draw = program.initial[d];
      const automata::InitialBranch& branch = draw.branches[taken[d]];
      for (const LocationId l : branch.started) mark(program, l, marked);
      if (is_improbable(branch, draw.branches)) draws.push_back({draw.choice, branch.probability});
    }
    const bool there = Marking(marked.begin(), marked.end()) == start;
    if (there && (!best || draws.size() < best->size())) best = std::move(draws);
  });
  return best;
}

bool is_free(const ModelProgram& program, Commands commands, const automata::Command& command) {
  std::size_t off_idle = 0;
  for (std::size_t c = 0; c < command.size(); ++c) off_idle += command[c] != program.controls[c].idle ? 1 : 0;
  return permits(commands, off_idle);
}

std::vector<Assignment> known(const ModelProgram& program, const automata::Command& command) {
  std::vector<Assignment> result;
  for (std::size_t c = 0; c < command.size(); ++c) {
    if (command[c]) result.push_back({program.controls[c].variable, *command[c]});
  }
  return result;
}

bool in_window(const MarkingQuestion& question, std::size_t steps) {
  const auto time = automata::checked_product(question.period, steps);
  const auto& [not_before, by] = question.window;
  return time && (!not_before || *not_before <= *time) && (!by || *time <= *by);
}

}  // namespace

std::optional<std::string> replay(const ModelProgram& program, const MarkingQuestion& question, unsigned improbable,
                                  MarkingWitness& witness) {
  auto& events = witness.events;
  std::size_t draws = 0;
  for (std::size_t e = 0; e < events.size(); ++e) {
    const std::string at = "step " + std::to_string(e) + ": ";
    if (!store_of(program, events[e].marking).consistent({})) return at + "the marking contradicts itself";
    std::optional<ImprobableDraws> drawn;
    if (e == 0) {
      drawn = draws_of_start(program, events[e].marking);
    } else {
      if (!is_free(program, question.commands, events[e].command)) return at + "the command is not free";
      Step step(program, events[e - 1].marking, known(program, events[e].command), events[e].marking);
      drawn = step.draws();
    }
    if (!drawn) return at + "no draws lead there";
    draws += drawn->size();
    events[e].draws = std::move(*drawn);
  }
  if (draws > improbable) return "it takes more improbable draws than were counted";
  if (!in_window(question, events.size() - 1)) return "it ends outside the window";
  Theory end = store_of(program, events.back().marking);
  const Theory::Handle formula = end.encode(question.formula);
  const bool holds = question.entailed ? end.entails({}, formula) : end.allows({}, formula);
  return holds ? std::nullopt : std::optional<std::string>("the formula does not hold at its end");
}

}  // namespace rmpl::verifier
