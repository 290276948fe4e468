// One step of a THCA: the rules, and the theory that answers them.
// SPDX-License-Identifier: MIT
#include "automata/step/program_step.hpp"

#include <algorithm>
#include <utility>

#include "automata/store/model.hpp"
#include "base/bounded_cache.hpp"
#include "base/check.hpp"

namespace rmpl::automata {

/// What the rules ask, by what the program knows now.
class ProgramStep::Answers final : public ProgramAnswers {
 public:
  explicit Answers(ProgramStep& step) : step_(step) {}
  bool maintained(LocationId location) override { return step_.holds(step_.maintenance_[location.index()]); }
  bool guard_holds(LocationId location, std::size_t arc) override {
    return step_.holds(step_.guards_[location.index()][arc]);
  }
  bool achieved(LocationId location) override { return step_.entailed(step_.goals_[location.index()]); }

 private:
  ProgramStep& step_;
};

ProgramStep::ProgramStep(const Program& program, const Plant& plant) : rules_(program), theory_(model_theory(plant)) {
  initialise();
}

ProgramStep::ProgramStep(const Program& program) : rules_(program), theory_(program.variables) { initialise(); }

void ProgramStep::initialise() {
  asked_ = knowledge_asked_by(rules_.program());
  for (const Location& location : rules_.program().locations) {
    goals_.push_back(question(goal_of(location)));
    maintenance_.push_back(compile(location.maintenance));
    auto& guards = guards_.emplace_back();
    for (const Arc& arc : location.arcs) guards.push_back(compile(arc.guard));
  }
  reset();
}

std::size_t ProgramStep::question(const Formula& formula) {
  questions_.push_back({theory_.encode(formula), std::nullopt});
  return questions_.size() - 1;
}

ProgramStep::Compiled ProgramStep::compile(const Condition& condition) {
  if (!is_of_states(condition.constraint)) return {&condition, std::nullopt, {}};
  return {&condition, question(condition.constraint), {}};
}

void ProgramStep::know(const Knowledge& knowledge) {
  answers_ = knowledge.answers;
  if (known_ == knowledge.assignments && base::caches_on()) return;
  known_ = knowledge.assignments;
  for (Question& q : questions_) q.entailed.reset();
}

bool ProgramStep::entailed(std::size_t question) {
  auto& answer = questions_[question].entailed;
  if (!answer) answer = theory_.entails(known_, questions_[question].handle);
  return *answer;
}

bool ProgramStep::holds(Compiled& compiled) {
  const Condition& condition = *compiled.condition;
  if (condition.is_trivial()) return true;
  if (compiled.question) return entailed(*compiled.question) == condition.entailed;
  Formula now = with_clocks(condition.constraint, [&](ClockId clock) -> const Ticks* {
    const auto& reading = readings_[clock.index()];
    return reading ? &*reading : nullptr;
  });
  if (!asked_.empty()) {
    now = with_knowledge(now, [&](const Formula& atom) {
      const auto position = static_cast<std::size_t>(std::find(asked_.begin(), asked_.end(), atom) - asked_.begin());
      return position < answers_.size() && answers_[position];
    });
  }
  auto known = std::find_if(compiled.variants.begin(), compiled.variants.end(),
                            [&](const auto& variant) { return variant.first == now; });
  if (known == compiled.variants.end()) {
    const std::size_t asked = question(now);
    known = compiled.variants.insert(known, {std::move(now), asked});
  }
  return entailed(known->second) == condition.entailed;
}

void ProgramStep::reset() {
  started_.assign(rules_.program().clocks.size(), std::nullopt);
  readings_ = started_;
  half_.started = started_;
  marking_ = rules_.initial();
}

void ProgramStep::resume(Marking marking, ClockTimes started) {
  CHECK(started.size() == rules_.program().clocks.size() && "one entry a clock");
  marking_ = std::move(marking);
  started_ = std::move(started);
}

const Asserted& ProgramStep::begin(const Knowledge& knowledge, Ticks now) {
  know(knowledge);
  readings_ = ProgramRules::readings(started_, now);
  Answers answers(*this);
  rules_.begin(marking_, started_, now, answers, half_, asserted_);
  return asserted_;
}

void ProgramStep::finish(const Knowledge& knowledge) {
  know(knowledge);
  Answers answers(*this);
  marking_ = rules_.finish(half_, answers, started_);
}

}  // namespace rmpl::automata
