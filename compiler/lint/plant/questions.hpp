// What can be in a plant whose components are kept to some of their modes: the one place where lint of plants asks SAT.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "automata/dependencies/dependencies.hpp"
#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/store/support.hpp"

namespace rmpl::compiler {

/// A mode of a component, as an assignment of its mode variable, is what states are abstracted to: any component may be
/// in any of the modes that it is kept to, whatever the others are in.
using ModeSets = std::vector<std::vector<bool>>;  ///< by component, by mode

/// Whether guards can follow together from modes and a command.
struct Implied {
  enum class Verdict {
    yes,   ///< under `context` they do
    no,    ///< nothing implies them all
    open,  ///< so many were tried in vain, and not all
  };
  Verdict verdict = Verdict::open;
  /// Modes and controls that decide it; of `no`, the last that were tried, if the guards can hold at all.
  std::vector<automata::Assignment> context;
  /// What the guards read, with values that it has there.
  std::vector<automata::Assignment> read;
  /// Of `no`: the modes that components are not kept to, to which it is due; assignments of mode variables.
  std::vector<automata::Assignment> due_to;
};

/// Keeps a reference to the plant. Not for use from two threads at once. All questions go to one theory of the whole
/// plant, which maintains a model: what a question costs is what it changes. A question about some parts of the plant
/// (`Dependencies::parts`) leaves the others alone, where these can be as they are kept.
class PlantQuestions {
 public:
  explicit PlantQuestions(const automata::Plant& plant);

  [[nodiscard]] const automata::Plant& plant() const { return plant_; }
  [[nodiscard]] const automata::Locality& locality() const { return locality_; }
  /// `Dependencies::parts` of the plant.
  [[nodiscard]] const automata::Classes& parts() const { return parts_; }

  /// From here on components are in these modes only.
  void keep_to(const ModeSets& modes);
  /// This mode too.
  void allow(automata::ComponentId component, automata::ModeId mode);

  /// Whether some state and command satisfy assumptions and formula. A component whose mode is assumed is in it, kept
  /// to it or not.
  bool possible(std::span<const automata::Assignment> assumptions, const automata::Formula& formula);
  bool possible(std::span<const automata::Assignment> assumptions);
  /// After a question that was answered with no: as `Implied::due_to`.
  [[nodiscard]] std::vector<automata::Assignment> due_to() const;
  /// After one that was answered with yes: the value of a variable there.
  [[nodiscard]] automata::ValueId value(automata::VariableId variable) const { return theory_.value(variable); }

  /// Then also: the modes and controls of a support.
  [[nodiscard]] std::vector<automata::Assignment> context(const automata::Support& support) const;

  /// Whether some possible modes, with the component in `mode`, and some command that they allow imply all of the
  /// guards. Commands that contradict the modes are left out: from them everything follows.
  Implied implied(automata::ComponentId component, automata::ModeId mode,
                  std::span<const automata::Formula* const> guards);
  /// Whether modes and controls, which are possible together and all that it depends on, imply the formula.
  bool follows(std::span<const automata::Assignment> context, const automata::Formula& formula);

 private:
  /// The assumptions with the exclusions of all components that they and the variables have to do with.
  std::vector<automata::Assignment> assumed(std::span<const automata::Assignment> assumptions,
                                            std::span<const automata::VariableId> variables);
  /// Whether the components can be in the modes that they are kept to, all at once.
  bool all_can_be();
  [[nodiscard]] automata::Assignment exclusion(automata::ComponentId component, std::size_t mode) const;
  [[nodiscard]] std::vector<automata::Assignment> values(std::span<const automata::VariableId> variables) const;
  bool try_nominal(automata::ComponentId component, automata::ModeId mode, const automata::Formula& together,
                   const automata::Support& support);

  const automata::Plant& plant_;
  automata::Locality locality_;
  automata::PlantIndex index_;
  /// By component, its first variable "not in mode 0"; then the first of a search for what implies a guard.
  std::vector<std::size_t> first_exclusion_;
  automata::Theory theory_;
  std::vector<std::vector<automata::Assignment>> excluded_;  ///< by component, what is assumed of its exclusions
  automata::Classes parts_;
  std::vector<std::vector<std::size_t>> components_;  ///< by part
  std::optional<bool> all_can_be_;                    ///< as far as it was asked
  std::size_t searches_ = 0;                          ///< so far
  std::size_t tried_ = 0;                             ///< modes and commands that left a guard open, in all searches
};

/// All modes of all components.
ModeSets all_modes(const automata::Plant& plant);

}  // namespace rmpl::compiler
