// Moments as cycles that have ended.
// SPDX-License-Identifier: MIT
#include "runtime/executive/step/trace_steps.hpp"

#include <utility>

#include "automata/store/model.hpp"
#include "runtime/executive/trace/told_estimator.hpp"
#include "runtime/reasoning/estimate/insight.hpp"

namespace rmpl::runtime {

TraceSteps::TraceSteps(const automata::Plant& plant, const automata::Program& program, const std::string& text,
                       const std::string& name)
    : plant_(plant), program_(program), theory_(automata::model_theory(plant)) {
  moments_ = read_moments(plant, program, text, name);
  estimator_ = std::make_unique<ToldEstimator>();
  tell_changes();
}

TraceSteps::~TraceSteps() = default;

void TraceSteps::tell_changes() {
  for (std::size_t i = 1; i < moments_.size(); ++i) {
    const auto changes = [&](const automata::Modes& before, const automata::Modes& now, const char* word) {
      for (std::size_t c = 0; c < now.size(); ++c) {
        if (before[c] == now[c]) continue;
        const automata::Component& component = plant_.components[c];
        moments_[i].story.push_back(std::string(word) + component.name + ": " +
                                    component.modes[before[c].index()].name + " -> " +
                                    component.modes[now[c].index()].name);
      }
    };
    const TraceMoment& before = moments_[i - 1];
    if (before.truth && moments_[i].truth) changes(*before.truth, *moments_[i].truth, "plant: ");
    if (!moments_[i].stop.of_witness) changes(before.estimate, moments_[i].estimate, "estimate: ");
  }
}

bool TraceSteps::advance(const Look& look) {
  if (at_ + 1 >= moments_.size()) return false;
  const TraceMoment& moment = moments_[++at_];
  story_.insert(story_.end(), moment.story.begin(), moment.story.end());
  if (!look) return true;
  estimator_->set(moment.estimate, moment.set_aside, {{{moment.estimate, {}}, 1.0}});
  record_.cycle = moment.stop.cycle;
  record_.time = moment.stop.time;
  record_.command = moment.command;
  record_.observations = moment.observations;
  record_.set_aside = moment.set_aside;
  record_.estimate = moment.estimate;
  record_.estimator = estimator_.get();
  record_.truth = moment.truth ? &*moment.truth : nullptr;
  record_.outcome = moment.no_plan ? Reconfiguration::Outcome::no_plan : Reconfiguration::Outcome::nothing_to_do;
  look(record_, moment.stop.ended);
  return true;
}

std::string TraceSteps::cannot_answer(const automata::Formula& formula) const {
  std::vector<automata::Formula> atoms;
  collect_knowledge(formula, atoms);
  for (const automata::Formula& atom : atoms) {
    const bool of_all = (atom.knowing == automata::Knowing::surprise || atom.knowing == automata::Knowing::no_plan) &&
                        !about(plant_, atom);
    if (!of_all) return "a trace does not tell " + to_text(atom, plant_.variables);
  }
  return {};
}

std::vector<std::string> TraceSteps::take_story() { return std::exchange(story_, {}); }

}  // namespace rmpl::runtime
