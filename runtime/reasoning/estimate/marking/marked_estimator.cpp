// Markings as modes of the facade and of its locations.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking/marked_estimator.hpp"

#include "base/error.hpp"

namespace rmpl::runtime {
namespace {

class MarkedEstimator final : public Estimator {
 public:
  MarkedEstimator(const automata::ModelProgram& program, const automata::MarkedPlant& plant,
                  const MarkingOptions& options)
      : plant_(plant), estimator_(make_marking_estimator(program, options)) {
    if (!estimator_->estimate().possible) {
      throw base::InputError("no start of '" + program.name + "' is consistent");
    }
    take_over();
  }

  const Estimate& start(const automata::Observation& observation) override {
    estimator_->start(observation);
    return take_over();
  }
  const Estimate& update(const automata::ControlAction& action, const automata::Observation& observation,
                         automata::Ticks) override {
    estimator_->update(automata::command_of(action), observation);
    return take_over();
  }
  [[nodiscard]] const Belief& belief() const override { return belief_; }
  [[nodiscard]] const Estimate& estimate() const override { return estimate_; }
  [[nodiscard]] double probability_of(const automata::Modes& modes) const override {
    double sum = 0;
    for (const BeliefEntry& entry : belief_) {
      if (entry.state.modes == modes) sum += entry.probability;
    }
    return sum;
  }
  [[nodiscard]] std::size_t groups() const override { return estimator_->groups(); }
  [[nodiscard]] std::size_t questions() const override { return estimator_->questions(); }
  [[nodiscard]] std::size_t solver_calls() const override { return estimator_->solver_calls(); }

 private:
  const Estimate& take_over() {
    const MarkingEstimate& update = estimator_->estimate();
    belief_.clear();
    for (const MarkingEntry& entry : estimator_->belief()) {
      belief_.push_back({{plant_.modes(entry.marking, entry.values), {}}, entry.probability});
    }
    estimate_.modes = belief_.front().state.modes;
    estimate_.probability = belief_.front().probability;
    estimate_.consistent = update.explained;
    estimate_.follows = update.possible;
    estimate_.set_aside = update.set_aside;
    estimate_.surprised.assign(update.set_aside.empty() ? 0 : plant_.plant().components.size(), false);
    for (std::size_t c = 0; c < estimate_.surprised.size(); ++c) {
      const std::size_t variable = plant_.plant().components[c].mode.index();
      estimate_.surprised[c] = variable < update.surprised.size() && update.surprised[variable];
    }
    estimate_.cut = update.cut;
    estimate_.checked = update.checked;
    estimate_.missing_mass = update.missing_mass;
    estimate_.missing_total = update.missing_total;
    return estimate_;
  }

  const automata::MarkedPlant& plant_;
  std::unique_ptr<MarkingEstimator> estimator_;
  Belief belief_;
  Estimate estimate_;
};

}  // namespace

std::unique_ptr<Estimator> make_marked_estimator(const automata::ModelProgram& program,
                                                 const automata::MarkedPlant& plant, const MarkingOptions& options) {
  return std::make_unique<MarkedEstimator>(program, plant, options);
}

}  // namespace rmpl::runtime
