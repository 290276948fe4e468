// Readings that a few modes leave open, whatever all other components do: what the bound of the search knows of the
// observation factor.
//
// A patch is a set of attributes with all constraints that read one of them; the border are the other attributes that
// these read. If the constraints, under the modes of the components that they belong to, allow another value of the
// reading beside every border that they allow at all, then no modes of other components imply the reading: any world
// of the store can be changed inside the patch alone. The patch grows from the observed attribute, by the border
// attributes that a counterexample rests on, and is made minimal by deletion.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/openings.hpp"

namespace rmpl::runtime {

class OpenReadings {
 public:
  /// Keeps references. Looks at the plant when it is first asked, but for its openings where these are known.
  explicit OpenReadings(automata::PlantStep& step, const Openings* openings = nullptr)
      : step_(step), plant_(step.plant()), openings_(openings) {}

  /// What single components leave open; worked out when it is first asked for.
  const Openings& openings() {
    if (openings_ == nullptr) openings_ = &own_openings_.emplace(plant_);
    return *openings_;
  }
  /// Components whose modes in `modes` are enough to leave `reading` (of an attribute) unimplied, ascending; nothing
  /// where none were found: the reading is implied, or it would have taken too much work. Remembered by those modes.
  /// The pointer lasts until the next call.
  const std::vector<automata::ComponentId>* components(const automata::Modes& modes, automata::Assignment reading);

  /// Whether there may be modes that imply `reading` and do not contradict each other: false only where each choice of
  /// modes was shown to leave it open, or not to allow it. Remembered.
  bool may_be_implied(automata::Assignment reading);

 private:
  using Attribute = std::uint32_t;  ///< position of a variable, the first of those that are always equal
  /// A conjunct of the store.
  struct Told {
    std::optional<automata::Assignment> under;
    automata::Formula formula;
    std::vector<Attribute> attributes;
    std::vector<automata::ComponentId> components;  ///< whose modes it reads, the one that it is under among them
  };
  struct Patch {
    std::vector<Attribute> inside;  ///< the reading's first
    std::vector<Attribute> border;
    std::vector<std::uint32_t> told;
    std::vector<automata::ComponentId> components;
  };
  /// What was found out of a reading under some modes.
  struct Lemma {
    std::vector<automata::ComponentId> components;
    std::vector<automata::ModeId> modes;
    bool open;
  };
  enum class Finding : std::uint8_t { open, implied, unknown };

  void look_at_plant();
  void merge_equals();
  void index_readers();
  [[nodiscard]] Patch patch(std::vector<Attribute> inside, const automata::Modes& modes) const;
  bool leaves_open(const automata::Modes& modes, automata::Assignment reading);
  bool implied_by(const automata::Modes& modes, automata::Assignment reading);
  Lemma work_out(const automata::Modes& modes, automata::Assignment reading);
  bool look_for_modes_that_imply(automata::Assignment reading);
  std::optional<Patch> open_patch(const automata::Modes& modes, automata::Assignment reading);
  /// Whether every border of the patch allows another value; where one does not, it is left in `value_`.
  Finding judge(const Patch& patch);
  bool every_border(const Patch& patch, std::size_t depth);
  /// The border attributes that the counterexample rests on.
  std::vector<Attribute> blame(const Patch& patch);
  /// The attributes `free` are to be chosen, the other ones have values.
  void prepare(const Patch& patch, const std::vector<Attribute>& free);
  /// Whether what is told of the patch can hold; `other`: the reading not being so.
  bool solvable(bool other);
  bool assign(std::size_t depth);

  automata::PlantStep& step_;
  const automata::Plant& plant_;
  const Openings* openings_;
  std::optional<Openings> own_openings_;                     ///< where nobody else has them
  std::vector<std::optional<automata::ComponentId>> owner_;  ///< by variable
  std::vector<Attribute> equal_;                             ///< by variable
  std::vector<Told> told_;
  std::vector<std::vector<std::uint32_t>> readers_;               ///< by attribute: positions in `told_`
  std::unordered_map<std::uint64_t, std::vector<Lemma>> lemmas_;  ///< by reading; looked up, never iterated
  std::unordered_map<std::uint64_t, bool> implied_;               ///< by reading: `may_be_implied`

  // The last question to the theory that was asked for modes.
  automata::Modes told_modes_;
  std::vector<automata::Assignment> store_;  ///< of `told_modes_`
  std::size_t questions_ = 0;                ///< that were asked in all when it was answered
  bool possible_ = false;

  // While one reading is worked out.
  const automata::Modes* modes_ = nullptr;
  Attribute read_ = 0;
  automata::ValueId seen_;
  std::size_t work_ = 0;                                 ///< assignments that may still be tried
  std::vector<std::optional<automata::ValueId>> value_;  ///< by attribute
  std::vector<Attribute> order_;                         ///< attributes to be assigned, in order
  std::vector<std::vector<std::uint32_t>> due_;          ///< by depth: what can be judged then
  bool other_ = false;
};

}  // namespace rmpl::runtime
