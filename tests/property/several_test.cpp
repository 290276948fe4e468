// Several properties at once against each by itself.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "verifier/plant/check.hpp"
#include "verifier/plant/check_all.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

verifier::CheckOptions draw_options() {
  verifier::CheckOptions options;
  options.faults = static_cast<unsigned>(up_to(0, 1));
  options.entailed = chance(20);
  if (chance(30)) options.period = Ticks::of_seconds(1);
  if (chance(30)) options.commands = verifier::Commands::any;
  return options;
}

verifier::Property draw_property(const automata::Plant& plant) {
  const auto formula = [&] { return *formulas(plant.variables, all_variables(plant), 1); };
  verifier::Window window;
  if (chance(20)) window.by = Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 4)));
  switch (up_to(0, 4)) {
    case 0:
      return verifier::Response{formula(), formula(), Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 4)))};
    case 1:
      return verifier::Reachability{formula(), window, chance(20)};
    default:
      return verifier::Safety{formula(), window, false};
  }
}

/// How many steps of a run change a mode.
std::size_t changes(const std::optional<verifier::Witness>& witness) {
  std::size_t count = 0;
  if (!witness) return count;
  const std::vector<verifier::Event>& events = witness->events;
  for (std::size_t i = 1; i < events.size(); ++i) count += events[i].modes != events[i - 1].modes;
  return count;
}

/// Then it is the time that is least, not the number of steps.
bool fastest(const verifier::Property& property) {
  const auto* reachability = std::get_if<verifier::Reachability>(&property);
  return reachability != nullptr && reachability->fastest;
}

RC_GTEST_PROP(SeveralProperties, AreEachByItself, ()) {
  const Model model = *models();
  std::vector<verifier::CheckOptions> options = {draw_options(), draw_options()};
  std::vector<verifier::Question> questions;
  const std::size_t count = up_to(1, 6);
  for (std::size_t q = 0; q < count; ++q) {
    questions.push_back({draw_property(model.plant), options[up_to(0, 1)]});
  }
  automata::PlantStep step(model.plant);
  const std::vector<verifier::Answer> together = verifier::check_all(step, questions, {});
  RC_ASSERT(together.size() == questions.size());
  for (std::size_t q = 0; q < count; ++q) {
    const verifier::Answer single = verifier::check(step, questions[q].property, questions[q].options, {});
    RC_ASSERT(together[q].verdict == single.verdict);
    RC_ASSERT(together[q].witness.has_value() == single.witness.has_value());
    if (!fastest(questions[q].property)) RC_ASSERT(changes(together[q].witness) == changes(single.witness));
  }
}

}  // namespace
}  // namespace rmpl::property
