// Checking a property: an observer for it, a search, the evidence.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cassert>
#include <limits>
#include <memory>
#include <set>

#include "base/error.hpp"
#include "base/overloaded.hpp"
#include "verifier/plant/cut_sets.hpp"
#include "verifier/plant/plant_system.hpp"
#include "verifier/property/property.hpp"
#include "verifier/slice/cone.hpp"
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
using Quest = std::variant<Target, Response>;

Quest quest_of(const Property& property) {
  return std::visit(base::Overloaded{[](const Reachability& p) {
                                       return Quest(Target{p.target, p.window, p.fastest});
                                     },
                                     [](const Safety& p) {
                                       return Quest(Target{p.never, p.window, p.fastest});
                                     },
                                     [](const Response& p) { return Quest(p); }},
                    property);
}

std::vector<Formula> formulas_of(const Quest& quest) {
  return std::visit(base::Overloaded{[](const Target& t) { return std::vector{t.formula}; },
                                     [](const Response& r) {
                                       return std::vector{r.after, r.then};
                                     }},
                    quest);
}

std::vector<Ticks> times_of(const Quest& quest) {
  std::vector<Ticks> times;
  const auto add = [&](std::optional<Ticks> time) {
    if (time && !time->is_infinite()) times.push_back(*time);
  };
  std::visit(base::Overloaded{[&](const Target& t) {
                                add(t.window.not_before);
                                add(t.window.by);
                              },
                              [&](const Response& r) { add(r.within); }},
             quest);
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
        reachability_(std::holds_alternative<Reachability>(property)),
        quest_(quest_of(property)),
        meter_(meter),
        situations_(step, Reading::of(options.period, step.plant(), times_of(quest_)), options.commands, faults,
                    meter) {}

  /// A trace will do, whichever it is.
  Result run_for_any_trace() {
    any_ = true;
    return run();
  }

  Result run() {
    Result result;
    try {
      start_ = situations_.initial(options_.from);
      cone_ = cone_of_influence(step_, formulas_of(quest_));
      if (options_.symmetry && !options_.cut_sets) {
        symmetry_ = Symmetry(automorphisms(step_.plant(), formulas_of(quest_), options_.from));
        situations_.up_to(symmetry_);
      }
      result.startless = start_.empty();
      if (result.startless && !options_.from.empty()) {
        refuse_start();
      }
      std::visit([&](const auto& quest) { look_for(quest); }, quest_);
      result.limit = limit_;
    } catch (const LimitReached& reached) {
      result.limit = reached.limit;
    }
    if (trace_ || !result.limit) {
      result.verdict = trace_.has_value() == reachability_ ? Verdict::holds : Verdict::violated;
    }
    result.trace = std::move(trace_);
    result.cut_sets = std::move(cut_sets_);
    result.progress = meter_.progress();
    return result;
  }

 private:
  using Observe = PlantSystem::Observe;

  void look_for(const Target& target) {
    const Reading& reading = situations_.reading();
    const auto reach = [&](std::optional<Interval> window) -> Observe {
      return [this, &target, window](PlantStep& step) {
        return Observer::reach(holds(step, target.formula, options_.entailed), window);
      };
    };
    Interval window;
    if (target.window.not_before) window.lower = reading.at_least(*target.window.not_before);
    if (target.window.by) window.upper = reading.at_most(*target.window.by);
    const bool windowed = target.window.not_before || target.window.by;
    trace_ = search(reach(windowed ? std::optional(window) : std::nullopt));
    // Each round asks for less time than the best so far takes, until there is none.
    while (target.fastest && trace_ && trace_->back().time > Ticks{0}) {
      window.upper = reading.at_most(trace_->back().time) - 1;
      std::optional<Trace> faster = search(reach(window));
      if (!faster) return;
      trace_ = std::move(faster);
    }
  }

  void look_for(const Response& response) {
    if (response.within.is_infinite()) return;
    automata::Support read = support_of(step_, response.after);
    read.join(support_of(step_, response.then));
    visible_ = read.components;
    const Units deadline = situations_.reading().more_than(response.within);
    trace_ = search([this, &response, deadline](PlantStep& step) {
      return Observer::miss(holds(step, response.after, options_.entailed),
                            holds(step, response.then, !options_.entailed), deadline);
    });
  }

  /// First the cone of influence alone: if it cannot reach the target, the plant cannot; and if the rest may stay as it
  /// is all the while, a path with fewest steps of the cone is one of the plant.
  std::optional<Trace> search(const Observe& observe) {
    if (std::count(cone_.begin(), cone_.end(), false) > 0) {
      situations_.freeze_all_but(cone_);
      std::optional<Trace> trace = search_as_it_is(observe);
      situations_.freeze_all_but({});
      if (!trace || all_possible(*trace)) return trace;
    }
    std::optional<Trace> trace = search_as_it_is(observe);
    assert((!trace || all_possible(*trace)) && "a witness cannot be replayed");
    return trace;
  }

  /// Whether the trace is one of the plant, and those of the cut sets are.
  [[nodiscard]] bool all_possible(const Trace& trace) {
    return possible(trace) &&
           std::all_of(cut_sets_.begin(), cut_sets_.end(), [&](const FaultTrace& cut) { return possible(cut.trace); });
  }

  std::optional<Trace> search_cut_sets(PlantSystem& system) {
    FaultSets sets;
    system.tell_faults_apart(sets);
    if (situations_.reading().is_dense()) situations_.use(Steps::irreducible, visible_);
    cut_sets_.clear();
    for (const CutSet& cut : minimal_cut_sets(system, sets, meter_)) {
      cut_sets_.push_back({cut.set.faults, earliest_trace(cut.path, system)});
    }
    situations_.use(Steps::all, {});
    return cut_sets_.empty() ? std::nullopt : std::optional(cut_sets_.front().trace);
  }

  /// In dense time most questions are decided by the steps that nothing else makes up for; if they lead to the target,
  /// the fewest steps are looked for among all.
  std::optional<Trace> search_as_it_is(const Observe& observe) {
    PlantSystem system(situations_, observe, symmetry_, start_);
    if (options_.cut_sets) return search_cut_sets(system);
    std::optional<Trace> any;
    if (situations_.reading().is_dense() || options_.fewest_faults) {
      if (situations_.reading().is_dense()) situations_.use(Steps::irreducible, visible_);
      const auto path = find_path(system, SearchOrder::covering, options_.threads, meter_);
      if (path) any = earliest_trace(*path, system);
      situations_.use(Steps::all, {});
      if (!any || any_) return any;
    }
    try {
      const auto path = find_path(system, SearchOrder::fewest_steps, options_.threads, meter_);
      assert((path.has_value() || !any) && "fewer steps lead where all do not");
      return path ? std::optional(earliest_trace(*path, system)) : std::nullopt;
    } catch (const LimitReached& reached) {
      if (!any) throw;
      limit_ = reached.limit;
      return any;
    }
  }

  [[nodiscard]] bool possible(const Trace& trace) {
    return !replay(step_, trace, {options_.period, options_.commands, faults_, options_.from});
  }

  PlantStep& step_;
  const CheckOptions& options_;
  unsigned faults_;
  bool any_ = false;
  bool reachability_;
  Quest quest_;
  Meter& meter_;
  Situations situations_;
  std::vector<bool> cone_;
  Symmetry symmetry_;
  std::vector<automata::ComponentId> visible_;  ///< read by the observer on the way
  std::vector<Modes> start_;
  std::vector<FaultTrace> cut_sets_;
  std::optional<Limit> limit_;  ///< what kept the best from being better
  std::optional<Trace> trace_;  ///< the best so far
};

}  // namespace

std::string name_of(const Property& property) {
  return std::visit(
      base::Overloaded{[](const Reachability&) { return "reachability"; }, [](const Safety&) { return "safety"; },
                       [](const Response&) { return "response"; }},
      property);
}

void demand_modes(const automata::Plant& plant, const std::vector<Assignment>& from) {
  std::set<automata::VariableId> seen;
  for (const Assignment& a : from) {
    const std::string& name = plant.variables.name(a.variable);
    if (!plant.component_of(a.variable)) {
      throw base::InputError("'" + name + "' is not the mode of a component; expected a component to start from");
    }
    if (!seen.insert(a.variable).second) {
      throw base::InputError("'" + name + "' is given more than one mode to start in");
    }
  }
}

void refuse_start() {
  throw base::InputError("no state to start in is possible: the modes contradict the interconnections");
}

Result check(PlantStep& step, const Property& property, const CheckOptions& options, const Limits& limits) {
  demand_modes(step.plant(), options.from);
  Meter meter(limits);
  if (!options.fewest_faults) return Check(step, property, options, options.faults.value(), meter).run();
  // Round by round one fault more. Where no state needs as many as there may be, more of them may still come together
  // and lead somewhere: whether any number does is found out once, and then that is the answer, or the rounds will end.
  const unsigned most = options.faults.value_or(std::numeric_limits<unsigned>::max());
  bool reachable = false;
  for (unsigned faults = 0;; ++faults) {
    Result result = Check(step, property, options, faults, meter).run();
    if (result.trace) result.fewest_faults = faults;
    if (result.trace || result.limit || faults == most) return result;
    if (reachable || result.progress.faults == faults) continue;
    Result any = Check(step, property, options, most, meter).run_for_any_trace();
    if (!any.trace) return any;
    reachable = true;
  }
}

}  // namespace rmpl::verifier
