// A target in steps, a search, the evidence.
// SPDX-License-Identifier: MIT
#include "verifier/marking/check.hpp"

#include <array>
#include <utility>

#include "base/check.hpp"
#include "verifier/marking/commands.hpp"
#include "verifier/marking/replay.hpp"
#include "verifier/marking/search.hpp"

namespace rmpl::verifier {

using automata::Command;
using automata::Condition;
using automata::Marking;
using automata::MarkingStep;
using automata::MarkingStore;
using automata::ModelProgram;
using automata::Ticks;

namespace {

class Check {
 public:
  Check(const ModelProgram& program, const MarkingQuestion& question, const Limits& limits)
      : program_(program),
        question_(question),
        meter_(limits),
        step_(program),
        asked_{Condition{true, question.formula}, Condition{false, automata::negation(question.formula)}},
        store_(program, asked_),
        free_(free_commands(program, question.commands)) {}

  MarkingAnswer run() {
    MarkingAnswer answer;
    const bool safety = question_.kind == MarkingQuestion::Kind::safety;
    try {
      const MarkingFound found = search();
      answer.startless = found.startless;
      if (!found.path.empty()) answer.witness = evidence(found);
      answer.stuck = !answer.witness && found.stuck;
      answer.vacuous = safety && !answer.witness && store_.possible({}) && !holds({}, false);
      answer.verdict = answer.witness.has_value() != safety ? Verdict::holds : Verdict::violated;
    } catch (const LimitReached& reached) {
      answer.limit = reached.limit;
    }
    answer.progress = meter_.progress();
    return answer;
  }

 private:
  [[nodiscard]] bool holds(const Marking& marking, bool entailed) {
    return store_.holds(entailed ? 0 : 1, marking, Command(program_.controls.size()));
  }

  /// In time: with no more improbable draws than so many. A witness with n of them is looked for before one with n + 1.
  MarkingFound search() {
    MarkingTarget target{.accepts = [this](const Marking& marking) { return holds(marking, question_.entailed); },
                         .first = first_step(),
                         .last = last_step(),
                         .improbable = question_.improbable};
    if (question_.window.not_before && question_.window.not_before->is_infinite()) return {};
    if (target.last && *target.last < target.first) return {};
    if (!question_.fewest_improbable) return find_marking(step_, free_, target, meter_);
    for (unsigned n = 0;; ++n) {
      target.improbable = n;
      MarkingFound found = find_marking(step_, free_, target, meter_);
      if (!found.path.empty() || !found.cut || n == question_.improbable) return found;
    }
  }

  [[nodiscard]] std::uint64_t first_step() const {
    if (!question_.window.not_before) return 0;
    const std::int64_t period = question_.period.count;
    const std::int64_t time = question_.window.not_before->count;
    return static_cast<std::uint64_t>(time / period + (time % period == 0 ? 0 : 1));
  }
  [[nodiscard]] std::optional<std::uint64_t> last_step() const {
    if (!question_.window.by || question_.window.by->is_infinite()) return std::nullopt;
    return static_cast<std::uint64_t>(question_.window.by->count / question_.period.count);
  }

  MarkingWitness evidence(const MarkingFound& found) {
    MarkingWitness witness;
    for (const MarkingFound::State& state : found.path) {
      MarkingEvent& event = witness.events.emplace_back();
      event.marking = state.marking;
      event.command = witness.events.size() > 1 ? free_[state.command] : Command(program_.controls.size());
      event.values = store_.values(state.marking);
    }
    if (const auto failure = replay(program_, question_, found.improbable, witness)) {
      throw base::InternalError("a witness fails: " + *failure);
    }
    return witness;
  }

  const ModelProgram& program_;
  const MarkingQuestion& question_;
  Meter meter_;
  MarkingStep step_;
  std::array<Condition, 2> asked_;  ///< entailed, and allowed: its negation is not entailed
  MarkingStore store_;
  std::vector<Command> free_;
};

}  // namespace

MarkingAnswer check(const ModelProgram& program, const MarkingQuestion& question, const Limits& limits) {
  return Check(program, question, limits).run();
}

}  // namespace rmpl::verifier
