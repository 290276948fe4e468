// The verifier's symbolic search against explicit search, tick by tick, in both readings of time.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/rounds.hpp"
#include "tests/reference/reachability.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

struct Drawn {
  reference::Question question;
  verifier::CheckOptions options;
};

Drawn draw_question(const automata::Plant& plant) {
  Drawn drawn;
  drawn.question.target = chance(30) ? *formulas(plant.variables, all_variables(plant), 1)
                                     : automata::conjunction_of(reference::assumptions_of(plant, *modes_of(plant)));
  drawn.question.entailed = drawn.options.entailed = chance(30);
  drawn.question.faults = up_to(0, 2);
  drawn.options.faults = static_cast<unsigned>(drawn.question.faults);
  drawn.options.merge = chance(80);
  switch (up_to(0, 3)) {
    case 0:
      drawn.question.commands = reference::Question::Commands::none;
      drawn.options.commands = verifier::Commands::none;
      break;
    case 1:
      drawn.question.commands = reference::Question::Commands::any;
      drawn.options.commands = verifier::Commands::any;
      break;
    default:
      break;
  }
  return drawn;
}

Shape drawn_shape() {
  Shape shape;
  shape.tangled = chance(50);
  return shape;
}

/// How many steps of a run change a mode.
std::size_t changes(const verifier::Witness& witness) {
  std::size_t count = 0;
  const std::vector<verifier::Event>& events = witness.events;
  for (std::size_t i = 1; i < events.size(); ++i) count += events[i].modes != events[i - 1].modes;
  return count;
}

/// What comes of no witness: where time stands still, what would follow cannot be told.
verifier::Verdict without_witness(const verifier::Answer& answer, verifier::Verdict otherwise) {
  return answer.cut_off.still ? verifier::Verdict::undecided : otherwise;
}

/// A search that gives up at once has the plan of the plant's reconfiguration, where that is a run that is asked about.
void compare_planned(const Model& model, const Drawn& drawn, const std::optional<std::size_t>& fewest) {
  verifier::Slices slices(model.plant);
  verifier::Limits limits;
  limits.states = 1;
  const verifier::Answer planned = verifier::check(
      slices, verifier::Reachability{.target = drawn.question.target, .window = {}}, drawn.options, limits);
  if (!planned.witness) return;
  RC_ASSERT(planned.verdict == verifier::Verdict::holds);
  RC_ASSERT(fewest && changes(*planned.witness) >= *fewest);
}

void compare(const Model& model, const Drawn& drawn, const std::optional<std::size_t>& fewest) {
  verifier::Slices slices(model.plant);
  const verifier::Answer reached =
      verifier::check(slices, verifier::Reachability{.target = drawn.question.target, .window = {}}, drawn.options, {});
  RC_ASSERT(reached.witness.has_value() == fewest.has_value());
  RC_ASSERT(reached.verdict ==
            (fewest ? verifier::Verdict::holds : without_witness(reached, verifier::Verdict::violated)));
  if (fewest) RC_ASSERT(changes(*reached.witness) == *fewest);
  compare_planned(model, drawn, fewest);

  const verifier::Answer safe =
      verifier::check(slices, verifier::Safety{.never = drawn.question.target, .window = {}}, drawn.options, {});
  RC_ASSERT(safe.verdict == (fewest ? verifier::Verdict::violated : without_witness(safe, verifier::Verdict::holds)));
}

using Fewest = std::function<std::optional<std::size_t>(const reference::Question&)>;

void compare_response(const Model& model, const Drawn& drawn, const Fewest& fewest) {
  verifier::Slices slices(model.plant);
  const reference::Response& asked = *drawn.question.response;
  const verifier::Response property{asked.after, asked.then, asked.within};
  const verifier::Answer result = verifier::check(slices, property, drawn.options, {});
  RC_LOG() << "after " << to_text(asked.after, model.plant.variables) << "\nthen "
           << to_text(asked.then, model.plant.variables) << "\nwithin " << automata::format_seconds(asked.within)
           << " s\nfaults " << drawn.options.faults.value_or(0) << ", commands "
           << static_cast<int>(drawn.options.commands) << ", merge " << drawn.options.merge << '\n';
  std::optional<std::size_t> missed = fewest(drawn.question);
  if (missed && !result.witness) {
    // A cone is taken to be able to go on where the rest of the plant is stuck.
    verifier::CheckOptions whole = drawn.options;
    whole.slice = false;
    RC_ASSERT(verifier::check(slices, property, whole, {}).witness.has_value());
    reference::Question going_on = drawn.question;
    going_on.response->stuck_misses = false;
    missed = fewest(going_on);
  }
  // Where time stands still while an answer is owed, none comes, but no deadline either.
  if (!missed && result.witness && result.witness->stop && result.witness->stop->still) return;
  RC_ASSERT(result.witness.has_value() == missed.has_value());
  RC_ASSERT(result.verdict ==
            (missed ? verifier::Verdict::violated : without_witness(result, verifier::Verdict::holds)));
}

void compare_stuck(const Model& model, const Drawn& drawn) {
  verifier::Slices slices(model.plant);
  const verifier::Answer result = verifier::check(slices, verifier::Stuck{}, drawn.options, {});
  const reference::Step slow(model.plant);
  const bool stops =
      reference::comes_to_a_stop(slow, drawn.question, drawn.options.period, Ticks{Ticks::per_second / 2});
  RC_CLASSIFY(stops);
  RC_ASSERT(result.verdict == (stops ? verifier::Verdict::violated : verifier::Verdict::holds));
}

/// Whether all that can be come to can be come to at whole seconds, where all bounds are. A timed fault that is certain
/// holds up what others do within its bounds: what lies outside is open, and no grid has all of it.
bool whole_seconds_suffice(const automata::Plant& plant) {
  for (const automata::Component& component : plant.components) {
    std::vector<double> certain(component.modes.size());
    for (const automata::Transition& t : component.transitions) {
      const bool drawn = t.weight.kind == automata::Weight::Kind::probability;
      if (component.is_fault(t) && t.timing && drawn) certain[t.from.index()] += t.weight.value;
    }
    if (std::any_of(certain.begin(), certain.end(), [](double sum) { return sum >= 1; })) return false;
  }
  return true;
}

Drawn draw_response(const automata::Plant& plant) {
  Drawn drawn = draw_question(plant);
  const auto formula = [&] { return *formulas(plant.variables, all_variables(plant), 0); };
  drawn.question.response = {formula(), formula(), Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 4)))};
  return drawn;
}

RC_GTEST_PROP(Reachability, DenseResponseIsTheGrid, ()) {
  const Model model = *models(drawn_shape());
  RC_PRE(whole_seconds_suffice(model.plant));
  const Drawn drawn = draw_response(model.plant);
  const reference::Step slow(model.plant);
  compare_response(model, drawn,
                   [&](const auto& q) { return reference::fewest_steps_dense(slow, q, Ticks::of_seconds(1)); });
}

RC_GTEST_PROP(Reachability, SampledResponseIsTheTicks, ()) {
  const Model model = *models(drawn_shape());
  Drawn drawn = draw_response(model.plant);
  const Ticks period = pick<Ticks>({{Ticks::per_second}, {Ticks::per_second / 2}, {3 * Ticks::per_second / 4}});
  drawn.options.period = period;
  const reference::Step slow(model.plant);
  compare_response(model, drawn, [&](const auto& q) { return reference::fewest_steps_sampled(slow, q, period); });
}

/// What may come some day, beside all runs that never bring it. Where time stands still while it is owed it does not
/// come, which no run of the twin tells.
void compare_some_day(const Model& model, Drawn drawn) {
  drawn.question.response->within = Ticks::infinite();
  const reference::Response& asked = *drawn.question.response;
  const verifier::Response property{asked.after, asked.then, asked.within};
  const reference::Step slow(model.plant);
  const Ticks unit{Ticks::per_second / 2};
  const bool never = reference::never_answers(slow, drawn.question, drawn.options.period, unit);
  RC_LOG() << "after " << to_text(asked.after, model.plant.variables) << "\nthen "
           << to_text(asked.then, model.plant.variables) << "\nfaults " << drawn.options.faults.value_or(0)
           << ", commands " << static_cast<int>(drawn.options.commands) << ", never answered: " << never << '\n';
  verifier::Slices slices(model.plant);
  const verifier::Answer parts = verifier::check(slices, property, drawn.options, {});
  drawn.options.slice = false;
  const verifier::Answer whole = verifier::check(slices, property, drawn.options, {});
  const auto stands_still = [](const verifier::Answer& answer) {
    return answer.cut_off.still || (answer.witness && answer.witness->stop && answer.witness->stop->still);
  };
  RC_CLASSIFY(never);
  RC_CLASSIFY(whole.witness && whole.witness->repeats_from);
  if (stands_still(whole) || stands_still(parts)) return;
  RC_ASSERT(whole.verdict == (never ? verifier::Verdict::violated : verifier::Verdict::holds));
  if (parts.verdict == whole.verdict) return;
  // A cone is taken to be able to go on where the rest of the plant is stuck, or is not looked at as a fault is
  // certain.
  RC_ASSERT(reference::comes_to_a_stop(slow, drawn.question, drawn.options.period, unit) ||
            reference::exceeds_faults(slow, drawn.question, drawn.options.period, unit));
}

RC_GTEST_PROP(Reachability, DenseLeadsToIsTheGrid, ()) {
  const Model model = *models(drawn_shape());
  RC_PRE(whole_seconds_suffice(model.plant));
  compare_some_day(model, draw_response(model.plant));
}

RC_GTEST_PROP(Reachability, SampledLeadsToIsTheTicks, ()) {
  const Model model = *models(drawn_shape());
  Drawn drawn = draw_response(model.plant);
  drawn.options.period = pick<Ticks>({{Ticks::per_second}, {3 * Ticks::per_second / 4}});
  compare_some_day(model, drawn);
}

RC_GTEST_PROP(Reachability, DenseIsTheGrid, ()) {
  const Model model = *models(drawn_shape());
  RC_PRE(whole_seconds_suffice(model.plant));
  const Drawn drawn = draw_question(model.plant);
  const reference::Step slow(model.plant);
  compare(model, drawn, reference::fewest_steps_dense(slow, drawn.question, Ticks::of_seconds(1)));
}

/// Small halves: the twin explores their product.
constexpr Shape half{.max_components = 2, .max_modes = 3, .max_attributes = 3, .densities = false};

RC_GTEST_PROP(Reachability, SymmetricDenseIsTheGrid, ()) {
  const Model model = *mirrored(half);
  RC_PRE(whole_seconds_suffice(model.plant));
  const Drawn drawn = draw_question(model.plant);
  const reference::Step slow(model.plant);
  compare(model, drawn, reference::fewest_steps_dense(slow, drawn.question, Ticks::of_seconds(1)));
}

RC_GTEST_PROP(Reachability, SymmetricDenseResponseIsTheGrid, ()) {
  const Model model = *mirrored(half);
  RC_PRE(whole_seconds_suffice(model.plant));
  const Drawn drawn = draw_response(model.plant);
  const reference::Step slow(model.plant);
  compare_response(model, drawn,
                   [&](const auto& q) { return reference::fewest_steps_dense(slow, q, Ticks::of_seconds(1)); });
}

RC_GTEST_PROP(Reachability, SymmetricSampledIsTheTicks, ()) {
  const Model model = *mirrored(half);
  Drawn drawn = draw_question(model.plant);
  drawn.options.period = Ticks::of_seconds(1);
  const reference::Step slow(model.plant);
  compare(model, drawn, reference::fewest_steps_sampled(slow, drawn.question, Ticks::of_seconds(1)));
}

/// Few states, as time is counted in halves.
constexpr Shape tangled{.max_components = 2, .max_modes = 3, .max_attributes = 3, .densities = false, .tangled = true};

RC_GTEST_PROP(Reachability, DenseStopsAreThoseOfTheGrid, ()) {
  const Model model = chance(70) ? *models(tangled) : *mirrored({.max_components = 1, .tangled = true});
  compare_stuck(model, draw_question(model.plant));
}

RC_GTEST_PROP(Reachability, SampledStopsAreThoseOfTheTicks, ()) {
  const Model model = chance(70) ? *models(drawn_shape()) : *mirrored(half);
  Drawn drawn = draw_question(model.plant);
  drawn.options.period = pick<Ticks>({{Ticks::per_second}, {3 * Ticks::per_second / 4}});
  compare_stuck(model, drawn);
}

/// Whether runs get stuck once the bounds of some components are a little later, as cycles make them where untimed
/// steps led there: several timers come to one instant, and the cycle decides which is due first.
bool rests_on_an_instant(const automata::Plant& plant, const verifier::CheckOptions& options) {
  const Ticks later{Ticks::per_second / 64};
  for (std::size_t some = 1; some < std::size_t{1} << plant.components.size(); ++some) {
    automata::Plant shifted = plant;
    for (std::size_t c = 0; c < plant.components.size(); ++c) {
      for (automata::Transition& t : shifted.components[c].transitions) {
        if ((some >> c) % 2 == 0 || !t.timing) continue;
        t.timing->lower = t.timing->lower + later;
        if (!t.timing->upper.is_infinite()) t.timing->upper = t.timing->upper + later;
      }
    }
    verifier::Slices slices(shifted);
    if (verifier::check(slices, verifier::Stuck{}, options, {}).verdict == verifier::Verdict::violated) return true;
  }
  return false;
}

/// A dense proof is about the limit of ever shorter cycles: cycles that are short against all bounds, of which the
/// least is a second, bear it out, unless it rests on one instant, or on rounds that take no time, or ends at a certain
/// fault: one that is so at a reading of 0 alone comes in no cycle. Commands are left out, as they are held in cycles
/// alone.
RC_GTEST_PROP(Reachability, ShortCyclesBearOutThatNothingGetsStuck, ()) {
  const Model model = *models(tangled);
  Drawn drawn = draw_question(model.plant);
  drawn.options.commands = verifier::Commands::none;
  verifier::Slices slices(model.plant);
  const auto ask = [&](std::optional<Ticks> period) {
    drawn.options.period = period;
    return verifier::check(slices, verifier::Stuck{}, drawn.options, {});
  };
  const verifier::Answer dense = ask(std::nullopt);
  RC_CLASSIFY(dense.witness.has_value());
  for (const Ticks cycle : {Ticks{Ticks::per_second / 8}, Ticks{Ticks::per_second / 1000}}) {
    const verifier::Answer sampled = ask(cycle);
    RC_CLASSIFY(sampled.witness.has_value());
    RC_LOG() << "cycle " << automata::format_seconds(cycle) << " s" << std::endl;
    if (dense.verdict != verifier::Verdict::holds || dense.cut_off.spent) continue;
    drawn.options.period.reset();
    RC_ASSERT(sampled.verdict == verifier::Verdict::holds || goes_round_at_once(model.plant) ||
              rests_on_an_instant(model.plant, drawn.options));
  }
}

/// More components than the twin can explore: states that are put together change no verdict and no number of steps.
RC_GTEST_PROP(Reachability, MergingChangesNothing, ()) {
  Shape shape{.max_components = 5, .max_modes = 4, .max_attributes = 5};
  shape.tangled = chance(30);
  const Model model = *models(shape);
  Drawn drawn = chance(20) ? draw_response(model.plant) : draw_question(model.plant);
  if (chance(20)) drawn.options.period = Ticks::of_seconds(1);
  verifier::Property property = verifier::Stuck{};
  if (drawn.question.response) {
    const reference::Response& asked = *drawn.question.response;
    property = verifier::Response{asked.after, asked.then, asked.within};
  } else if (chance(90)) {
    verifier::Reachability asked{.target = drawn.question.target, .window = {}};
    if (chance(30)) asked.window.by = Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 6)));
    property = asked;
  }
  verifier::Slices slices(model.plant);
  verifier::Limits limits;
  limits.states = 20000;
  verifier::CheckOptions options = drawn.options;
  options.merge = false;
  const verifier::Answer apart = verifier::check(slices, property, options, limits);
  options.merge = true;
  const verifier::Answer merged = verifier::check(slices, property, options, limits);
  RC_PRE(!apart.limit && !merged.limit);
  RC_CLASSIFY(apart.witness.has_value());
  RC_ASSERT(merged.verdict == apart.verdict);
  RC_ASSERT(merged.witness.has_value() == apart.witness.has_value());
  RC_ASSERT(merged.cut_off.stuck == apart.cut_off.stuck);
  if (apart.witness) RC_ASSERT(changes(*merged.witness) == changes(*apart.witness));
}

using Faults = std::vector<verifier::Fault>;

/// The plant with no transitions into other fault modes than these.
automata::Plant with_faults(automata::Plant plant, const Faults& faults) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& component = plant.components[c];
    std::erase_if(component.transitions, [&](const automata::Transition& t) {
      return component.is_fault(t) && t.from != t.to &&
             std::count(faults.begin(), faults.end(), verifier::Fault{automata::ComponentId(c), t.to}) == 0;
    });
  }
  return plant;
}

/// Without faults that are certain: leaving one out would otherwise make nominal transitions possible.
automata::Plant with_unlikely_faults(automata::Plant plant) {
  for (auto& component : plant.components) {
    for (auto& t : component.transitions) {
      if (component.is_fault(t)) t.weight = {automata::Weight::Kind::probability, 0.001};
    }
  }
  return plant;
}

Faults all_faults(const automata::Plant& plant) {
  Faults result;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      if (plant.components[c].modes[m].fault) result.push_back({automata::ComponentId(c), automata::ModeId(m)});
    }
  }
  return result;
}

/// The minimal sets of up to two faults, by trying each.
std::vector<Faults> minimal_sets(const automata::Plant& plant, reference::Question question) {
  question.faults = 2;
  const Faults all = all_faults(plant);
  std::vector<Faults> candidates = {{}};
  for (const auto& f : all) candidates.push_back({f});
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) candidates.push_back({all[a], all[b]});
  }
  std::vector<Faults> found;
  for (const Faults& candidate : candidates) {
    const bool minimal = std::none_of(found.begin(), found.end(), [&](const Faults& f) {
      return std::includes(candidate.begin(), candidate.end(), f.begin(), f.end());
    });
    if (!minimal) continue;
    const automata::Plant less = with_faults(plant, candidate);
    if (reference::fewest_steps_dense(reference::Step(less), question, Ticks::of_seconds(1)))
      found.push_back(candidate);
  }
  return found;
}

RC_GTEST_PROP(Reachability, CutSetsAreTheMinimalOnes, ()) {
  const automata::Plant plant = with_unlikely_faults((*models(drawn_shape())).plant);
  Drawn drawn = draw_question(plant);
  drawn.options.faults = 2;
  drawn.options.cut_sets = true;
  verifier::Slices slices(plant);
  const auto result =
      verifier::check(slices, verifier::Reachability{.target = drawn.question.target, .window = {}}, drawn.options, {});
  std::vector<Faults> found;
  for (const auto& cut : result.cut_sets) found.push_back(cut.faults);
  RC_ASSERT(found == minimal_sets(plant, drawn.question));
}

RC_GTEST_PROP(Reachability, CutSetsThatALimitLeavesAreMinimal, ()) {
  const automata::Plant plant = with_unlikely_faults((*models(drawn_shape())).plant);
  Drawn drawn = draw_question(plant);
  drawn.options.faults = 3;
  drawn.options.cut_sets = true;
  const verifier::Reachability target{.target = drawn.question.target, .window = {}};
  verifier::Slices slices(plant);
  const auto sets = [&](const verifier::Answer& answer) {
    std::set<Faults> result;
    for (const auto& cut : answer.cut_sets) result.insert(cut.faults);
    return result;
  };
  const verifier::Answer all = verifier::check(slices, target, drawn.options, {});
  const bool faults_needed = !all.cut_sets.empty() && !all.cut_sets.front().faults.empty();
  RC_PRE(faults_needed);
  verifier::Limits limits;
  limits.states = *rc::gen::inRange<std::size_t>(all.progress.states / 3, all.progress.states);
  const verifier::Answer cut_short = verifier::check(slices, target, drawn.options, limits);
  const std::set<Faults> minimal = sets(all);
  const std::set<Faults> left = sets(cut_short);
  RC_ASSERT(std::includes(minimal.begin(), minimal.end(), left.begin(), left.end()));
  RC_TAG(!cut_short.limit ? "no limit" : left.empty() ? "none" : left == minimal ? "all" : "some");
  if (!cut_short.limit) return;
  RC_ASSERT(cut_short.verdict == verifier::Verdict::undecided);
  if (!cut_short.cut_sets_complete) return;
  drawn.options.faults = *cut_short.cut_sets_complete;
  for (const Faults& faults : sets(verifier::check(slices, target, drawn.options, {}))) {
    RC_ASSERT(left.contains(faults) || !minimal.contains(faults));
  }
}

RC_GTEST_PROP(Reachability, FewestFaultsAreThoseOfTheLeastBudget, ()) {
  // What ties two halves together lets faults of both come only at once.
  const Model model = chance(50) ? *models(drawn_shape()) : *mirrored(half);
  Drawn drawn = draw_question(model.plant);
  const bool sampled = chance(30);
  drawn.options.faults.reset();
  drawn.options.fewest_faults = true;
  if (sampled) drawn.options.period = Ticks::of_seconds(1);
  verifier::Slices slices(model.plant);
  const auto result =
      verifier::check(slices, verifier::Reachability{.target = drawn.question.target, .window = {}}, drawn.options, {});
  const reference::Step slow(model.plant);
  // A fault that is certain at one instant is missed by a clock that restarted between two whole seconds.
  const Ticks half_a_second{Ticks::per_second / 2};
  RC_LOG() << "target " << to_text(drawn.question.target, model.plant.variables) << ", commands "
           << static_cast<int>(drawn.options.commands) << ", fewest faults "
           << (result.fewest_faults ? std::to_string(*result.fewest_faults) : "none") << std::endl;
  for (drawn.question.faults = 0; drawn.question.faults < 4; ++drawn.question.faults) {
    const auto steps = sampled ? reference::fewest_steps_sampled(slow, drawn.question, Ticks::of_seconds(1))
                               : reference::fewest_steps_dense(slow, drawn.question, half_a_second);
    if (!steps) continue;
    RC_ASSERT(result.fewest_faults == static_cast<unsigned>(drawn.question.faults));
    RC_ASSERT(changes(*result.witness) == *steps);
    return;
  }
  RC_ASSERT(!result.fewest_faults || *result.fewest_faults >= 4);
}

RC_GTEST_PROP(Reachability, SampledIsTheTicks, ()) {
  const Model model = *models(drawn_shape());
  Drawn drawn = draw_question(model.plant);
  const Ticks period = pick<Ticks>({{Ticks::per_second}, {Ticks::per_second / 2}, {3 * Ticks::per_second / 4}});
  drawn.options.period = period;
  const reference::Step slow(model.plant);
  compare(model, drawn, reference::fewest_steps_sampled(slow, drawn.question, period));
}

}  // namespace
}  // namespace rmpl::property
