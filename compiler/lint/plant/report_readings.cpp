// Told: values of sensors that no mode explains. A reading of such a value contradicts every state, so that the
// estimator sets it aside.
// SPDX-License-Identifier: MIT
#include <map>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::ValueId;
using automata::VariableId;

namespace {

/// The values of an observed variable that no state has, with components in the modes that they reach.
std::vector<std::string> unexplained(PlantReport& report, VariableId variable) {
  std::vector<std::string> values;
  const automata::Variable& read = report.plant().variables[variable];
  for (std::size_t v = 0; v < read.values.size(); ++v) {
    const Assignment reading{variable, ValueId(v)};
    if (!report.analysis().questions().possible({&reading, 1})) values.push_back(backquoted(read.values[v]));
  }
  return values;
}

}  // namespace

void report_readings(PlantReport& report) {
  struct Told {
    std::string first;  ///< the variable
    std::vector<std::string> values;
    std::size_t more = 0;  ///< instances with the same
  };
  std::map<grammar::Span, Told> by_place;
  std::map<std::string, grammar::Span> place_of;
  for (const PlantAttribute& attribute : report.declarations().attributes)
    place_of.emplace(attribute.name, attribute.span);
  for (const VariableId variable : report.plant().observables) {
    const std::string& name = report.plant().variables.name(variable);
    const auto place = place_of.find(name);
    if (place == place_of.end()) continue;
    std::vector<std::string> values = unexplained(report, variable);
    if (values.empty()) continue;
    const auto [at, fresh] = by_place.emplace(place->second, Told{name, std::move(values), 0});
    if (!fresh) ++at->second.more;
  }
  for (const auto& [span, told] : by_place) {
    auto& finding = report.add(grammar::Code::unexplained_reading, span,
                               "no state of the plant explains that " + backquoted(told.first) + " reads " +
                                   enumerated(told.values, 3) +
                                   (told.more == 0 ? "" : ", and the same is true of others of its type") +
                                   ": the estimate sets such a reading aside");
    finding.suggestion =
        "add a fault mode without a constraint, such as `fault unknown;`, with a small rate, or remove the value from "
        "the domain";
  }
}

}  // namespace rmpl::compiler
