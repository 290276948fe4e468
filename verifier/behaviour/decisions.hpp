// Decisions: answers about modes under a control action, looked up by the little that decides them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "automata/state.hpp"

namespace rmpl::verifier {

/// One assumption: a position among the components, then the controls, and which mode or value it has.
struct Premise {
  std::uint32_t position;
  std::uint32_t value;
};

/// A tree that asks one position after another, and grows where a question comes to that it has no answer for: there
/// by the premises of that answer that have not been asked for yet. So a look costs as many steps as there are premises
/// on the way, however many answers there are. What decides other cases can be asked for in vain, as in any decision
/// tree; where that leads to a new place, the reasons of the first answers are looked through for one that holds there.
class Decisions {
 public:
  Decisions() : nodes_(1) {}

  /// The answer where the premises of one hold; else nothing.
  [[nodiscard]] std::optional<std::uint32_t> find(const automata::Modes& modes, const automata::ControlAction& action);
  /// Adds what `find` had no answer for. The premises hold there, and are enough for the answer. Tree and reasons stop
  /// growing at some size.
  void add(const automata::Modes& modes, const automata::ControlAction& action, const std::vector<Premise>& premises,
           std::uint32_t answer);

 private:
  enum class Kind : std::uint8_t { open, test, answer };
  struct Node {
    Kind kind = Kind::open;
    std::uint32_t number = 0;         ///< the position that is asked for, or the answer
    std::vector<std::uint32_t> next;  ///< by value; 0: none yet
  };

  /// Premises that are enough for an answer.
  struct Reason {
    std::vector<Premise> premises;
    std::uint32_t answer;
  };

  void graft(const automata::Modes& modes, const automata::ControlAction& action, const Reason& reason);

  std::vector<Node> nodes_;  ///< the root first
  std::vector<Reason> reasons_;
};

}  // namespace rmpl::verifier
