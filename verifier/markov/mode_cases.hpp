// A function of the modes of some components with few values, as conditions on those that decide it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::verifier {

/// A component is in a mode.
struct InMode {
  automata::ComponentId component;
  automata::ModeId mode;
  auto operator<=>(const InMode&) const = default;
};

/// Where some combination holds. None at all: nowhere; one of no modes: everywhere.
using Condition = std::vector<std::vector<InMode>>;

/// For combinations of modes of some components, a number each; asked where each number is.
class ModeCases {
 public:
  explicit ModeCases(std::vector<automata::ComponentId> components) : components_(std::move(components)) {}

  /// `modes` are those of the components, in their order. Combinations that are never added may come out anywhere.
  void add(std::vector<automata::ModeId> modes, std::size_t number) { rows_.emplace_back(std::move(modes), number); }

  /// By number, up to the greatest one: where it is. Components that decide nothing are left out.
  [[nodiscard]] std::vector<Condition> conditions() const;

 private:
  using Row = std::pair<std::vector<automata::ModeId>, std::size_t>;

  std::vector<automata::ComponentId> components_;
  std::vector<Row> rows_;
};

}  // namespace rmpl::verifier
