// A table of what can come of each fault by itself.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/each_fault.hpp"

#include <algorithm>
#include <functional>

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

class Table {
 public:
  Table(const automata::Program& program, automata::PlantStep& step, const std::vector<Property>& properties,
        const CheckOptions& options, const Limits& limits)
      : step_(step),
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
      for (FaultOutcome& row : result.rows) {
        fill(row);
        const FaultOutcome& without = result.rows.front();
        if (!row.fault) continue;
        row.anyway = {without.lost.has_value(), without.waits.has_value(), without.goes_on.has_value(),
                      without.stops.has_value()};
      }
    } catch (const LimitReached& reached) {
      result.limit = reached.limit;
    }
    result.progress = searches_.progress();
    return result;
  }

 private:
  void fill(FaultOutcome& row) {
    const FaultFilter only{true, row.fault};
    if (row.fault) row.happens = searches_.search({.aim = Aim::happens, .filter = only});
    if (row.happens || !row.fault) {
      row.success = searches_.search({.aim = Aim::ends_with, .test = success_, .filter = only});
      for (const ProgramProperty& property : properties_) {
        const bool mission = property.kind == Kind::never || property.kind == Kind::eventually ||
                             property.kind == Kind::response || property.kind == Kind::finally;
        if (mission && !row.lost) row.lost = searches_.violation(property, only);
      }
      row.no_plan = searches_.violation({Kind::no_plan}, only);
      row.waits = searches_.violation({Kind::endless_wait}, only);
      row.goes_on = searches_.lasso(only, {Kind::termination});
      row.stops = searches_.violation({Kind::stuck}, only);
    }
    row.decided = true;
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

  automata::PlantStep& step_;
  std::vector<ProgramProperty> properties_;
  const CheckOptions& options_;
  Searches searches_;
  std::function<bool(const automata::Modes&)> success_ = success();
};

}  // namespace

FaultTable check_each_fault(const automata::Program& program, automata::PlantStep& step,
                            const std::vector<Property>& properties, const CheckOptions& options,
                            const Limits& limits) {
  return Table(program, step, properties, options, limits).fill();
}

}  // namespace rmpl::verifier
