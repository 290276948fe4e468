// Checking a property of a plant for one number of faults: an observer for it, a search, the evidence.
// SPDX-License-Identifier: MIT
#include "verifier/check/check_once.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "base/check.hpp"
#include "verifier/check/apart.hpp"
#include "verifier/check/out_of_reach.hpp"
#include "verifier/check/planned_run.hpp"
#include "verifier/check/proofs.hpp"
#include "verifier/check/search_scope.hpp"
#include "verifier/check/simultaneous_parts.hpp"
#include "verifier/check/soonest.hpp"
#include "verifier/check/target_tests.hpp"
#include "verifier/cut_set/cut_sets.hpp"
#include "verifier/plant/endless_run.hpp"
#include "verifier/plant/plant_system.hpp"
#include "verifier/plant/timetable.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/witness/claim.hpp"
#include "verifier/witness/plant_stop.hpp"
#include "verifier/witness/replay.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::Modes;
using automata::PlantStep;

namespace {

/// How many states parts that are searched each by itself may have all together, before they are searched as one.
constexpr std::size_t states_apart = 1u << 16;

class Check {
 public:
  Check(Slices& slices, const Property& property, const CheckOptions& options, unsigned faults, Meter& meter)
      : slices_(slices),
        options_(options),
        property_(property),
        wanted_(wanted_of(property)),
        meter_(meter),
        terms_{TimeModel::of(options.period, slices.plant(), times_of(wanted_)), options, faults, meter} {}

  /// Any witness will do.
  Answer run_for_any_witness() {
    any_ = true;
    return run();
  }

  Answer run() {
    Answer result;
    try {
      result.startless = !slices_.start(options_.from);
      if (result.startless && !options_.from.empty()) refuse_start();
      if (!result.startless) {
        set_out();
        std::visit([&](const auto& wanted) { look_for(wanted); }, wanted_);
      }
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
  /// What observes in a scope.
  using Observe = std::function<Observer(SearchScope&)>;

  /// The cone becomes a plant of its own, unless it is everything.
  void set_out() {
    if (!options_.slice || std::holds_alternative<Stuck>(wanted_)) return;
    const std::vector<Formula> formulas = formulas_of(wanted_);
    const Cone cone = slices_.cone(formulas);
    if (cone.size() == slices_.plant().components.size()) return;
    cone_.emplace(slices_.part(cone, formulas), slices_.start(options_.from).value(), wanted_, terms_);
  }

  SearchScope& whole() {
    if (!whole_) whole_.emplace(slices_.whole(), wanted_, terms_);
    return *whole_;
  }

  [[nodiscard]] Observe reach(std::optional<Interval> window) const {
    return [this, window](SearchScope& searched) {
      const Formula& wanted = std::get<Target>(searched.wanted()).formula;
      return Observer::reach(holds(searched.step(), wanted, options_.entailed), window);
    };
  }

  /// Of what is to hold all at once, whether a part can never hold, as its own cone tells where that is much smaller.
  /// Components that have nothing to do with each other do not multiply then.
  bool refuted_in_part(const Target& target, const Observe& observe) {
    const std::vector<Formula> parts = automata::conjuncts_of(target.formula);
    if (!options_.slice || options_.cut_sets || !terms_.time.is_dense() || parts.size() < 2) return false;
    const std::size_t all = slices_.cone({&target.formula, 1}).size();
    return std::any_of(parts.begin(), parts.end(), [&](const Formula& part) {
      const Cone cone = slices_.cone({&part, 1});
      if (2 * cone.size() > all) return false;
      const Wanted wanted = Target{part, target.window};
      SearchScope scope(slices_.part(cone, {&part, 1}), slices_.start(options_.from).value(), wanted, terms_);
      PlantSystem system(scope.situations(), observe(scope), scope.symmetry(), scope.start());
      const auto fewer = fewer_steps(scope, scope.situations(), terms_.time);
      const bool reached = options_.merge ? find_corridor(system, meter_).has_value()
                                          : find_path(system, SearchOrder::covering, meter_).has_value();
      if (reached) return false;
      if (system.cut_off().ends()) return false;
      cut_off_ = system.cut_off();
      return true;
    });
  }

  /// Where parts of the target have nothing to do with each other: as one as long as there are few states, then each by
  /// itself. Whether that decides all that was asked; there may be a witness where it does not.
  bool look_apart(const Target& target, const Observe& observe) {
    if (!options_.slice || options_.cut_sets || !terms_.time.is_dense()) return false;
    SimultaneousParts parts(slices_, target, terms_);
    if (!parts.worthwhile()) return false;
    try {
      const Meter::Allowance few(meter_, options_.states_as_one);
      witness_ = search(observe);
      return !witness_;
    } catch (const AllowanceSpent&) {
      cut_off_ = {};
    }
    try {
      const Meter::Allowance more(meter_, states_apart);
      auto found = parts.look([this](const Witness& witness) { return !failure_of(witness); });
      witness_ = std::move(found.witness);
      cut_off_.spent = parts.spent();
      return found.never || witness_;
    } catch (const AllowanceSpent&) {
      return false;
    }
  }

  void look_for(const Target& target) {
    SearchScope& scope = cone_ ? *cone_ : whole();
    const Formula& formula = std::get<Target>(scope.wanted()).formula;
    if (options_.slice && out_of_reach(scope.step(), formula, scope.from(), terms_.faults)) return;
    const TimeModel& time = terms_.time;
    const Interval window = interval_of(target.window, time);
    const Observe any_time = reach(target.window.is_all() ? std::nullopt : std::optional(window));
    try {
      if (refuted_in_part(target, any_time)) return;
      if (look_apart(target, any_time)) return;
      if (!witness_) witness_ = search_or_plan(target, any_time);
    } catch (const LimitReached& reached) {
      if (reached.limit == Limit::interrupt || options_.cut_sets) throw;
      witness_ = planned(target);
      if (!witness_) throw;
      limit_ = reached.limit;
      return;
    }
    if (target.fastest && !options_.cut_sets) {
      hasten(witness_, window, time, [this](const Interval& sooner) { return search(reach(sooner)); });
    }
  }

  /// A search that comes to many states stops for a plan that leads there.
  std::optional<Witness> search_or_plan(const Target& target, const Observe& observe) {
    const auto& searched = (cone_ ? *cone_ : whole()).step().plant().components;
    const bool few = searched.size() < options_.components_for_plan;
    if (few || target.fastest || options_.cut_sets || !target.window.is_all()) return search(observe);
    std::optional<Witness> plan;
    const Meter::Milestone many_states(meter_, options_.states_before_plan, [&] {
      plan = planned(target);
      if (plan) throw AllowanceSpent{};
    });
    try {
      return search(observe);
    } catch (const AllowanceSpent&) {
      limit_ = Limit::plan;
      return plan;
    }
  }

  /// What the plant's reconfiguration would do may lead there where a search does not, or not soon. It was made for
  /// plants that are too large to search.
  std::optional<Witness> planned(const Target& target) {
    if (cone_) {
      const auto& wanted = std::get<Target>(cone_->wanted());
      auto run =
          planned_run(cone_->step().plant(), cone_->start().front(), wanted.formula, target.window, options_.period);
      std::optional<Witness> witness = run ? std::optional(cone_->out(std::move(*run))) : std::nullopt;
      if (witness && !failure_of(*witness)) return witness;
    }
    const Modes& start = slices_.start(options_.from).value();
    auto run = planned_run(slices_.plant(), start, target.formula, target.window, options_.period);
    return run && !failure_of(*run) ? std::move(run) : std::nullopt;
  }

  void look_for(const Response& response) {
    SearchScope& scope = cone_ ? *cone_ : whole();
    const Formula& asks = std::get<Response>(scope.wanted()).after;
    if (options_.slice && out_of_reach(scope.step(), asks, scope.from(), terms_.faults)) return;
    if (options_.slice && !options_.cut_sets && comes_in_its_part(slices_, response, terms_)) return;
    owed_ = &response;
    const Observe miss = [this](SearchScope& searched) { return missed(searched, terms_); };
    if (!response.within.is_infinite()) {
      witness_ = search(miss);
      return;
    }
    witness_ = search_with([this, &miss](SearchScope& searched) {
      auto found = search_in(searched, miss);
      return found ? std::move(found) : search_endless(searched, miss);
    });
  }

  /// A run that goes round without the response that it owes.
  std::optional<Witness> search_endless(SearchScope& scope, const Observe& observe) {
    PlantSystem system(scope.situations(), observe(scope), scope.symmetry(), scope.start());
    system.watch_progress();
    auto found = find_endless_run(system, meter_);
    if (!found) return std::nullopt;
    Witness witness = scope.out(std::move(*found));
    witness.owed_since = owed_since(judge(), *owed_, claim_terms(), witness);
    return witness;
  }

  void look_for(const Stuck&) {
    if (options_.slice && !options_.cut_sets && each_goes_on(slices_, terms_)) return;
    witness_ = search([](SearchScope&) { return Observer::end(); });
  }

  /// First the cone of influence alone: if it cannot reach the target, the plant cannot; and if the rest may stay as it
  /// is all the while, a path with fewest steps of the cone is one of the plant.
  std::optional<Witness> search(const Observe& observe) {
    return search_with([&](SearchScope& searched) { return search_in(searched, observe); });
  }

  /// The same for any way to search.
  std::optional<Witness> search_with(const std::function<std::optional<Witness>(SearchScope&)>& look) {
    if (cone_) {
      std::optional<Witness> witness = look(*cone_);
      if (!witness || !failure_of(*witness)) return witness;
    }
    std::optional<Witness> witness = look(whole());
    if (!witness) return std::nullopt;
    if (const auto failure = failure_of(*witness)) throw base::InternalError("a witness fails: " + *failure);
    return witness;
  }

  /// The rules for replays: a plant with a solver of its own, made where there is something to replay.
  automata::PlainStep& judge() {
    if (!judge_) judge_.emplace(slices_.plant());
    return *judge_;
  }

  [[nodiscard]] ClaimTerms claim_terms() const { return {options_.entailed, options_.period}; }

  /// Why the run is not possible in the plant or does not show what it is to show.
  [[nodiscard]] std::optional<std::string> failure_of(const Witness& witness) {
    if (auto failure = replay(judge(), witness, {options_.period, options_.commands, terms_.faults, options_.from})) {
      return failure;
    }
    return failure_to_show(judge(), property_, claim_terms(), witness);
  }

  std::optional<Witness> search_cut_sets(PlantSystem& system, SearchScope& scope) {
    if (terms_.time.is_dense()) {
      const auto fewer = fewer_steps(scope, scope.situations(), terms_.time);
      const auto first = search_cut_sets(system, scope, true);
      if (!first.in_doubt) return first.witness;
    }
    return search_cut_sets(system, scope, false).witness;
  }

  struct FirstCut {
    std::optional<Witness> witness;
    bool in_doubt;  ///< of one of them
  };

  /// `left_out`: steps that others make up for are. Ends with the first set that is in doubt, or that only the cone
  /// leads to: the whole plant is searched then.
  FirstCut search_cut_sets(PlantSystem& system, SearchScope& scope, bool left_out) {
    FaultSets sets;
    system.tell_faults_apart(sets);
    std::map<std::vector<Fault>, Witness> witnesses;
    std::optional<Witness> refused;
    bool in_doubt = false;
    const auto take = [&](const CutPath& cut) {
      in_doubt = left_out && is_in_doubt(cut.path);
      if (in_doubt) return false;
      Witness witness = witness_of(cut.path, system, scope);
      if (const auto failure = failure_of(witness)) {
        if (scope.is_whole()) throw base::InternalError("a witness fails: " + *failure);
        refused = std::move(witness);
        return false;
      }
      witnesses.emplace(cut.set.faults, std::move(witness));
      return true;
    };
    cut_sets_.clear();
    const CutPaths found = minimal_cut_sets(system, sets, meter_, take);
    if (in_doubt || refused) return {refused, in_doubt};
    for (const FaultSet& cut : found.sets) {
      cut_sets_.push_back({scope.out(cut.faults), std::move(witnesses.at(cut.faults))});
    }
    if (found.limit) throw LimitReached{*found.limit};
    return {cut_sets_.empty() ? std::nullopt : std::optional(cut_sets_.front().witness), false};
  }

  /// Found by fewer steps, a run that ends where time stands still: a step that was left out may be the answer that is
  /// owed. The path tells it, as the rest of the plant may be stuck where time stands still in the cone.
  [[nodiscard]] bool is_in_doubt(const std::vector<PathState>& path) const {
    const Phase phase = PlantSystem::phase_of(path.back().discrete);
    return owed_ != nullptr && (phase == Phase::still || phase == Phase::still_armed);
  }

  /// In dense time most questions are decided by the steps that nothing else makes up for; if they lead to the target,
  /// the fewest steps are looked for among all.
  std::optional<Witness> search_in(SearchScope& scope, const Observe& observe) {
    PlantSystem system(scope.situations(), observe(scope), scope.symmetry(), scope.start());
    const auto time_left = time_left_in(scope, system.observer(), terms_);
    if (time_left) system.leave_out_late(*time_left);
    if (options_.cut_sets) return search_cut_sets(system, scope);
    if (!system.observer().some_day()) {
      if (const auto cut_off = refuted_folded(scope, observe(scope), terms_)) {
        cut_off_ = *cut_off;
        return std::nullopt;
      }
    }
    std::optional<Witness> any;
    bool doubtful = false;
    if (terms_.time.is_dense() || options_.fewest_faults) {
      const auto fewer = fewer_steps(scope, scope.situations(), terms_.time);
      const auto path = any_path(system, options_.merge, meter_);
      if (path) any = witness_of(*path, system, scope);
      doubtful = path && is_in_doubt(*path);
      cut_off_ = system.cut_off();
      if (!any || (any_ && !doubtful)) return any;
    }
    try {
      const auto path = find_path(system, SearchOrder::fewest_steps, meter_);
      CHECK((path.has_value() || !any || doubtful) && "fewer steps lead where all do not");
      cut_off_ = system.cut_off();
      return path ? std::optional(witness_of(*path, system, scope)) : std::nullopt;
    } catch (const LimitReached& reached) {
      if (!any) throw;
      limit_ = reached.limit;
      return any;
    }
  }

  /// With how it is cut off, where that is what it shows.
  Witness witness_of(const std::vector<PathState>& path, PlantSystem& system, const SearchScope& scope) {
    Witness witness = scope.out(earliest_witness(path, system));
    const bool end = is_end(PlantSystem::phase_of(path.back().discrete));
    if (!end && system.observer().some_day()) {
      witness = resting(std::move(witness), slices_.plant(), terms_.time.ticks(terms_.time.grain()));
    }
    if (owed_ != nullptr) witness.owed_since = owed_since(judge(), *owed_, claim_terms(), witness);
    if (!end) return witness;
    const auto failure = explain_stop(judge(), witness, options_.commands, options_.period);
    if (failure && scope.is_whole()) throw base::InternalError("a witness fails: it is cut off, but " + *failure);
    if (owed_ != nullptr) witness.owed_since = owed_since(judge(), *owed_, claim_terms(), witness);
    return witness;
  }

  Slices& slices_;
  const CheckOptions& options_;
  bool any_ = false;
  const Property& property_;
  Wanted wanted_;
  Meter& meter_;
  SearchScope::Terms terms_;
  std::optional<SearchScope> cone_;           ///< where the rest can be left alone
  std::optional<SearchScope> whole_;          ///< made where the cone does not decide
  std::optional<automata::PlainStep> judge_;  ///< has no part in the search: it replays what that finds
  const Response* owed_ = nullptr;            ///< what a witness is to miss
  std::vector<CutSet> cut_sets_;
  CutOff cut_off_;                  ///< seen by the search that decided
  std::optional<Limit> limit_;      ///< what kept the best from being better
  std::optional<Witness> witness_;  ///< the best so far
};

}  // namespace

Answer check_once(Slices& slices, const Property& property, const CheckOptions& options, unsigned faults,
                  Meter& meter) {
  return Check(slices, property, options, faults, meter).run();
}

Answer check_for_any_witness(Slices& slices, const Property& property, const CheckOptions& options, unsigned faults,
                             Meter& meter) {
  return Check(slices, property, options, faults, meter).run_for_any_witness();
}

}  // namespace rmpl::verifier
