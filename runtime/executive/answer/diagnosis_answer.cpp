// Diagnoses as JSON.
// SPDX-License-Identifier: MIT
#include "runtime/executive/answer/diagnosis_answer.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/error.hpp"

namespace rmpl::runtime {

std::string probability_text(const Diagnosis& diagnosis) {
  constexpr double tiny = 1e-300;
  if (diagnosis.probability >= tiny || !std::isfinite(diagnosis.log_probability)) {
    JsonLine number;
    number.number(diagnosis.probability);
    return std::string(number.text());
  }
  const double decimal = diagnosis.log_probability / std::numbers::ln10;
  const double exponent = std::floor(decimal);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.9ge%.0f", std::pow(10.0, decimal - exponent), exponent);
  return text.data();
}

void write(JsonLine& json, const automata::Plant& plant, const Diagnoses& found) {
  json.open('{').key("diagnoses").open('[');
  for (const Diagnosis& diagnosis : found.diagnoses) {
    json.open('{').key("probability").digits(probability_text(diagnosis)).key("modes").open('{');
    for (const auto& [component, mode] : diagnosis.faults) {
      json.key(plant[component].name).string(plant[component].modes[mode.index()].name);
    }
    json.close('}').close('}');
  }
  json.close(']').key("count").digits(found.count.str()).key("cardinality");
  if (found.cardinality) {
    json.number(*found.cardinality);
  } else {
    json.null();
  }
  json.key("checked").number(found.checked).key("seconds").number(found.seconds).close('}');
}

automata::Plant with_known(automata::Plant plant, const std::vector<automata::Assignment>& modes) {
  for (const automata::Assignment& known : modes) {
    const auto id = plant.component_of(known.variable);
    const std::string& name = plant.variables.name(known.variable);
    if (!id) throw base::InputError("--modes: '" + name + "' is an attribute; expected a component");
    automata::Component& component = plant.components[id->index()];
    if (component.modes[known.value.index()].fault) {
      throw base::InputError("--modes: '" + plant.variables.value(known) + "' is a fault mode of '" + name +
                             "'; expected the nominal mode that it is in unless it is at fault");
    }
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      automata::Mode& other = component.modes[m];
      if (m != known.value.index() && !other.fault) other.constraint = automata::constant(false);
    }
  }
  return plant;
}

}  // namespace rmpl::runtime
