// One step of a PHCA: the rules (marking_rules.hpp) over its store (marking_store.hpp), with a memory of markings.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "automata/step/marking_rules.hpp"
#include "automata/step/marking_store.hpp"

namespace rmpl::automata {

/// Every marking that is met has a number, under which answers about it are kept. Not for two threads at once. Keeps a
/// reference to the program.
class MarkingStep {
 public:
  using Number = std::uint32_t;
  /// A consistent marking that a step leads to.
  struct Way {
    Number target;
    double probability;
  };
  /// In order of marking; nothing where they were too many to be listed.
  using Ways = std::optional<std::vector<Way>>;

  /// `most_ways`: out of one marking, that are listed.
  explicit MarkingStep(const ModelProgram& program, std::size_t most_ways = std::size_t{1} << 12);

  [[nodiscard]] const ModelProgram& program() const { return rules_.program(); }
  [[nodiscard]] const MarkingRules& rules() const { return rules_; }
  [[nodiscard]] MarkingStore& store() { return store_; }

  /// The number of a marking, given by its primitive locations, and the marking of a number.
  Number number(const Marking& primitive);
  [[nodiscard]] const Marking& operator[](Number number) const { return markings_[number]; }
  /// The same with the composites that hold them. Lasts until the next call.
  const Marking& whole(Number number);
  /// Forgets what is not among these markings, and gives them new numbers, 0, 1, …, where too much is kept; whether it
  /// did.
  bool forget_but(const std::vector<Number>& kept);

  /// From here on questions are about this command and these readings.
  void command(const Command& command);
  [[nodiscard]] const Command& current_command() const { return *command_; }
  void observe(const Observation& observation);

  /// What the store of a possible marking entails, by variable. Lasts until the next call.
  const std::vector<Assignment>& values(Number marking);
  /// The start markings that are consistent; not normalised.
  Ways initial();
  /// Whether the store of the marking can hold, and whether it can together with the command.
  bool possible(Number marking);
  bool permits(Number marking);
  /// What a marking that the command permits may lead to, consistent or not. The reference lasts until the command
  /// changes, or `forget_but`.
  const MarkingMoves& moves(Number marking);
  /// The same listed; without an entry where the command does not permit the marking. Lasts as long.
  const Ways& ways(Number marking);
  /// Of a marking that cannot be, or with `seen` does not explain what is seen: the locations to blame.
  Marking conflict(Number marking, bool seen);
  /// The observation factor.
  double factor(Number marking);

 private:
  enum class Known : std::uint8_t { open, yes, no };
  /// Answers under one command.
  struct Commanded {
    std::vector<Known> permits;
    std::vector<std::unique_ptr<const MarkingMoves>> moves;
    std::vector<std::unique_ptr<const Ways>> ways;
  };
  Ways listed(const MarkingMoves& moves, std::size_t most);
  template <class Answers>
  auto& slot(Answers& answers, Number marking);

  std::size_t most_ways_;
  MarkingRules rules_;
  MarkingStore store_;
  std::vector<Marking> markings_;
  std::vector<Marking> wholes_;  ///< empty where it was not asked for
  std::vector<std::optional<std::vector<Assignment>>> values_;
  struct Hash {
    std::size_t operator()(const Marking& marking) const noexcept;
  };
  std::unordered_map<Marking, Number, Hash> numbers_;  ///< looked up, never iterated
  std::vector<Known> possible_;
  std::map<Command, Commanded> by_command_;
  std::map<Observation, std::vector<double>> by_observation_;  ///< a factor below 0 is open
  const Command* command_ = nullptr;
  Commanded* commanded_ = nullptr;
  const Observation* observation_ = nullptr;
  std::vector<double>* factors_ = nullptr;
};

}  // namespace rmpl::automata
