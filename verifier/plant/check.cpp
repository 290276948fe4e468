// Checking a property of a plant: an observer for it, a search, the evidence.
// SPDX-License-Identifier: MIT
#include "verifier/plant/check.hpp"

#include <algorithm>
#include <limits>
#include <memory>

#include "base/check.hpp"
#include "base/overloaded.hpp"
#include "verifier/plant/cut_sets.hpp"
#include "verifier/plant/plant_system.hpp"
#include "verifier/plant/timetable.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/slice/cone.hpp"
#include "verifier/witness/claim.hpp"
#include "verifier/witness/plant_stop.hpp"
#include "verifier/witness/replay.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Formula;
using automata::Modes;
using automata::PlantStep;
using automata::Theory;
using automata::Ticks;

namespace {

/// What is looked for, whatever the property: a target to reach, or a response to miss.
struct Target {
  Formula formula;
  Window window;
  bool fastest = false;
};
using Wanted = std::variant<Target, Response, Stuck>;

Wanted wanted_of(const Property& property) {
  return std::visit(
      base::Overloaded{[](const Reachability& p) {
                         return Wanted(Target{p.target, p.window, p.fastest});
                       },
                       [](const Safety& p) {
                         return Wanted(Target{p.never, p.window, p.fastest});
                       },
                       [](const Response& p) { return Wanted(p); }, [](const Stuck& p) { return Wanted(p); },
                       [](const ProgramProperty& p) -> Wanted {
                         throw base::InternalError(std::string(name_of(p.kind)) +
                                                   " is asked of a program, not of a plant alone");
                       }},
      property);
}

std::vector<Formula> formulas_of(const Wanted& wanted) {
  return std::visit(base::Overloaded{[](const Target& t) { return std::vector{t.formula}; },
                                     [](const Response& r) {
                                       return std::vector{r.after, r.then};
                                     },
                                     [](const Stuck&) { return std::vector<Formula>{}; }},
                    wanted);
}

std::vector<Ticks> times_of(const Wanted& wanted) {
  std::vector<Ticks> times;
  const auto add = [&](std::optional<Ticks> time) {
    if (time && !time->is_infinite()) times.push_back(*time);
  };
  std::visit(base::Overloaded{[&](const Target& t) {
                                add(t.window.not_before);
                                add(t.window.by);
                              },
                              [&](const Response& r) { add(r.within); }, [](const Stuck&) {}},
             wanted);
  return times;
}

/// The components whose modes decide a formula.
automata::Support support_of(const PlantStep& step, const Formula& formula) {
  return {step.locality().support_of(formula).components, {}};
}

/// Whether the formula holds at a state: the store implies it, or (not `certain`) allows it. Asked once for the modes
/// that it can depend on.
Observer::Test holds(PlantStep& step, const Formula& formula, bool certain) {
  using Memory = automata::Memory<bool>;
  const automata::Support support = support_of(step, formula);
  const Theory::Handle handle = step.theory().encode(formula);
  const auto memory = std::make_shared<Memory>(step.plant(), support);
  return [&step, handle, certain, support, memory](const Modes& modes) {
    return memory->find(modes, automata::ControlAction{}, [&] {
      std::vector<Assignment> store;
      for (const automata::ComponentId c : support.components) {
        store.push_back({step.plant()[c].mode, automata::ValueId(modes[c.index()].index())});
      }
      return certain ? step.theory().entails(store, handle) : step.theory().allows(store, handle);
    });
  };
}

class Check {
 public:
  Check(PlantStep& step, const Property& property, const CheckOptions& options, unsigned faults, Meter& meter)
      : step_(step),
        options_(options),
        faults_(faults),
        property_(property),
        wanted_(wanted_of(property)),
        meter_(meter),
        situations_(step, TimeModel::of(options.period, step.plant(), times_of(wanted_)), options.commands, faults,
                    meter) {}

  /// Any witness will do.
  Answer run_for_any_witness() {
    any_ = true;
    return run();
  }

  Answer run() {
    Answer result;
    try {
      start_ = situations_.initial(options_.from);
      cone_ = cone_of_influence(step_, formulas_of(wanted_));
      if (std::holds_alternative<Stuck>(wanted_)) cone_.assign(cone_.size(), true);
      if (options_.symmetry && !options_.cut_sets) {
        symmetry_ = Symmetry(automorphisms(step_.plant(), formulas_of(wanted_), options_.from));
        situations_.up_to(symmetry_);
      }
      result.startless = start_.empty();
      if (result.startless && !options_.from.empty()) {
        refuse_start();
      }
      std::visit([&](const auto& wanted) { look_for(wanted); }, wanted_);
      result.limit = limit_;
    } catch (const LimitReached& reached) {
      result.limit = reached.limit;
    }
    if (witness_ || !result.limit) {
      result.verdict =
          witness_.has_value() == std::holds_alternative<Reachability>(property_) ? Verdict::holds : Verdict::violated;
      if (!witness_) result.cut_off = cut_off_;
      // What would follow is not known, as no time comes in which it would.
      if (result.cut_off.still) result.verdict = Verdict::undecided;
    }
    result.witness = std::move(witness_);
    result.cut_sets = std::move(cut_sets_);
    result.progress = meter_.progress();
    return result;
  }

 private:
  using Observe = PlantSystem::Observe;

  void look_for(const Target& target) {
    const TimeModel& time = situations_.time();
    const auto reach = [&](std::optional<Interval> window) -> Observe {
      return [this, &target, window](PlantStep& step) {
        return Observer::reach(holds(step, target.formula, options_.entailed), window);
      };
    };
    Interval window;
    if (target.window.not_before) window.lower = time.at_least(*target.window.not_before);
    if (target.window.by) window.upper = time.at_most(*target.window.by);
    const bool windowed = target.window.not_before || target.window.by;
    witness_ = search(reach(windowed ? std::optional(window) : std::nullopt));
    // Each round asks for less time than the best so far takes, until there is none.
    while (target.fastest && witness_ && witness_->events.back().time > Ticks{0}) {
      window.upper = time.at_most(witness_->events.back().time) - 1;
      std::optional<Witness> faster = search(reach(window));
      if (!faster) return;
      witness_ = std::move(faster);
    }
  }

  void look_for(const Response& response) {
    if (response.within.is_infinite()) return;
    automata::Support read = support_of(step_, response.after);
    read.join(support_of(step_, response.then));
    visible_ = read.components;
    const Units deadline = situations_.time().more_than(response.within);
    owed_ = &response;
    witness_ = search([this, &response, deadline](PlantStep& step) {
      return Observer::miss(holds(step, response.after, options_.entailed),
                            holds(step, response.then, !options_.entailed), deadline);
    });
  }

  void look_for(const Stuck&) {
    witness_ = search([](PlantStep&) { return Observer::end(); });
  }

  /// First the cone of influence alone: if it cannot reach the target, the plant cannot; and if the rest may stay as it
  /// is all the while, a path with fewest steps of the cone is one of the plant.
  std::optional<Witness> search(const Observe& observe) {
    if (std::count(cone_.begin(), cone_.end(), false) > 0) {
      std::optional<Witness> witness = search_cone(observe);
      if (!witness || !failure_of_all(*witness)) return witness;
    }
    std::optional<Witness> witness = search_as_it_is(observe);
    if (!witness) return std::nullopt;
    if (const auto failure = failure_of_all(*witness)) throw base::InternalError("a witness fails: " + *failure);
    return witness;
  }

  std::optional<Witness> search_cone(const Observe& observe) {
    const Situations::Frozen rest(situations_, cone_);
    return search_as_it_is(observe);
  }

  /// Why the run, or one of the cut sets, is not possible in the plant or does not show what it is to show.
  [[nodiscard]] std::optional<std::string> failure_of_all(const Witness& witness) {
    std::optional<std::string> failure = failure_of(witness);
    for (const CutSet& cut : cut_sets_) {
      if (!failure) failure = failure_of(cut.witness);
    }
    return failure;
  }

  /// The rules for replays: a plant with a solver of its own, made where there is something to replay.
  automata::PlainStep& judge() {
    if (!judge_) judge_.emplace(step_.plant());
    return *judge_;
  }

  [[nodiscard]] std::optional<std::string> failure_of(const Witness& witness) {
    if (auto failure = replay(judge(), witness, {options_.period, options_.commands, faults_, options_.from})) {
      return failure;
    }
    return failure_to_show(judge(), property_, options_.entailed, witness);
  }

  /// In dense time, for as long as it lives, the steps that nothing else makes up for.
  [[nodiscard]] std::unique_ptr<const Situations::FewerSteps> fewer_steps() {
    if (!situations_.time().is_dense()) return nullptr;
    return std::make_unique<const Situations::FewerSteps>(situations_, visible_);
  }

  std::optional<Witness> search_cut_sets(PlantSystem& system) {
    FaultSets sets;
    system.tell_faults_apart(sets);
    const auto fewer = fewer_steps();
    cut_sets_.clear();
    for (const CutPath& cut : minimal_cut_sets(system, sets, meter_)) {
      cut_sets_.push_back({cut.set.faults, witness_of(cut.path, system)});
    }
    return cut_sets_.empty() ? std::nullopt : std::optional(cut_sets_.front().witness);
  }

  /// In dense time most questions are decided by the steps that nothing else makes up for; if they lead to the target,
  /// the fewest steps are looked for among all.
  std::optional<Witness> search_as_it_is(const Observe& observe) {
    PlantSystem system(situations_, observe, symmetry_, start_);
    if (options_.cut_sets) return search_cut_sets(system);
    std::optional<Witness> any;
    if (situations_.time().is_dense() || options_.fewest_faults) {
      const auto fewer = fewer_steps();
      const auto path = find_path(system, SearchOrder::covering, options_.threads, meter_);
      if (path) any = witness_of(*path, system);
      cut_off_ = system.cut_off();
      if (!any || any_) return any;
    }
    try {
      const auto path = find_path(system, SearchOrder::fewest_steps, options_.threads, meter_);
      CHECK((path.has_value() || !any) && "fewer steps lead where all do not");
      cut_off_ = system.cut_off();
      return path ? std::optional(witness_of(*path, system)) : std::nullopt;
    } catch (const LimitReached& reached) {
      if (!any) throw;
      limit_ = reached.limit;
      return any;
    }
  }

  /// With how it is cut off, where that is what it shows.
  Witness witness_of(const std::vector<PathState>& path, PlantSystem& system) {
    Witness witness = earliest_witness(path, system);
    if (owed_ != nullptr) witness.owed_since = owed_since(judge(), *owed_, options_.entailed, witness);
    if (!is_end(PlantSystem::phase_of(path.back().discrete))) return witness;
    const auto failure = explain_stop(judge(), witness, options_.commands, options_.period);
    if (failure) throw base::InternalError("a witness fails: it is cut off, but " + *failure);
    if (owed_ != nullptr) witness.owed_since = owed_since(judge(), *owed_, options_.entailed, witness);
    return witness;
  }

  PlantStep& step_;
  const CheckOptions& options_;
  unsigned faults_;
  bool any_ = false;
  const Property& property_;
  Wanted wanted_;
  Meter& meter_;
  Situations situations_;
  std::optional<automata::PlainStep> judge_;  ///< has no part in the search: it replays what that finds
  std::vector<bool> cone_;
  Symmetry symmetry_;
  const Response* owed_ = nullptr;              ///< what a witness is to miss
  std::vector<automata::ComponentId> visible_;  ///< read by the observer on the way
  std::vector<Modes> start_;
  std::vector<CutSet> cut_sets_;
  CutOff cut_off_;                  ///< seen by the search that decided
  std::optional<Limit> limit_;      ///< what kept the best from being better
  std::optional<Witness> witness_;  ///< the best so far
};

}  // namespace

namespace {

/// Whether nothing can ever violate what holds: no state satisfies what is never to hold, or none that can be reached
/// asks for a response.
bool is_vacuous(PlantStep& step, const Property& property, const CheckOptions& options, Meter& meter) {
  if (const auto* safety = std::get_if<Safety>(&property)) {
    return !step.theory().allows({}, step.theory().encode(safety->never));
  }
  const auto* response = std::get_if<Response>(&property);
  if (response == nullptr) return false;
  CheckOptions plain = options;
  plain.cut_sets = plain.fewest_faults = false;
  const unsigned faults = options.faults.value_or(std::numeric_limits<unsigned>::max());
  const Property asks = Reachability{response->after, {}, false};
  return Check(step, asks, plain, faults, meter).run_for_any_witness().verdict == Verdict::violated;
}

Answer decide(PlantStep& step, const Property& property, const CheckOptions& options, Meter& meter) {
  if (!options.fewest_faults) return Check(step, property, options, options.faults.value(), meter).run();
  // Round by round one fault more. Where no state needs as many as there may be, more of them may still come together
  // and lead somewhere: whether any number does is found out once, and then that is the answer, or the rounds will end.
  const unsigned most = options.faults.value_or(std::numeric_limits<unsigned>::max());
  bool reachable = false;
  for (unsigned faults = 0;; ++faults) {
    Answer result = Check(step, property, options, faults, meter).run();
    if (result.witness) result.fewest_faults = faults;
    if (result.witness || result.limit || faults == most) return result;
    if (reachable || result.progress.faults == faults) continue;
    Answer any = Check(step, property, options, most, meter).run_for_any_witness();
    if (!any.witness) return any;
    reachable = true;
  }
}

}  // namespace

Answer check(PlantStep& step, const Property& property, const CheckOptions& options, const Limits& limits) {
  demand_modes(step.plant(), options.from);
  Meter meter(limits);
  Answer answer = decide(step, property, options, meter);
  answer.vacuous = answer.verdict == Verdict::holds && is_vacuous(step, property, options, meter);
  answer.progress = meter.progress();
  return answer;
}

}  // namespace rmpl::verifier
