// Joint outcomes of a step, with bounds of their probabilities.
// SPDX-License-Identifier: MIT
#include "verifier/markov/draws.hpp"

#include <algorithm>

#include "automata/fault_step.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::ComponentId;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;
using automata::Move;

namespace {

/// More than the relative error of a move's probability (automata/time/density.hpp): few operations in double
/// precision, but for densities that take series or special functions.
constexpr Real error_of_move = 2e-14L;
constexpr Real error_of_series = 4e-12L;
/// What faults take of a step at most, where it is told apart from the rest.
constexpr Real few = 0.5L;

using Option = DrawOption;

bool takes_series(const Component& component, const Enabled& enabled) {
  using Kind = automata::Density::Kind;
  return std::any_of(enabled.timed.begin(), enabled.timed.end(), [&](automata::TransitionId t) {
    const Kind kind = component.transitions[t.index()].timing->density.kind;
    return kind != Kind::uniform && kind != Kind::exponential;
  });
}

/// The likeliest is what the others leave, so that what is all but certain is known to be.
std::vector<Option> options_of(const std::vector<Move>& moves, Real error) {
  std::vector<Option> result;
  if (moves.size() == 1) return {{moves.front().mode, certain()}};
  std::size_t likeliest = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (moves[i].probability > moves[likeliest].probability) likeliest = i;
  }
  Enclosure others;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Real p = static_cast<Real>(moves[i].probability);
    const Enclosure bounds = outward({p * (1 - error), p * (1 + error)}, 2);
    if (i != likeliest) others = others + bounds;
    result.push_back({moves[i].mode, bounds});
  }
  const Enclosure rest{rounding::down(std::max<Real>(1 - others.upper, 0), 1),
                       std::min<Real>(rounding::up(std::max<Real>(1 - others.lower, 0), 1), 1)};
  Enclosure& own = result[likeliest].probability;
  own = {std::max(own.lower, rest.lower), std::min(own.upper, rest.upper)};
  std::stable_sort(result.begin(), result.end(),
                   [](const Option& a, const Option& b) { return a.probability.upper > b.probability.upper; });
  return result;
}

/// Multiplies out what components draw, the likelier first.
class Product {
 public:
  Product(automata::PlantStep& step, const std::vector<std::vector<Option>>& options, const LeftOut& left_out,
          Meter& meter)
      : step_(step), options_(options), left_out_(left_out), meter_(meter) {
    for (std::size_t c = 0; c < options.size(); ++c) {
      if (options[c].size() > 1) open_.push_back(c);
      modes_.push_back(options[c].front().mode);
      faults_ += options[c].front().faults;
    }
    for (const std::size_t c : open_) faults_ -= options[c].front().faults;
  }

  Draws run() {
    descend(0, certain(), faults_);
    return scaled();
  }

  /// Not scaled, with what is impossible.
  Draws part() {
    tell_impossible_ = true;
    descend(0, certain(), faults_);
    return sorted();
  }

 private:
  void descend(std::size_t at, const Enclosure& so_far, unsigned faults) {
    if (left_out_.faults_beyond && faults > *left_out_.faults_beyond) return leave_out(so_far);
    if (at == open_.size()) return visit(so_far, faults);
    const std::size_t c = open_[at];
    Real rest = 0;
    bool cut = false;
    for (const Option& option : options_[c]) {
      const Enclosure next = so_far * option.probability;
      if (cut || next.upper < left_out_.less_likely_than) {
        cut = true;
        rest = rounding::up(rest + next.upper, 1);
        continue;
      }
      modes_[c] = option.mode;
      descend(at + 1, next, faults + option.faults);
    }
    if (rest > 0) leave_out({0, rest});
  }

  void leave_out(const Enclosure& what) { result_.left_out = rounding::up(result_.left_out + what.upper, 1); }

  void visit(const Enclosure& probability, unsigned faults) {
    meter_.poll();
    if (step_.possible(modes_)) {
      result_.outcomes.push_back({modes_, probability, faults});
    } else {
      impossible_ = true;
      if (tell_impossible_) result_.impossible.push_back(modes_);
    }
  }

  /// Each outcome is a part of what is possible: of everything, where nothing is impossible and nothing left out.
  Draws scaled() {
    if (!impossible_ && result_.left_out == 0) return sorted();
    Enclosure listed;
    for (const Draw& draw : result_.outcomes) listed = listed + draw.probability;
    Enclosure all{listed.lower, listed.upper + result_.left_out};
    all.upper = std::min<Real>(rounding::up(all.upper, 1), 1);
    if (all.lower == 0) {
      // Nothing is known of how likely what is listed is.
      const bool nothing = result_.outcomes.empty() && result_.left_out == 0;
      result_.outcomes.clear();
      result_.left_out = nothing ? 0 : 1;
      return result_;
    }
    for (Draw& draw : result_.outcomes) draw.probability = as_probability(draw.probability / all);
    result_.left_out = std::min<Real>(rounding::up(result_.left_out / all.lower, 1), 1);
    return sorted();
  }

  Draws sorted() {
    std::stable_sort(result_.outcomes.begin(), result_.outcomes.end(),
                     [](const Draw& a, const Draw& b) { return a.probability.upper > b.probability.upper; });
    return std::move(result_);
  }

  automata::PlantStep& step_;
  const std::vector<std::vector<Option>>& options_;
  const LeftOut& left_out_;
  Meter& meter_;
  bool tell_impossible_ = false;
  std::vector<std::size_t> open_;  ///< components with more than one option
  Modes modes_;
  unsigned faults_ = 0;  ///< of the others
  bool impossible_ = false;
  Draws result_;
};

/// What a component may do, in order of probability, with the faults told.
std::vector<Option> options_in(const Component& component, ModeId mode, const std::vector<Move>& moves, Real error) {
  std::vector<Option> result = options_of(moves, error);
  for (Option& option : result) {
    if (automata::is_fault_step(component, mode, option.mode)) option.faults = 1;
  }
  return result;
}

}  // namespace

StepDraws::StepDraws(automata::PlantStep& step, Modes modes, automata::AllEnabled enabled, automata::Ticks period)
    : step_(step), modes_(std::move(modes)), enabled_(std::move(enabled)), period_(period), options_(modes_.size()) {
  for (std::size_t c = 0; c < modes_.size(); ++c) {
    timed_.push_back(automata::clock_matters(step.plant().components[c], enabled_[c]));
    if (!timed_[c]) options_[c] = options_of(c, 0);
  }
}

std::vector<Option> StepDraws::options_of(std::size_t c, Units age) const {
  const Component& component = step_.plant().components[c];
  const automata::Ticks clock{(std::max<Units>(age, 0) + 1) * period_.count};
  const std::vector<Move> moves = automata::moves_of(component, modes_[c], enabled_[c], clock, period_);
  const Real error = takes_series(component, enabled_[c]) ? error_of_series : error_of_move;
  return options_in(component, modes_[c], moves, error);
}

bool StepDraws::enables_as(const StepDraws& other, std::size_t c) const {
  const Enabled& a = enabled_[c];
  const Enabled& b = other.enabled_[c];
  return &a == &b || (a.faults == b.faults && a.untimed == b.untimed && a.timed == b.timed);
}

std::vector<ModeId> StepDraws::nominal(std::size_t c) const {
  const std::vector<automata::Transition>& transitions = step_.plant().components[c].transitions;
  std::vector<ModeId> result;
  for (const automata::TransitionId t : enabled_[c].untimed) result.push_back(transitions[t.index()].to);
  if (!result.empty()) return result;
  result.push_back(modes_[c]);
  for (const automata::TransitionId t : enabled_[c].timed) result.push_back(transitions[t.index()].to);
  return result;
}

std::optional<std::vector<DrawOption>> StepDraws::faults(std::size_t c) const {
  const Component& component = step_.plant().components[c];
  const std::vector<ModeId> others = nominal(c);
  std::vector<Option> result;
  Real faulty = 0;
  for (const automata::TransitionId id : enabled_[c].faults) {
    const automata::Transition& t = component.transitions[id.index()];
    if (t.timing || std::find(others.begin(), others.end(), t.to) != others.end()) return std::nullopt;
    const Real p = static_cast<Real>(t.weight.fault_probability(period_));
    const Enclosure bounds = outward({p * (1 - error_of_move), p * (1 + error_of_move)}, 2);
    faulty += bounds.upper;
    const auto known = std::find_if(result.begin(), result.end(), [&](const Option& o) { return o.mode == t.to; });
    if (known != result.end()) {
      known->probability = known->probability + bounds;
    } else {
      result.push_back({t.to, bounds, component.modes[t.to.index()].fault ? 1u : 0u});
    }
  }
  if (faulty > few) return std::nullopt;
  return result;
}

bool StepDraws::decides(std::size_t c, Units age) const {
  if (!timed_[c] || !enabled_[c].untimed.empty()) return false;
  const std::vector<ModeId> modes = nominal(c);
  const std::vector<Option> options = options_of(c, age);
  return std::count_if(options.begin(), options.end(), [&](const Option& option) {
           return std::find(modes.begin(), modes.end(), option.mode) != modes.end();
         }) > 1;
}

std::vector<Option> StepDraws::joined_options(std::size_t c) const {
  std::vector<Option> result = *faults(c);
  Enclosure faulty;
  for (const Option& option : result) faulty = faulty + option.probability;
  const Enclosure share = result.empty() ? certain() : outward({1 - faulty.upper, 1 - faulty.lower}, 1);
  result.insert(result.begin(), Option{nominal(c).front(), as_probability(share), 0});
  return result;
}

Draws StepDraws::at(const std::vector<Units>& ages, const LeftOut& left_out, Meter& meter) {
  for (std::size_t c = 0; c < ages.size(); ++c) {
    if (timed_[c]) options_[c] = options_of(c, ages[c]);
  }
  return Product(step_, options_, left_out, meter).run();
}

Draws StepDraws::part(const Modes& timed, const std::vector<bool>& joined, const LeftOut& left_out,
                      Meter& meter) const {
  std::vector<std::vector<Option>> options = options_;
  for (std::size_t c = 0; c < timed.size(); ++c) {
    if (joined[c]) {
      options[c] = joined_options(c);
    } else if (timed_[c]) {
      const bool fault = automata::is_fault_step(step_.plant().components[c], modes_[c], timed[c]);
      options[c] = {{timed[c], certain(), fault ? 1u : 0u}};
    }
  }
  return Product(step_, options, left_out, meter).part();
}

/// At any age one of these is a mixture of them. Where the clock has nothing to do with faults, they are the same in
/// all.
std::vector<std::vector<Option>> StepDraws::extremes_of(std::size_t c) const {
  const Component& component = step_.plant().components[c];
  const Enabled& enabled = enabled_[c];
  const auto transition = [&](automata::TransitionId t) -> const automata::Transition& {
    return component.transitions[t.index()];
  };
  const auto option = [&](ModeId mode, const Enclosure& probability) {
    return Option{mode, probability, automata::is_fault_step(component, modes_[c], mode) ? 1u : 0u};
  };
  std::vector<Option> faults;
  Enclosure faulty;
  bool apart = true;
  for (const automata::TransitionId t : enabled.faults) {
    const Real p = static_cast<Real>(transition(t).weight.fault_probability(period_));
    faults.push_back(option(transition(t).to, outward({p * (1 - error_of_move), p * (1 + error_of_move)}, 2)));
    faulty = faulty + faults.back().probability;
    apart = apart && !transition(t).timing;
  }
  apart = apart && faulty.upper < few;
  if (apart && !enabled.untimed.empty()) return {options_of(c, 0)};
  std::vector<ModeId> modes;
  if (enabled.untimed.empty()) modes.push_back(modes_[c]);
  for (const automata::TransitionId t : enabled.untimed) modes.push_back(transition(t).to);
  for (const automata::TransitionId t : enabled.timed) modes.push_back(transition(t).to);
  std::vector<std::vector<Option>> result;
  for (const ModeId mode : modes) {
    if (!apart) {
      result.push_back({option(mode, certain())});
      continue;
    }
    const Enclosure share = faults.empty() ? certain() : outward({1 - faulty.upper, 1 - faulty.lower}, 1);
    result.push_back({option(mode, as_probability(share))});
    result.back().insert(result.back().end(), faults.begin(), faults.end());
  }
  for (std::size_t f = 0; !apart && f < faults.size(); ++f) result.push_back({option(faults[f].mode, certain())});
  return result;
}

std::vector<Draws> StepDraws::extremes(Meter& meter) {
  constexpr std::size_t most = 64;
  std::vector<std::vector<std::vector<Option>>> combinations{options_};
  for (std::size_t c = 0; c < timed_.size(); ++c) {
    if (!timed_[c]) continue;
    const std::vector<std::vector<Option>> own = extremes_of(c);
    std::vector<std::vector<std::vector<Option>>> longer;
    for (const auto& one : combinations) {
      for (const std::vector<Option>& options : own) {
        longer.push_back(one);
        longer.back()[c] = options;
      }
    }
    if (longer.size() > most) return {};
    combinations = std::move(longer);
  }
  std::vector<Draws> result;
  result.reserve(combinations.size());
  const LeftOut nothing;
  for (const auto& options : combinations) result.push_back(Product(step_, options, nothing, meter).run());
  return result;
}

Draws instant_draws(automata::PlantStep& step, const Modes& modes, const automata::AllEnabled& enabled,
                    const LeftOut& left_out, Meter& meter) {
  std::vector<std::vector<Option>> options;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const Component& component = step.plant().components[c];
    Enabled here = enabled[c];
    std::erase_if(here.faults, [&](automata::TransitionId t) {
      return component.transitions[t.index()].weight.kind == automata::Weight::Kind::rate;
    });
    const automata::Ticks none{};
    options.push_back(
        options_in(component, modes[c], automata::moves_of(component, modes[c], here, none, none), error_of_move));
  }
  return Product(step, options, left_out, meter).run();
}

Draws initial_draws(automata::PlantStep& step, const std::vector<automata::Assignment>& from, Meter& meter) {
  const automata::Plant& plant = step.plant();
  const std::vector<std::vector<ModeId>> given = initial_modes(plant, from);
  std::vector<std::vector<Option>> options;
  for (std::size_t c = 0; c < given.size(); ++c) {
    std::vector<Move> moves = automata::initial_moves_of(plant.components[c]);
    if (given[c].size() == 1) moves = {{given[c].front(), 1.0}};
    options.push_back(options_of(moves, error_of_move));
  }
  const LeftOut nothing;
  return Product(step, options, nothing, meter).run();
}

}  // namespace rmpl::verifier
