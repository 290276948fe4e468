// Supports: which modes and controls an answer of the store can depend on.
//
// A question to the store assumes a mode for every component. Two attributes then have to do with each other only where
// one conjunct of a constraint, of Q or of one mode, reads both: the attributes fall into islands, and the store is
// consistent if it is on every island by itself. What it implies of one island's attributes depends on the modes of the
// few components whose constraints touch it (the idea of decomposition in Williams & Nayak, A Reactive Planner for a
// Model-based Executive, 1997; here for the store).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "automata/dependencies/dependencies.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::automata {

/// What is read: components for their modes, and controls, by position in `Plant::controls`; both ascending.
struct Support {
  std::vector<ComponentId> components;
  std::vector<std::size_t> controls;
  bool operator==(const Support&) const = default;

  void join(const Support& other);
  [[nodiscard]] bool reads(ComponentId component) const;
  [[nodiscard]] bool reads_control(std::size_t control) const;
};

/// Attributes that have to do with each other once every mode is known (dependencies.hpp).
struct Island {
  Support support;
  std::vector<VariableId> attributes;   ///< ascending; controls among them, unless the command is known, too
  std::vector<Constraint> constraints;  ///< those that read it: without any it is consistent whatever is assumed
};

/// The islands of a plant, each with its support.
class Locality {
 public:
  /// Whether the command is assumed beside the modes.
  enum class Commanded : bool { no, yes };

  explicit Locality(const Dependencies& dependencies, Commanded commanded = Commanded::no);
  explicit Locality(const Plant& plant) : Locality(Dependencies(plant)) {}

  [[nodiscard]] const std::vector<Island>& islands() const { return islands_; }
  /// Has an island read more, or adds one without constraints that reads this; its number.
  void widen(std::size_t island, const Support& support) { islands_[island].support.join(support); }
  std::size_t add(Support support) {
    islands_.push_back({std::move(support), {}, {}});
    return islands_.size() - 1;
  }
  /// The island of a variable; none for a mode variable, and a control of a known command.
  [[nodiscard]] std::optional<std::size_t> island_of(VariableId variable) const { return island_of_[variable]; }
  /// What it depends on whether a consistent store implies, or allows, the formula.
  [[nodiscard]] Support support_of(const Formula& formula) const;

 private:
  PlantIndex index_;
  Classes island_of_;
  std::vector<Island> islands_;  ///< those of constraints on modes alone come last
};

/// Packs the modes and controls of a support into words, as a key for what is remembered about them.
class Projection {
 public:
  using Key = std::vector<std::uint64_t>;

  Projection(const Plant& plant, const Support& support);

  /// Writes the key of these modes and controls; `action` is not looked at where no control is read.
  void read(const Modes& modes, const ControlAction& action, Key& key) const;
  /// Bits that a key uses.
  [[nodiscard]] std::size_t bits() const { return bits_; }

 private:
  struct Field {
    std::uint32_t position;  ///< in the modes or in the control action
    std::uint32_t shift;     ///< from bit 0 of the first word; a field does not cross words
  };
  void place(std::size_t position, std::size_t values, std::vector<Field>& fields);

  std::vector<Field> modes_, controls_;
  std::size_t bits_ = 0;
};

}  // namespace rmpl::automata
