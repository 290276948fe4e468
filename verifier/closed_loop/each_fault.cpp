// A table of what can come of each fault by itself.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/each_fault.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>

#include "automata/step/transition_rules.hpp"
#include "verifier/closed_loop/cause.hpp"
#include "verifier/closed_loop/searches.hpp"

namespace rmpl::verifier {

using Kind = ProgramProperty::Kind;

namespace {

/// Every fault transition that can be drawn by itself, in declaration order, each once. A mode that has a usual one
/// tells of a fault before.
std::vector<FaultStep> faults_of(const automata::Plant& plant, const std::vector<automata::ComponentId>& of) {
  std::vector<FaultStep> faults;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    if (!of.empty() && std::find(of.begin(), of.end(), automata::ComponentId(c)) == of.end()) continue;
    const automata::Component& component = plant.components[c];
    for (const automata::Transition& t : component.transitions) {
      if (component.modes[t.from.index()].usual) continue;
      if (component.is_fault(t) && t.from != t.to && t.weight.value > 0) {
        faults.push_back({automata::ComponentId(c), t.from, t.to});
      }
    }
  }
  std::sort(faults.begin(), faults.end());
  faults.erase(std::unique(faults.begin(), faults.end()), faults.end());
  return faults;
}

bool anything(const LoopState& /*state*/) { return true; }

/// Whether nominal transitions lead from the fault to a mode that is no fault.
bool is_repairable(const automata::Component& component, automata::ModeId fault) {
  std::vector<bool> met(component.modes.size());
  std::vector<automata::ModeId> open = {fault};
  while (!open.empty()) {
    const automata::ModeId mode = open.back();
    open.pop_back();
    if (!component.modes[mode.index()].fault) return true;
    if (met[mode.index()]) continue;
    met[mode.index()] = true;
    for (const automata::Transition& t : component.transitions) {
      if (t.from == mode && !component.is_fault(t) && automata::can_ever_be_taken(t)) open.push_back(t.to);
    }
  }
  return false;
}

using Planned = runtime::Reconfiguration::Outcome;

/// Whether the run ends in a cycle whose goal is without a plan.
bool lacks_plan(const Witness& witness) { return witness.events.back().cycle->outcome == Planned::no_plan; }

class Table {
 public:
  Table(const automata::Program& program, automata::PlantStep& step, const std::vector<Property>& properties,
        const CheckOptions& options, const Limits& limits, const std::vector<automata::ComponentId>& components)
      : program_(program),
        step_(step),
        properties_(of_programs(properties)),
        options_(options),
        components_(components),
        searches_(program, step, properties_, options, limits) {}

  FaultTable fill() {
    FaultTable result;
    result.rows.push_back({std::nullopt});
    for (const FaultStep& fault : faults_of(step_.plant(), components_)) result.rows.push_back({fault});
    searches_.allow_faults(1);
    try {
      searches_.startless();
      for (FaultOutcome& row : result.rows) fill(row);
    } catch (const LimitReached& reached) {
      result.limit = reached.limit;
    }
    result.progress = searches_.progress();
    return result;
  }

 private:
  void fill(FaultOutcome& row) {
    const FaultFilter only{true, row.fault};
    // Before anything is found: a limit leaves what was found until then.
    row.unending = row.fault && !ends_;
    if (row.fault) row.anyway = {.goes_on = goes_on_, .stops = stops_, .another = another_};
    if (row.fault) row.happens = searches_.search({.aim = Query::Aim::happens, .filter = only});
    if (row.happens || !row.fault) {
      row.success = searches_.search({.aim = Query::Aim::ends_with, .test = success_, .filter = only});
      if (!row.fault) {
        ends_ = row.success || searches_.search({.aim = Query::Aim::ends_with, .test = anything, .filter = only});
        row.unending = !ends_;
      }
      find_loss(row, only);
      row.no_plan = searches_.violation({Kind::no_plan}, only);
      find_wait(row, only);
      row.goes_on = searches_.lasso({.filter = only}, {Kind::termination});
      row.stops = searches_.violation({Kind::stuck}, only);
      row.another = searches_.search({.aim = Query::Aim::spent, .filter = only});
      if (row.fault && !ends_) row.unrepaired = is_unrepaired(*row.fault, only);
    }
    if (!row.fault) {
      succeeds_ = row.success.has_value();
      goes_on_ = row.goes_on.has_value();
      stops_ = row.stops.has_value();
      another_ = row.another.has_value();
    } else {
      row.costs_success = row.happens && succeeds_ && !row.success;
    }
    row.decided = true;
  }

  /// The first property of the mission that is violated; of a fault, rather one that holds without it.
  void find_loss(FaultOutcome& row, const FaultFilter& only) {
    for (std::size_t p = 0; p < properties_.size(); ++p) {
      const Kind kind = properties_[p].kind;
      const bool mission =
          kind == Kind::never || kind == Kind::eventually || kind == Kind::response || kind == Kind::finally;
      const bool anyway = row.fault && lost_.contains(p);
      if (!mission || (row.fault && row.lost && (anyway || !row.anyway.lost))) continue;
      auto loss = searches_.violation(properties_[p], only);
      if (!loss) continue;
      if (!row.fault) lost_.insert(p);
      if (row.lost && !row.fault) continue;
      row.lost = std::move(loss);
      row.anyway.lost = anyway;
    }
  }

  /// Whether the fault could be repaired, and no run on which it happens repairs it.
  bool is_unrepaired(const FaultStep& fault, const FaultFilter& only) {
    const automata::ComponentId component = fault.component;
    const automata::Component& automaton = step_.plant()[component];
    if (!is_repairable(automaton, fault.to)) return false;
    const auto repaired = [&](const LoopState& state) {
      return !automaton.modes[state.modes[component.index()].index()].fault;
    };
    return !searches_.search({.aim = Query::Aim::holds, .test = repaired, .filter = only});
  }

  /// A wait that never ends: rather one at a place of its own; and rather one for a goal without a plan, where the
  /// program has no end to come to.
  void find_wait(FaultOutcome& row, const FaultFilter& only) {
    const ProgramProperty wait{Kind::endless_wait};
    keep_wait(row, searches_.search({.aim = Query::Aim::endless_wait, .filter = only}, &wait));
    if (!row.waits) return;
    const std::array<std::pair<bool, bool>, 3> looks = {{{true, true}, {true, false}, {false, true}}};
    for (const auto& look : looks) {
      const auto [own, without_plan] = look;
      if ((own && !row.fault) || (without_plan && ends_)) continue;
      if ((!own || !row.anyway.waits) && (!without_plan || row.waits_without_plan)) break;
      const Query query{.aim = Query::Aim::endless_wait,
                        .filter = only,
                        .fresh = [this, look](const LoopState& state, const Turn& turn) {
                          const bool plan = turn.answer.outcome != Planned::no_plan;
                          return !(look.second && plan) &&
                                 !(look.first && is_known(waiting_cause(program_, state.marking), plan));
                        }};
      auto found = searches_.search(query, &wait);
      if (!found) continue;
      keep_wait(row, std::move(found));
      break;
    }
    if (!row.fault) find_places(only);
  }

  void keep_wait(FaultOutcome& row, std::optional<Witness> wait) {
    row.waits = std::move(wait);
    if (!row.waits) return;
    row.waits_without_plan = lacks_plan(*row.waits);
    row.anyway.waits = row.fault && is_known(causes_of(program_, *row.waits, false).front(), !row.waits_without_plan);
  }

  /// All places where the program waits for ever without a fault.
  void find_places(const FaultFilter& only) {
    const ProgramProperty wait{Kind::endless_wait};
    const Query query{
        .aim = Query::Aim::endless_wait, .filter = only, .fresh = [this](const LoopState& state, const Turn& turn) {
          const bool plan = turn.answer.outcome != Planned::no_plan;
          return !waits_.contains({waiting_cause(program_, state.marking), plan});
        }};
    while (const auto found = searches_.search(query, &wait)) {
      for (Cause& cause : causes_of(program_, *found, false)) waits_.insert({std::move(cause), !lacks_plan(*found)});
    }
  }

  /// Whether the program waits there for ever without a fault too, and is no better off.
  [[nodiscard]] bool is_known(const Cause& place, bool plan) const {
    return waits_.contains({place, false}) || (plan && waits_.contains({place, true}));
  }

  /// Whether every `finally` holds.
  std::function<bool(const LoopState&)> success() {
    std::vector<std::function<bool(const LoopState&)>> all;
    for (const ProgramProperty& property : properties_) {
      if (property.kind == Kind::finally) all.push_back(searches_.holds(property.formula, !options_.entailed));
    }
    return [all](const LoopState& state) {
      return std::all_of(all.begin(), all.end(), [&](const auto& test) { return test(state); });
    };
  }

  const automata::Program& program_;
  automata::PlantStep& step_;
  std::vector<ProgramProperty> properties_;
  const CheckOptions& options_;
  const std::vector<automata::ComponentId>& components_;
  Searches searches_;
  std::function<bool(const LoopState&)> success_ = success();
  // What comes without a fault.
  std::set<std::size_t> lost_;              ///< properties that are violated
  std::set<std::pair<Cause, bool>> waits_;  ///< where those that never end are, and whether there is a plan
  bool ends_ = false;                       ///< some run does
  bool succeeds_ = false, goes_on_ = false, stops_ = false, another_ = false;
};

}  // namespace

FaultTable check_each_fault(const automata::Program& program, automata::PlantStep& step,
                            const std::vector<Property>& properties, const CheckOptions& options, const Limits& limits,
                            const std::vector<automata::ComponentId>& components) {
  return Table(program, step, properties, options, limits, components).fill();
}

}  // namespace rmpl::verifier
