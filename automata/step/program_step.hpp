// One step of a THCA: the ten steps of thesis Fig. 5-3 (semantics 2), the rules over what a program knows.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "automata/state.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::automata {

/// What the sequencer knows at one time: of the plant the estimated modes and the observations of that cycle, both as
/// assignments over the program's variables; of the executive what its conditions ask.
struct Knowledge {
  std::vector<Assignment> assignments;
  /// Per atom that the program asks (`knowledge_asked_by`): whether it is so. One that is missing is not.
  std::vector<bool> answers = {};
};

/// A THCA that is being executed: the rules (program_rules.hpp), with a theory of its own that answers them. Another
/// one beside it shares nothing with it. The second half of a cycle (steps 7 to 10) needs the estimate read back in
/// step 6.
class ProgramStep {
 public:
  /// For a program bound to a plant: entailment by the plant's model. Keeps references to both.
  ProgramStep(const Program& program, const Plant& plant);
  /// For the sequencer alone: entailment by the assignments and the domains of the program's own variables.
  explicit ProgramStep(const Program& program);

  /// m_F of the program; all clocks inactive.
  void reset();
  /// Takes up a run elsewhere: this marking, and when the active clocks started, by `ClockId`.
  void resume(Marking marking, ClockTimes started);
  [[nodiscard]] const Marking& marking() const { return marking_; }
  /// When the active clocks started, by `ClockId`, those of the last cycle included.
  [[nodiscard]] const ClockTimes& started() const { return started_; }
  [[nodiscard]] bool ended() const { return marking_.empty(); }
  /// What the conditions ask of the executive's knowledge, in the order in which `Knowledge` answers.
  [[nodiscard]] const std::vector<Formula>& asked() const { return asked_; }

  /// Steps 1 to 4 at absolute time `now`, with the knowledge at the start of the cycle.
  const Asserted& begin(const Knowledge& knowledge, Ticks now);
  /// Steps 7 to 10 with the knowledge read back after the command; advances the marking. May be called again, with
  /// other knowledge: every call goes on from the same `begin`.
  void finish(const Knowledge& knowledge);

  /// The readings of the active clocks as of the last `begin`, by `ClockId`; nothing where inactive.
  [[nodiscard]] const ClockTimes& clocks() const { return readings_; }

 private:
  /// A question about a formula without clocks; its answer is remembered while the knowledge stays the same.
  struct Question {
    Theory::Handle handle;
    std::optional<bool> entailed;
  };
  /// A condition, compiled: one question, or, where clocks or knowledge occur, one for each formula that their readings
  /// and answers leave: no more than there are ways to cut the clocks at the bounds that they are compared with, and
  /// to answer.
  struct Compiled {
    const Condition* condition;
    std::optional<std::size_t> question;
    std::vector<std::pair<Formula, std::size_t>> variants;
  };
  class Answers;

  void initialise();
  std::size_t question(const Formula& formula);
  Compiled compile(const Condition& condition);
  void know(const Knowledge& knowledge);
  bool entailed(std::size_t question);
  bool holds(Compiled& condition);

  ProgramRules rules_;
  Theory theory_;
  std::vector<Question> questions_;
  std::vector<Compiled> maintenance_;          ///< per location
  std::vector<std::vector<Compiled>> guards_;  ///< per location, per arc
  std::vector<std::size_t> goals_;             ///< per location: the question of its goal
  std::vector<Formula> asked_;                 ///< of the executive's knowledge
  std::vector<Assignment> known_;              ///< the knowledge that the remembered answers are about
  std::vector<bool> answers_;                  ///< of `asked_`

  Marking marking_;
  ClockTimes started_;
  ClockTimes readings_;
  HalfCycle half_;  ///< between begin and finish
  Asserted asserted_;
};

}  // namespace rmpl::automata
