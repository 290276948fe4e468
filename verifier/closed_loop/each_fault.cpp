// A table of what can come of each fault by itself.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/each_fault.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "verifier/closed_loop/cause.hpp"
#include "verifier/closed_loop/searches.hpp"

namespace rmpl::verifier {

using Aim = Query::Aim;
using Kind = ProgramProperty::Kind;

namespace {

/// Every fault transition that can be drawn, in declaration order, each once.
std::vector<FaultStep> faults_of(const automata::Plant& plant) {
  std::vector<FaultStep> faults;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const automata::Component& component = plant.components[c];
    for (const automata::Transition& t : component.transitions) {
      if (component.is_fault(t) && t.from != t.to && t.weight.value > 0) {
        faults.push_back({automata::ComponentId(c), t.from, t.to});
      }
    }
  }
  std::sort(faults.begin(), faults.end());
  faults.erase(std::unique(faults.begin(), faults.end()), faults.end());
  return faults;
}

bool anything(const automata::Modes& /*modes*/) { return true; }

class Table {
 public:
  Table(const automata::Program& program, automata::PlantStep& step, const std::vector<Property>& properties,
        const CheckOptions& options, const Limits& limits)
      : program_(program),
        step_(step),
        properties_(of_programs(properties)),
        options_(options),
        searches_(program, step, properties_, options, limits) {}

  FaultTable fill() {
    FaultTable result;
    result.rows.push_back({std::nullopt});
    for (const FaultStep& fault : faults_of(step_.plant())) result.rows.push_back({fault});
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
    if (row.fault) row.anyway = {.goes_on = goes_on_, .stops = stops_, .another = another_};
    if (row.fault) row.happens = searches_.search({.aim = Aim::happens, .filter = only});
    if (row.happens || !row.fault) {
      row.success = searches_.search({.aim = Aim::ends_with, .test = success_, .filter = only});
      if (!row.fault) {
        ends_ = row.success || searches_.search({.aim = Aim::ends_with, .test = anything, .filter = only});
        row.anyway.goes_on = !ends_;
      }
      find_loss(row, only);
      row.no_plan = searches_.violation({Kind::no_plan}, only);
      find_wait(row, only);
      row.goes_on = searches_.lasso(only, {Kind::termination});
      row.stops = searches_.violation({Kind::stuck}, only);
      row.another = searches_.search({.aim = Aim::spent, .filter = only});
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

  /// A wait that never ends, rather one that is the row's own: at locations at which nothing waits for ever without the
  /// fault; and where the program never ends, so that to rest is no fault, for a goal without a plan.
  void find_wait(FaultOutcome& row, const FaultFilter& only) {
    const ProgramProperty wait{Kind::endless_wait};
    auto any = searches_.violation(wait, only);
    if (!any) return;
    Query query{.aim = Aim::endless_wait, .filter = only, .fresh = [this](const LoopState& state, const Turn& turn) {
                  const bool counts = ends_ || turn.answer.outcome == runtime::Reconfiguration::Outcome::no_plan;
                  return counts && !waits_.contains(waiting_cause(program_, state.marking));
                }};
    auto own = searches_.search(query, &wait);
    row.anyway.waits = !own;
    row.waits = own ? own : std::move(any);
    if (row.fault) return;
    for (; own; own = searches_.search(query, &wait)) {
      for (Cause& cause : causes_of(program_, *own, false)) waits_.insert(std::move(cause));
    }
  }

  /// Whether every `finally` holds.
  std::function<bool(const automata::Modes&)> success() {
    std::vector<std::function<bool(const automata::Modes&)>> all;
    for (const ProgramProperty& property : properties_) {
      if (property.kind == Kind::finally) all.push_back(searches_.holds(property.formula, !options_.entailed));
    }
    return [all](const automata::Modes& modes) {
      return std::all_of(all.begin(), all.end(), [&](const auto& test) { return test(modes); });
    };
  }

  const automata::Program& program_;
  automata::PlantStep& step_;
  std::vector<ProgramProperty> properties_;
  const CheckOptions& options_;
  Searches searches_;
  std::function<bool(const automata::Modes&)> success_ = success();
  // What comes without a fault.
  std::set<std::size_t> lost_;  ///< properties that are violated
  std::set<Cause> waits_;       ///< all of those that never end
  bool ends_ = false;           ///< some run does
  bool succeeds_ = false, goes_on_ = false, stops_ = false, another_ = false;
};

}  // namespace

FaultTable check_each_fault(const automata::Program& program, automata::PlantStep& step,
                            const std::vector<Property>& properties, const CheckOptions& options,
                            const Limits& limits) {
  return Table(program, step, properties, options, limits).fill();
}

}  // namespace rmpl::verifier
