// Copies of some islands of a plant's store, which differ in the mode of one component: can they look different?
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "automata/logic/theory.hpp"
#include "compiler/lint/plant/analysis.hpp"

namespace rmpl::compiler {

/// Two copies, which share the modes of the other components and the controls; attributes have a value in each.
class PlantCopies {
 public:
  /// Of the islands with these positions; guards over their attributes are given for `mean_alike`.
  PlantCopies(PlantAnalysis& analysis, automata::ComponentId component, std::vector<std::size_t> islands,
              std::vector<const automata::Formula*> guards);

  /// Whether in the same modes of the others (reached ones, possible with either mode) and under the same command the
  /// same observations of these islands are possible in both modes. Nothing where too many had to be looked at.
  std::optional<bool> look_alike(automata::ModeId a, automata::ModeId b);
  /// Whether there are such modes of the others and such a command. Of all islands that the component's mode has a part
  /// in. Nothing where too many had to be looked at.
  std::optional<bool> go_with_the_same(automata::ModeId a, automata::ModeId b);
  /// Whether it is proved that then also each guard holds in both modes or in neither.
  bool mean_alike(automata::ModeId a, automata::ModeId b);
  /// Attributes among these that are not observed, and differ wherever the modes do.
  std::vector<automata::VariableId> would_tell(automata::ModeId a, automata::ModeId b,
                                               std::span<const automata::VariableId> attributes);

 private:
  using Formula = automata::Formula;
  using VariableId = automata::VariableId;
  struct Copies {
    VariableId first, second;
  };

  void collect();
  automata::Variables declare();
  void tell();
  [[nodiscard]] VariableId map(VariableId variable, bool second) const;
  [[nodiscard]] Formula copied(const Formula& formula, bool second) const;
  [[nodiscard]] Formula differ() const;
  [[nodiscard]] std::vector<automata::Assignment> in(automata::ModeId a, automata::ModeId b) const;
  bool allows(std::span<const automata::Assignment> assumptions, const Formula& formula);
  [[nodiscard]] Formula constraint(automata::ModeId mode) const;
  bool equal_constraints(automata::ModeId a, automata::ModeId b);
  bool value_tells(automata::ModeId a, automata::ModeId b);
  /// What the mode makes of each observed attribute; nothing of one that it leaves open, or where the mode is
  /// impossible.
  using Told = std::vector<std::optional<automata::ValueId>>;
  const Told& told_by(automata::ModeId mode);
  /// Whether nothing but the mode decides what is seen, and the modes make a reading differ.
  bool told_apart(automata::ModeId a, automata::ModeId b);
  std::optional<bool> explains_all(automata::ModeId a, automata::ModeId b);
  [[nodiscard]] std::vector<automata::Assignment> context() const;
  std::optional<bool> is_state(automata::ModeId a, automata::ModeId b, std::vector<automata::Assignment> context);

  PlantAnalysis& analysis_;
  const automata::Plant& plant_;
  automata::ComponentId component_;
  std::vector<std::size_t> islands_;
  std::vector<automata::ComponentId> others_;  ///< whose modes the islands read
  automata::Support beside_;  ///< what all islands read that the component's mode has a part in, but it
  std::vector<VariableId> controls_, copied_, observed_;
  std::map<VariableId, Copies> copies_;
  std::vector<const Formula*> guards_;
  bool read_by_interconnections_ = false;  ///< the component's mode is
  std::optional<automata::Theory> theory_;
  std::vector<std::optional<Told>> told_;  ///< by mode, where it was asked
};

}  // namespace rmpl::compiler
