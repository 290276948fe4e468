// Initial distributions, checked.
// SPDX-License-Identifier: MIT
#include "compiler/lower/initial.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/check/domains.hpp"
#include "compiler/check/probabilities.hpp"
#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using grammar::Code;

std::optional<std::vector<double>> initial_distribution(const grammar::Initial& initial,
                                                        const automata::Component& component,
                                                        grammar::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  std::vector<std::string> names;
  for (const automata::Mode& mode : component.modes) names.push_back(mode.name);
  std::vector<double> distribution(component.modes.size(), 0);
  Uniqueness unique("initial mode", diagnostics);
  double sum = 0;
  for (const grammar::InitialMode& start : initial.modes) {
    if (!unique.add(start.mode)) continue;
    if (!start.probability && initial.modes.size() > 1) {
      diagnostics.error(
          Code::initial_distribution, start.span,
          "initial mode " + backquoted(start.mode.text) + " needs a probability, since there are several");
    }
    const double probability = start.probability ? start.probability->value : 1;
    if (start.probability) check_probability(*start.probability, diagnostics);
    sum += probability;
    const auto at = std::find(names.begin(), names.end(), start.mode.text);
    if (at == names.end()) {
      const std::size_t before = diagnostics.error_count();
      auto& error =
          diagnostics.error(Code::unknown_name, start.mode.span,
                            "component " + backquoted(component.type) + " has no mode " + backquoted(start.mode.text));
      suggest(error, before, start.mode.text, names);
    } else {
      distribution[static_cast<std::size_t>(at - names.begin())] = probability;
    }
  }
  if (diagnostics.error_count() != errors) return std::nullopt;
  if (sum > 1 + probability_tolerance) {
    diagnostics.error(Code::probabilities_exceed_one, initial.span,
                      "the initial probabilities sum to " + decimal(sum) + ", expected 1");
    return std::nullopt;
  }
  if (sum < 1 - probability_tolerance) {
    diagnostics.error(Code::initial_distribution, initial.span,
                      "the initial probabilities sum to " + decimal(sum) + ", expected 1");
    return std::nullopt;
  }
  return distribution;
}

}  // namespace rmpl::compiler
