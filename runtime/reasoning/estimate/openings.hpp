// Readings that components leave open whatever the modes of all others are, by elimination: no choice of modes that has
// theirs implies the reading. It depends on the plant alone.
//
// Attributes that always find a value are taken away, effects before their causes (elimination.hpp). What an attribute
// took away when it went is all that still read it: where that leaves it another value, the world can be changed there,
// and what went before it follows suit. An unknown mode in a chain opens what comes out of it however much is behind,
// and what is a copy of that as long as it is one.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::runtime {

/// Where the component is in one of the modes, the reading is open.
struct Opening {
  automata::ComponentId component;
  std::vector<bool> modes;
};

class Openings {
 public:
  /// Works out what the observables of a plant rest on. Costs about what the theories of its islands do.
  explicit Openings(const automata::Plant& plant);

  /// What opens the reading by itself; null where nothing is known to. Of several components it is the one with the
  /// most such modes, of these the first.
  [[nodiscard]] const Opening* of(automata::Assignment reading) const;
  /// Makes `components` those whose modes in `modes` are enough to leave the reading open, ascending, by what it is a
  /// copy of under these; false where that tells nothing.
  [[nodiscard]] bool opened_by(const automata::Modes& modes, automata::Assignment reading,
                               std::vector<automata::ComponentId>& components) const;

 private:
  struct Analysis;
  /// A constraint that an attribute took away.
  struct Told {
    std::optional<std::pair<automata::ComponentId, automata::ModeId>> under;
    std::optional<automata::VariableId> equal;  ///< says that the attribute is equal to this one, and no more
  };
  struct Attribute {
    std::vector<Told> told;
    std::vector<automata::ComponentId> components;  ///< whose modes these read
    std::vector<std::optional<Opening>> openings;   ///< by value
  };
  [[nodiscard]] const Attribute* find(automata::VariableId variable) const;

  std::unordered_map<automata::VariableId, Attribute> attributes_;  ///< looked up, never iterated
};

/// What the openings make of the factor of an observation: modes are worth the product of `of` over their components at
/// most, as no reading is counted twice.
class OpeningFactors {
 public:
  /// Keeps references to the openings.
  OpeningFactors(const automata::Plant& plant, const Openings& openings, const automata::Observation& observation);

  /// The product of 1/m over the readings that the component leaves open in the mode.
  [[nodiscard]] double of(std::size_t component, automata::ModeId mode) const {
    return opens(component) ? factors_[place_[component]][mode.index()] : 1.0;
  }
  /// The same by mode, of a component that opens something.
  [[nodiscard]] const std::vector<double>& of(std::size_t component) const { return factors_[place_[component]]; }
  /// What opens the i-th reading of the observation by itself, or null.
  [[nodiscard]] const Opening* opening(std::size_t i) const { return openings_[i]; }
  /// Whether the component leaves any reading open by itself.
  [[nodiscard]] bool opens(std::size_t component) const { return !place_.empty() && place_[component] != none; }
  /// Whether no component does.
  [[nodiscard]] bool empty() const { return place_.empty(); }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<const Opening*> openings_;  ///< by reading
  std::vector<std::uint32_t> place_;      ///< by component, in `factors_`; empty where no component opens anything
  std::vector<std::vector<double>> factors_;
};

}  // namespace rmpl::runtime
