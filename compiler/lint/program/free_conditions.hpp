// Conditions that one state of the plant judges together: which truths of them can be at the same time.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/program.hpp"
#include "compiler/lint/program/possibilities.hpp"

namespace rmpl::compiler {

/// What questions are answered with.
using Truths = std::map<std::size_t, bool>;

/// A question is whether a formula without clocks is entailed by what is known of a state: its modes and all that is
/// observed. Of a program without a plant, by the values of all its variables.
class FreeConditions {
 public:
  /// `stages`: what is so of states of the first kind, the second and so on, and of all from the last on; where there
  /// are none, there is one kind.
  FreeConditions(const automata::Program& program, const automata::Plant* plant,
                 std::vector<automata::Formula> stages = {});

  /// The stage that comes after another.
  [[nodiscard]] std::size_t after(std::size_t stage) const { return stage + 1 < stages_.size() ? stage + 1 : stage; }

  /// The number of the question, the same for equal formulas; nothing for a constant.
  std::optional<std::size_t> question(const automata::Formula& formula);
  /// The answer to a question that is among the truths; of a constant, the constant.
  [[nodiscard]] bool holds(const automata::Formula& formula, const Truths& truths);
  /// Calls `visit` with each way to answer the questions that is possible, in some state of the stage, together with
  /// what is given, which is among the answers; until it returns false.
  void for_each(const std::vector<std::size_t>& questions, const Truths& given, std::size_t stage,
                const std::function<bool(const Truths&)>& visit);
  /// What is answered with yes, and then what with no: "`a = on`, not `b = off`".
  [[nodiscard]] std::string text(const Truths& truths) const;

 private:
  struct Question {
    automata::Formula formula;
    std::string text;
    bool visible = true;  ///< known in every state, as it speaks of nothing hidden
  };

  bool possible(const Truths& truths, std::size_t stage);

  const automata::Variables& variables_;
  std::vector<bool> visible_;  ///< per variable
  Possibilities possibilities_;
  std::vector<Question> questions_;
  std::map<std::string, std::size_t> by_text_;
  std::vector<automata::Formula> stages_;
  std::map<std::pair<std::size_t, Truths>, bool> known_;  ///< by stage
};

}  // namespace rmpl::compiler
