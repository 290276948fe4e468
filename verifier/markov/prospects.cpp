// Bounds that one step keeps.
// SPDX-License-Identifier: MIT
#include "verifier/markov/prospects.hpp"

#include <algorithm>
#include <optional>

#include "automata/step/plant_step.hpp"
#include "verifier/markov/draws.hpp"
#include "verifier/slice/slices.hpp"

namespace rmpl::verifier {

using automata::Modes;

namespace {

/// Modes, and choices of all modes together, beyond which nothing is told.
constexpr std::size_t most_joint_modes = 2048;
constexpr std::size_t most_choices = std::size_t{1} << 15;
/// Likewise of what may be drawn, over all choices together.
constexpr std::size_t most_joint_outcomes = std::size_t{1} << 19;
/// So much work goes into finding bounds.
constexpr std::size_t most_work = std::size_t{1} << 27;
/// So often the bounds are made greater, until a step keeps them.
constexpr int most_rounds = 256;
/// Bounds for each step that differ by a smaller part are one.
constexpr Real as_one = 1e-3L;
/// A step keeps bounds but for so small a part of the bound for each step.
constexpr Real slack = 1e-6L;
/// So small a bound for each step tells as much as none, and outweighs roundings.
constexpr Real least_each_step = 1e-16L;

/// The cone as a decision process, whatever clocks read.
class Cut {
 public:
  Cut(automata::PlantStep& step, const Prospects::Question& question, const automata::Formula& target, Meter& meter)
      : step_(step), question_(question), target_(step.theory().encode(target)), meter_(meter) {}

  /// Nothing where it is too large.
  std::optional<std::map<Modes, Prospect>> run(const std::vector<automata::Assignment>& from) {
    if (combinations() > most_choices) return std::nullopt;
    for_each_action(step_.plant(), question_.commands,
                    [this](const automata::ControlAction& action) { actions_.push_back(action); });
    for (const Draw& draw : initial_draws(step_, from, meter_).outcomes) number(draw.modes);
    const std::size_t starts = modes_.size();
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      if (modes_.size() > most_joint_modes || choices_.size() + actions_.size() > most_choices) return std::nullopt;
      if (!wanted_[m] && !explore(m)) return std::nullopt;
    }
    find_hopeless();
    std::map<Modes, Prospect> result;
    const std::vector<Prospect> found = best(starts);
    for (std::size_t m = 0; m < modes_.size(); ++m) result.emplace(modes_[m], found[m]);
    return result;
  }

 private:
  /// What is drawn there in one way: at most how likely it is to come to what is wanted, and to other modes.
  struct Choice {
    std::size_t at;
    Real hit = 0;
    std::vector<std::pair<std::size_t, Real>> others;
  };

  /// Of the values of all controls.
  [[nodiscard]] std::size_t combinations() const {
    std::size_t result = 1;
    for (const automata::Control& control : step_.plant().controls) {
      result = std::min(result * step_.plant().variables[control.variable].values.size(), most_choices + 1);
    }
    return result;
  }

  std::size_t number(const Modes& modes) {
    const auto [at, fresh] = numbers_.try_emplace(modes, modes_.size());
    if (fresh) {
      const auto store = automata::assignments_of(step_.plant(), modes);
      modes_.push_back(modes);
      wanted_.push_back(question_.entailed ? step_.theory().entails(store, target_)
                                           : step_.theory().allows(store, target_));
    }
    return at->second;
  }

  bool explore(std::size_t m) {
    const Modes modes = modes_[m];
    for (const automata::ControlAction& action : actions_) {
      meter_.poll();
      const automata::AllEnabled* enabled = step_.enabled_if_permitted(modes, action);
      if (enabled == nullptr) continue;
      const std::vector<Draws> extremes = StepDraws(step_, modes, *enabled, question_.period).extremes(meter_);
      if (extremes.empty()) return false;
      for (const Draws& draws : extremes) {
        outcomes_ += draws.outcomes.size();
        if (outcomes_ > most_joint_outcomes) return false;
        Choice choice{m, draws.left_out, {}};
        for (const Draw& draw : draws.outcomes) {
          const std::size_t to = number(draw.modes);
          if (wanted_[to]) {
            choice.hit = rounding::up(choice.hit + draw.probability.upper, 1);
          } else {
            choice.others.emplace_back(to, draw.probability.upper);
          }
        }
        choices_.push_back(std::move(choice));
      }
    }
    return true;
  }

  /// Modes from which nothing leads to what is wanted.
  void find_hopeless() {
    hopeless_.assign(modes_.size(), true);
    for (bool changed = true; changed;) {
      changed = false;
      for (const Choice& choice : choices_) {
        if (!hopeless_[choice.at]) continue;
        hopeless_[choice.at] = choice.hit == 0 && std::all_of(choice.others.begin(), choice.others.end(),
                                                              [&](const auto& to) { return hopeless_[to.first]; });
        changed = changed || !hopeless_[choice.at];
      }
    }
  }

  /// What one step of a choice leads to, with these bounds once and for all.
  [[nodiscard]] Real after(const Choice& choice, const std::vector<Real>& once) const {
    Real sum = choice.hit;
    for (const auto& [to, probability] : choice.others) sum += probability * once[to];
    return rounding::up(sum, 2 * choice.others.size() + 1);
  }

  /// The least bounds once and for all with that bound for each step; nothing where there may be none.
  [[nodiscard]] std::optional<std::vector<Real>> once_for(Real each_step) {
    std::vector<Real> once(modes_.size(), 0);
    for (int round = 0; round < most_rounds; ++round) {
      meter_.poll();
      bool kept = true;
      if (work_ > most_work) return std::nullopt;
      work_ += outcomes_;
      // What was met later is nearer to what is wanted.
      for (auto at = choices_.rbegin(); at != choices_.rend(); ++at) {
        const Choice& choice = *at;
        const Real least = rounding::up(after(choice, once) - each_step, 1);
        if (least <= once[choice.at]) continue;
        if (least > 1) return std::nullopt;
        kept = kept && least - once[choice.at] <= each_step * slack;
        once[choice.at] = least;
      }
      if (kept && keeps(once, each_step)) return once;
    }
    return std::nullopt;
  }

  /// The bounds for n - 1 steps are in all modes the same, so that the bounds once and for all and for one step are
  /// left.
  [[nodiscard]] bool keeps(const std::vector<Real>& once, Real each_step) const {
    const Real greater = each_step * (1 + 2 * slack);
    return std::all_of(choices_.begin(), choices_.end(), [&](const Choice& choice) {
      return after(choice, once) <= rounding::down(once[choice.at] + greater, 1);
    });
  }

  [[nodiscard]] std::vector<Prospect> best(std::size_t starts) {
    std::vector<Real> hits{least_each_step};
    for (const Choice& choice : choices_) hits.push_back(choice.hit * (1 + as_one));
    std::sort(hits.begin(), hits.end());
    std::vector<Prospect> result(modes_.size());
    Real least = 1;
    Real tried = -1;
    for (const Real each_step : hits) {
      if (each_step <= tried * (1 + as_one)) continue;
      tried = each_step;
      const auto once = once_for(each_step);
      if (!once) continue;
      // Upper bounds of probabilities may sum to more than 1, by far less than that.
      const Real greater = each_step * (1 + 3 * slack);
      Real at_start = 0;
      for (std::size_t m = 0; m < starts; ++m)
        at_start = std::max(at_start, Prospect{(*once)[m], greater}.within(question_.steps));
      if (at_start >= least) continue;
      least = at_start;
      for (std::size_t m = 0; m < modes_.size(); ++m) result[m] = {(*once)[m], greater};
    }
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      if (hopeless_[m] && !wanted_[m]) result[m] = {0, 0};
      if (wanted_[m]) result[m] = {};
    }
    return result;
  }

  automata::PlantStep& step_;
  const Prospects::Question& question_;
  automata::Theory::Handle target_;
  Meter& meter_;
  std::vector<automata::ControlAction> actions_;
  std::map<Modes, std::size_t> numbers_;
  std::vector<Modes> modes_;
  std::vector<bool> wanted_, hopeless_;
  std::vector<Choice> choices_;
  std::size_t outcomes_ = 0;  ///< of all choices
  std::size_t work_ = 0;
};

}  // namespace

Prospects::Prospects(const automata::Plant& plant, const Question& question, Meter& meter) {
  Slices slices(plant);
  const std::vector<automata::Formula> target(1, question.target);
  const Cone cone = slices.cone(target);
  std::size_t modes = 1;
  for (const automata::ComponentId c : cone) modes = std::min(modes * plant[c].modes.size(), 64 * most_joint_modes);
  if (modes > 16 * most_joint_modes) return;
  const Part part = slices.part(cone, target);
  automata::PlantStep step(part.plant());
  auto known = Cut(step, question, part.into(question.target), meter).run(part.into(question.from));
  if (!known) return;
  cone_ = cone;
  known_ = std::move(*known);
}

Prospect Prospects::of(const Modes& modes) const {
  Modes own;
  for (const automata::ComponentId c : cone_) own.push_back(modes[c.index()]);
  const auto at = known_.find(own);
  return at == known_.end() ? Prospect{} : at->second;
}

}  // namespace rmpl::verifier
