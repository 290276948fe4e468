// Initial distributions, checked.
// SPDX-License-Identifier: MIT
#include "compiler/lower/initial.hpp"

#include <algorithm>

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
  const grammar::Number certain{initial.span, "1", 1};
  std::vector<const grammar::Number*> numbers;
  std::vector<std::size_t> modes;  // of the numbers
  for (const grammar::InitialMode& start : initial.modes) {
    if (!unique.add(start.mode)) continue;
    if (!start.probability && initial.modes.size() > 1) {
      diagnostics.error(
          Code::initial_distribution, start.span,
          "initial mode " + backquoted(start.mode.text) + " needs a probability, since there are several");
    }
    const auto at = std::find(names.begin(), names.end(), start.mode.text);
    if (at == names.end()) {
      const std::size_t before = diagnostics.error_count();
      auto& error =
          diagnostics.error(Code::unknown_name, start.mode.span,
                            "component " + backquoted(component.type) + " has no mode " + backquoted(start.mode.text));
      suggest(error, before, start.mode.text, names);
    }
    numbers.push_back(start.probability ? &*start.probability : &certain);
    modes.push_back(static_cast<std::size_t>(at - names.begin()));
  }
  if (diagnostics.error_count() != errors) return std::nullopt;
  const auto probabilities =
      probabilities_of(numbers, initial.span, Code::initial_distribution, "initial", diagnostics);
  if (!probabilities) return std::nullopt;
  for (std::size_t m = 0; m < modes.size(); ++m) distribution[modes[m]] = (*probabilities)[m];
  return distribution;
}

}  // namespace rmpl::compiler
