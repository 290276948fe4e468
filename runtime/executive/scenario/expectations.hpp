// Judges what a scenario expects, cycle by cycle (language.md "Scenarios").
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/scenario.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/reasoning/estimate/insight.hpp"

namespace rmpl::runtime {

/// Whether it speaks of what is never to be, which is not met before the end.
bool lasts_to_the_end(const automata::Expectation& expectation);

/// What came of one expectation.
struct Judgement {
  enum class Verdict { met, failed, undecided };
  Verdict verdict = Verdict::undecided;
  std::optional<automata::Ticks> time;  ///< when it was decided
  std::string reason;                   ///< where it failed or is undecided: why
  std::string evidence;                 ///< where it failed: what was the case then; may be empty
};

/// `met`, `failed`, `undecided`.
std::string_view name_of(Judgement::Verdict verdict);

/// A condition holds when it is entailed by the model and what is known at the end of a cycle: the estimate and the
/// observations that it explains, or the true modes. What it says of controls is so or not by the command that was in
/// force in that cycle, and what it asks of the executive's knowledge by that at the end of the cycle.
class Expectations {
 public:
  /// `theory`: of the plant's model. Keeps references to all. Throws base::InputError where an expectation speaks of
  /// the truth and nothing is simulated.
  Expectations(const automata::Plant& plant, automata::Theory& theory, const automata::Program& program,
               const automata::Scenario& scenario);

  /// Looks at a cycle; `ended` says that the program has ended in it.
  void observe(const CycleRecord& record, bool ended);
  /// The run is over, with its last cycle: what is open is decided; or, where it was `interrupted`, stays undecided.
  void close(const CycleRecord& last, bool interrupted);
  /// Whether some expectation is open that more cycles may still meet or fail, aside from what is never to be: that
  /// lasts to the end.
  [[nodiscard]] bool waiting() const;
  /// Whether something that is never to be has not been.
  [[nodiscard]] bool watching() const;
  /// One a piece, in the order of the scenario.
  [[nodiscard]] const std::vector<Judgement>& judgements() const { return judgements_; }

 private:
  /// A formula asked of a sequence of knowledge that seldom changes.
  struct Question {
    const automata::Formula* formula;
    automata::Theory::Handle handle;  ///< of the formula under the command that it was asked under last
    /// Where it speaks of controls: what is known of it, by command.
    std::map<automata::ControlAction, automata::Theory::Handle> by_command;
    bool commanded = false;
    bool knows = false;  ///< it asks of the executive's knowledge: then its answers are never remembered
    bool answer = false;
  };
  /// What is known on one side, the estimate's or the truth's.
  struct Side {
    std::vector<automata::Assignment> known;
    std::vector<automata::Assignment> next;
    bool changed = false;
  };
  /// The state of one expectation.
  struct Watch {
    const automata::Expectation* expectation;
    Question condition;
    std::optional<Question> after;
    std::optional<automata::Ticks> since;  ///< when `after` came true; the start where there is none
  };

  Question ask(const automata::Formula& formula);
  bool holds_as_known(const automata::Formula& formula);
  void know(const CycleRecord& record);
  bool holds(Question& question, const Side& side);
  void judge(Watch& watch, Judgement& judgement, const CycleRecord& record, bool ended);
  [[nodiscard]] Judgement at_the_end(const Watch& watch, const CycleRecord& last) const;
  [[nodiscard]] std::string evidence(const automata::Expectation& expectation, const CycleRecord& record) const;

  const automata::Plant& plant_;
  automata::Theory& theory_;
  const automata::Program& program_;
  Side estimate_, truth_;
  automata::ControlAction command_;  ///< in force in the cycle that ends
  bool commanded_anew_ = false;
  Insight insight_;
  const CycleRecord* record_ = nullptr;  ///< that is looked at
  automata::Observation counted_;        ///< its readings that count
  std::vector<Watch> watches_;
  std::vector<Judgement> judgements_;
};

}  // namespace rmpl::runtime
