// Several properties at once against each by itself.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "verifier/check/check.hpp"
#include "verifier/check/check_all.hpp"
#include "verifier/closed_loop/check_all.hpp"
#include "verifier/verdict/question_json.hpp"
#include "verifier/verdict/wording.hpp"

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

/// What failed, to be asked again by the command line.
void log(const Model& model, const verifier::Question& question, std::string_view how, const verifier::Answer& answer) {
  RC_LOG() << verifier::question_json(model.plant, question).dump() << ' ' << how << ": "
           << verifier::to_text(answer.verdict) << '\n';
}

/// Whether runs are cut off that it does not follow to the end.
bool is_partial(const verifier::Answer& answer) { return answer.cut_off.ends() || answer.cut_off.spent; }

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
  verifier::Slices slices(model.plant);
  const std::vector<verifier::Answer> together = verifier::check_all(slices, questions, {});
  RC_ASSERT(together.size() == questions.size());
  for (std::size_t q = 0; q < count; ++q) {
    const verifier::Answer single = verifier::check(slices, questions[q].property, questions[q].options, {});
    log(model, questions[q], "together", together[q]);
    log(model, questions[q], "alone", single);
    RC_ASSERT(together[q].verdict == single.verdict);
    RC_ASSERT(is_partial(together[q]) == is_partial(single));
    RC_ASSERT(together[q].witness.has_value() == single.witness.has_value());
    if (!fastest(questions[q].property)) RC_ASSERT(changes(together[q].witness) == changes(single.witness));
  }
}

RC_GTEST_PROP(SeveralProperties, AreTheSameByThreads, ()) {
  Shape shape;
  shape.max_components = 3;
  const Model model = *models(shape);
  const std::size_t count = up_to(2, 6);
  std::vector<verifier::Question> questions;
  for (std::size_t q = 0; q < count; ++q) questions.push_back({draw_property(model.plant), draw_options()});
  verifier::Slices slices(model.plant);
  const auto one = verifier::check_all({model.plant}, slices, questions, {});
  const auto several = verifier::check_all({model.plant}, slices, questions, {}, up_to(2, 4));
  RC_ASSERT(one.size() == several.size());
  for (std::size_t q = 0; q < count; ++q) {
    log(model, questions[q], "by one thread", one[q]);
    log(model, questions[q], "by several", several[q]);
    RC_ASSERT(one[q].verdict == several[q].verdict);
    RC_ASSERT(one[q].progress.states == several[q].progress.states);
    RC_ASSERT(changes(one[q].witness) == changes(several[q].witness));
  }
}

/// Two halves have nothing to do with each other, now and then.
RC_GTEST_PROP(SeveralProperties, CanBeSliced, ()) {
  Shape half;
  half.max_components = 2;
  half.max_attributes = 3;
  half.tangled = chance(50);
  const Model model = *mirrored(half);
  verifier::CheckOptions options = draw_options();
  options.cut_sets = chance(20);
  const verifier::Property property = draw_property(model.plant);
  verifier::Slices slices(model.plant);
  const verifier::Answer sliced = verifier::check(slices, property, options, {});
  log(model, {property, options}, "sliced", sliced);
  options.slice = false;
  const verifier::Answer whole = verifier::check(slices, property, options, {});
  log(model, {property, options}, "whole", whole);
  RC_ASSERT(sliced.startless == whole.startless);
  // Of what has no influence on the question it is taken that it can go on: only the whole is cut off by it.
  if (whole.witness && whole.witness->stop) return;
  RC_ASSERT(sliced.witness.has_value() == whole.witness.has_value());
  if (!options.cut_sets && !fastest(property)) RC_ASSERT(changes(sliced.witness) == changes(whole.witness));
  if (!options.cut_sets && fastest(property) && whole.witness) {
    RC_ASSERT(sliced.witness->events.back().time == whole.witness->events.back().time);
  }
  RC_ASSERT(sliced.cut_sets.size() == whole.cut_sets.size());
  for (std::size_t i = 0; i < whole.cut_sets.size(); ++i) {
    RC_ASSERT(sliced.cut_sets[i].faults == whole.cut_sets[i].faults);
  }
  // Where time stands still in what has been left alone, more is decided.
  if (whole.cut_off.still || sliced.cut_off.still) return;
  RC_ASSERT(sliced.verdict == whole.verdict);
  if (std::holds_alternative<verifier::Safety>(property)) RC_ASSERT(sliced.vacuous == whole.vacuous);
}

}  // namespace
}  // namespace rmpl::property
