// The estimators: one filter for each independent group of components, and what they say together.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/estimator.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

#include "base/bounded_cache.hpp"
#include "base/check.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/conditioning.hpp"
#include "runtime/reasoning/estimate/filter.hpp"
#include "runtime/reasoning/estimate/groups.hpp"
#include "runtime/reasoning/estimate/product.hpp"
#include "runtime/reasoning/estimate/successor.hpp"

namespace rmpl::runtime {
namespace {

using automata::ControlAction;
using automata::Observation;
using automata::Plant;
using automata::PlantStep;
using automata::Ticks;

using MakeFilters = std::unique_ptr<Filters> (*)(PlantStep&, const EstimatorOptions&);

/// The belief is the product of the filters' beliefs. Exact as long as no control action contradicts the store of a
/// group, for then the guards of all groups hold: from there on one filter keeps the belief of all.
class FactoredEstimator final : public Estimator {
 public:
  /// `listed`: of a product; `carried`: of the belief that one filter takes over from all, at most; `by_modes`: mode
  /// combinations, not states.
  /// `step`: of the whole plant; where it is null one is made, should the plant ever be one part.
  FactoredEstimator(const Plant& plant, PlantStep* step, const EstimatorOptions& options, MakeFilters make,
                    std::size_t listed, std::size_t carried, bool by_modes)
      : plant_(plant),
        whole_step_(step),
        options_(options),
        make_(make),
        listed_(listed),
        carried_(carried),
        by_modes_(by_modes) {
    // Without merging or normalisation numbers of different groups do not multiply to what Fig. 6-11 has.
    if (options.factored && options.merge_trajectories && options.normalise) {
      groups_.emplace(plant);
      if (groups_->size() > 1) take_apart();
    }
    if (parts_.empty()) take_as_one();
    summarise(std::all_of(parts_.begin(), parts_.end(), [](const Part& p) { return p.filter->estimate().consistent; }));
  }

  const Estimate& start(const Observation& observation) override {
    CHECK(!updated_);
    const auto seen = parts_.size() > 1 ? groups_->divide(observation) : std::vector<Observation>{observation};
    forget_set_aside();
    bool consistent = true;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      consistent = note(parts_[p], parts_[p].shape.conditioning.start(*parts_[p].filter, seen[p])) && consistent;
    }
    summarise(consistent);
    return estimate_;
  }

  const Estimate& update(const ControlAction& action, const Observation& observation, Ticks now) override {
    CHECK(now >= last_);
    Deadline deadline;
    if (options_.deadline) deadline = std::chrono::steady_clock::now() + *options_.deadline;
    const bool told_again = updated_ && action == action_ && observation == observation_;
    if (told_again) {
      for (Part& part : parts_) part.told_again = true;
    } else {
      tell_parts(action, observation);
    }
    if (parts_.size() > 1 && !(told_again && stayed_) && !all_permit()) {
      fuse();
      parts_.front().tell(action, observation);
    }
    const bool as_long = updated_ && base::caches_on() && now - last_ == last_ - before_;
    forget_set_aside();
    bool consistent = true;
    stayed_ = true;
    for (Part& part : parts_) {
      if (as_long && part.told_again && part.filter->steady()) {
        part.filter->repeat(now);
        continue;
      }
      stayed_ = false;
      const StepInput input{part.action, part.observation, now, deadline};
      consistent = note(part, part.shape.conditioning.update(*part.filter, input, last_)) && consistent;
    }
    before_ = std::exchange(last_, now);
    updated_ = true;
    if (!stayed_) summarise(consistent);
    return estimate_;
  }

  [[nodiscard]] const Belief& belief() const override {
    if (parts_.size() == 1) return parts_.front().filter->belief();
    if (!multiplied_) {
      joint_ = head_of_product(listed_);
      multiplied_ = true;
    }
    return joint_;
  }
  [[nodiscard]] Belief belief_about(std::span<const automata::ComponentId> components) const override {
    constexpr std::size_t most = 4096;
    std::vector<Factor> factors;
    for (const Part& part : parts_) {
      const bool asked = std::any_of(components.begin(), components.end(), [&](automata::ComponentId c) {
        return std::binary_search(part.components.begin(), part.components.end(), c);
      });
      if (asked) factors.push_back({&part.filter->belief(), part.components});
    }
    if (factors.empty()) return {{{estimate_.modes, {}}, 1}};
    Belief result = product(factors, plant_.components.size(), most);
    const double whole = options_.normalise ? 1 : total(result);
    std::vector<bool> decided(estimate_.modes.size(), false);
    for (const Factor& factor : factors) {
      for (const automata::ComponentId c : factor.components) decided[c.index()] = true;
    }
    for (BeliefEntry& entry : result) {
      if (whole > 0) entry.probability /= whole;
      for (std::size_t c = 0; c < decided.size(); ++c) {
        if (!decided[c]) entry.state.modes[c] = estimate_.modes[c];
      }
    }
    return result;
  }
  [[nodiscard]] const Estimate& estimate() const override { return estimate_; }
  [[nodiscard]] bool stayed() const override { return stayed_; }
  [[nodiscard]] std::optional<automata::Modes> likeliest_without(
      automata::ComponentId component, automata::ModeId mode, const std::vector<RefutedModes>& refuted) const override {
    if (!updated_) return std::nullopt;
    automata::Modes whole(plant_.components.size());
    for (const Part& part : parts_) {
      ConflictSet avoided;
      if (const auto own = decisions_of(part, {{component, mode}})) avoided.add(*own);
      for (const RefutedModes& modes : refuted) {
        if (const auto own = decisions_of(part, modes)) avoided.add(*own);
      }
      const auto own =
          likeliest_successor(part.shape.step, part.filter->before(), part.action, before_, last_, avoided);
      if (!own) return std::nullopt;
      for (std::size_t i = 0; i < part.components.size(); ++i) whole[part.components[i].index()] = (*own)[i];
    }
    return whole;
  }
  [[nodiscard]] bool tells_rivals() const override { return true; }
  [[nodiscard]] double probability_of(const automata::Modes& modes) const override {
    double result = 1;
    for (const Part& part : parts_) {
      automata::Modes own;
      for (const automata::ComponentId c : part.components) own.push_back(modes[c.index()]);
      double sum = 0;
      for (const BeliefEntry& entry : part.filter->belief()) {
        if (entry.state.modes == own) sum += entry.probability;
      }
      result *= sum;
    }
    return result;
  }
  [[nodiscard]] std::size_t groups() const override { return parts_.size(); }
  [[nodiscard]] std::size_t questions() const override {
    std::size_t sum = retired_questions_;
    for (const Shape& shape : shapes_) sum += shape.step.questions();
    return sum;
  }
  [[nodiscard]] std::size_t solver_calls() const override {
    std::size_t sum = retired_calls_;
    for (const Shape& shape : shapes_) sum += shape.step.solver_calls();
    return sum;
  }

 private:
  /// What all parts of one shape have in common: it tells of one as of another, and they are asked one at a time.
  struct Shape {
    Shape(PlantStep& of, std::unique_ptr<Filters> own) : step(of), conditioning(of), filters(std::move(own)) {}
    PlantStep& step;
    Conditioning conditioning;
    std::unique_ptr<Filters> filters;
  };
  struct Part {
    Part(std::span<const automata::ComponentId> members, Shape& own) : components(members), shape(own) {}
    std::span<const automata::ComponentId> components;
    Shape& shape;
    const Group* group = nullptr;  ///< none where the part is the whole
    std::unique_ptr<Filter> filter;
    ControlAction action;  ///< of the last update, as the next two
    Observation observation;
    bool told_again = false;  ///< the update before had the same

    void tell(ControlAction own_action, Observation own_observation) {
      told_again = action == own_action && observation == own_observation;
      action = std::move(own_action);
      observation = std::move(own_observation);
    }
  };

  /// Gives each part its own of the input.
  void tell_parts(const ControlAction& action, const Observation& observation) {
    action_ = action;
    observation_ = observation;
    if (parts_.size() == 1) return parts_.front().tell(action, observation);
    auto observations = groups_->divide(observation);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      ControlAction own;
      for (const std::size_t i : parts_[p].group->controls) own.push_back(action[i]);
      parts_[p].tell(std::move(own), std::move(observations[p]));
    }
  }

  void forget_set_aside() {
    estimate_.follows = true;
    estimate_.set_aside.clear();
    estimate_.surprised.clear();
  }

  /// Takes down what a part did not count; whether that is nothing.
  bool note(const Part& part, const Conditioned& conditioned) {
    estimate_.follows = estimate_.follows && conditioned.follows;
    if (conditioned.set_aside.empty()) return conditioned.follows;
    estimate_.surprised.resize(plant_.components.size(), false);
    for (const automata::ComponentId c : part.components) estimate_.surprised[c.index()] = true;
    for (automata::Assignment reading : conditioned.set_aside) {
      if (part.group != nullptr) reading.variable = part.group->variables[reading.variable.index()];
      estimate_.set_aside.push_back(reading);
    }
    std::sort(estimate_.set_aside.begin(), estimate_.set_aside.end());
    return false;
  }

  /// Modes as decisions of a part; nothing where not all of them are its own.
  static std::optional<Conflict> decisions_of(const Part& part, const RefutedModes& modes) {
    Conflict result;
    for (const auto& [component, mode] : modes) {
      const auto member = std::find(part.components.begin(), part.components.end(), component);
      if (member == part.components.end()) return std::nullopt;
      result.push_back({static_cast<std::uint32_t>(member - part.components.begin()), mode.value});
    }
    return result;
  }

  void take_apart() {
    for (std::size_t s = 0; s < groups_->shapes().size(); ++s) {
      take_shape(own_steps_.emplace_back(groups_->shapes()[s]));
    }
    parts_.reserve(groups_->size());
    for (const Group& group : *groups_) {
      Part& part = parts_.emplace_back(group.components, shapes_[group.shape]);
      part.filter = part.shape.filters->make();
      part.group = &group;
    }
  }

  void take_as_one() {
    for (std::size_t c = 0; c < plant_.components.size(); ++c) all_.emplace_back(c);
    if (whole_step_ == nullptr) whole_step_ = &own_steps_.emplace_back(plant_);
    Part& part = parts_.emplace_back(all_, take_shape(*whole_step_));
    part.filter = part.shape.filters->make();
  }

  Shape& take_shape(PlantStep& step) { return shapes_.emplace_back(step, make_(step, options_)); }

  [[nodiscard]] std::vector<Factor> factors() const {
    std::vector<Factor> result;
    for (const Part& part : parts_) result.push_back({&part.filter->belief(), part.components});
    return result;
  }

  [[nodiscard]] Belief head_of_product(std::size_t most) const {
    const std::size_t components = plant_.components.size();
    return by_modes_ ? product_by_modes(factors(), components, most, options_.clocks)
                     : product(factors(), components, most);
  }

  /// Whether the control action is consistent with all that each group may be in.
  bool all_permit() {
    for (const Part& part : parts_) {
      if (!part.group->constrains_controls) continue;
      const auto permits = [&](const automata::Modes& modes) { return part.shape.step.permits(modes, part.action); };
      if (!part.filter->all_modes(permits)) return false;
    }
    return true;
  }

  void fuse() {
    const std::vector<Factor> parts = factors();
    Belief joint = head_of_product(carried_);
    // A sum that is rounded must not make what is whole look as if some of it were missing.
    const bool whole = joint.size() == product_size(parts);
    retired_questions_ = questions();
    retired_calls_ = solver_calls();
    if (whole_step_ != nullptr) {
      retired_questions_ -= whole_step_->questions();
      retired_calls_ -= whole_step_->solver_calls();
    }
    const double missing =
        whole ? estimate_.missing_total : std::min(1.0, estimate_.missing_total + 1 - std::min(1.0, total(joint)));
    parts_.clear();
    shapes_.clear();
    own_steps_.clear();
    take_as_one();
    parts_.front().filter->resume(std::move(joint), missing, last_);
  }

  /// The estimate of the whole from the estimates of the parts.
  void summarise(bool consistent) {
    multiplied_ = false;
    estimate_.modes.resize(plant_.components.size());
    estimate_.consistent = consistent;
    estimate_.probability = 1;
    estimate_.cut = false;
    estimate_.checked = 0;
    double kept = 1;
    double kept_of_all = 1;
    for (const Part& part : parts_) {
      const Estimate& own = part.filter->estimate();
      for (std::size_t i = 0; i < part.components.size(); ++i) {
        estimate_.modes[part.components[i].index()] = own.modes[i];
      }
      estimate_.probability *= own.probability;
      estimate_.cut = estimate_.cut || own.cut;
      estimate_.checked += own.checked;
      kept *= 1 - own.missing_mass;
      kept_of_all *= 1 - own.missing_total;
    }
    estimate_.rank = parts_.front().filter->estimate().rank;  // ranks have one group
    estimate_.missing_mass = parts_.size() == 1 ? parts_.front().filter->estimate().missing_mass : 1 - kept;
    estimate_.missing_total = parts_.size() == 1 ? parts_.front().filter->estimate().missing_total : 1 - kept_of_all;
  }

  const Plant& plant_;
  PlantStep* whole_step_;  ///< of the whole plant; null where nobody needs it
  const EstimatorOptions options_;
  const MakeFilters make_;
  const std::size_t listed_;
  const std::size_t carried_;
  const bool by_modes_;
  std::optional<Groups> groups_;
  std::vector<automata::ComponentId> all_;  ///< once the plant is one part
  std::deque<PlantStep> own_steps_;         ///< those that nobody else has
  std::deque<Shape> shapes_;
  std::vector<Part> parts_;
  ControlAction action_;     ///< of the last update
  Observation observation_;  ///< likewise
  Ticks before_;             ///< the update before the last
  Ticks last_;
  bool updated_ = false;
  bool stayed_ = false;  ///< all parts, in the last update
  Estimate estimate_;
  mutable Belief joint_;
  mutable bool multiplied_ = false;
  std::size_t retired_questions_ = 0;  ///< of parts that were fused
  std::size_t retired_calls_ = 0;
};

std::unique_ptr<Estimator> make_exact(const Plant& plant, PlantStep* step, const EstimatorOptions& options) {
  return std::make_unique<FactoredEstimator>(plant, step, options, exact_filters, options.listed,
                                             std::numeric_limits<std::size_t>::max(), false);
}

std::unique_ptr<Estimator> make_k_best(const Plant& plant, PlantStep* step, const EstimatorOptions& options) {
  return std::make_unique<FactoredEstimator>(plant, step, options, k_best_filters, options.k, options.k, true);
}

}  // namespace

std::unique_ptr<Estimator> make_exact_estimator(PlantStep& step, const EstimatorOptions& options) {
  return make_exact(step.plant(), &step, options);
}

std::unique_ptr<Estimator> make_exact_estimator(const Plant& plant, const EstimatorOptions& options) {
  return make_exact(plant, nullptr, options);
}

std::unique_ptr<Estimator> make_k_best_estimator(PlantStep& step, const EstimatorOptions& options) {
  return make_k_best(step.plant(), &step, options);
}

std::unique_ptr<Estimator> make_k_best_estimator(const Plant& plant, const EstimatorOptions& options) {
  return make_k_best(plant, nullptr, options);
}

}  // namespace rmpl::runtime
