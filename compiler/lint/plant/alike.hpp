// Two modes of a component: does anything that is seen differ between them?
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "compiler/lint/plant/copies.hpp"

namespace rmpl::compiler {

/// Once every mode is known the islands of the store have nothing to do with each other: the modes look alike where
/// they do on each island by itself that the component's mode has a part in, the small ones first.
class AlikeQuestions {
 public:
  AlikeQuestions(PlantAnalysis& analysis, automata::ComponentId component);

  /// Whether in the same modes of the others (reached ones, possible with either mode) and under the same command the
  /// same observations are possible in both modes. Nothing where too many had to be looked at.
  std::optional<bool> look_alike(automata::ModeId a, automata::ModeId b);
  /// Whether there are such modes of the others, and such a command: where there are none, what is seen of the others
  /// may well tell the modes apart. Nothing where too many had to be looked at.
  std::optional<bool> go_with_the_same(automata::ModeId a, automata::ModeId b);
  /// Whether it is proved that then also guards of other components hold in both modes or in neither.
  bool mean_alike(automata::ModeId a, automata::ModeId b);
  /// Attributes of the component that are not observed, and differ wherever the modes do.
  std::vector<automata::VariableId> would_tell(automata::ModeId a, automata::ModeId b);

 private:
  [[nodiscard]] const automata::Island& island(std::size_t number) const;
  [[nodiscard]] bool is_large(std::size_t number) const;
  [[nodiscard]] bool reads_alike(std::size_t number, automata::ModeId a, automata::ModeId b) const;
  /// Of an island: its constraints by the mode that they stand under, and whether any reads the mode besides.
  struct Written {
    std::vector<std::vector<const automata::Formula*>> under;
    bool reads_mode = false;
  };
  [[nodiscard]] Written written(std::size_t number) const;
  PlantCopies& copies(std::size_t number);
  PlantCopies& whole();

  PlantAnalysis& analysis_;
  automata::ComponentId component_;
  std::vector<std::size_t> islands_;                  ///< by size
  std::vector<Written> written_;                      ///< by island
  std::vector<std::unique_ptr<PlantCopies>> copies_;  ///< by island, where it was asked
  std::unique_ptr<PlantCopies> whole_;                ///< of all that guards of others read, with these guards
};

}  // namespace rmpl::compiler
