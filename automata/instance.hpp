// Instances: copies of a plant under a name, within a larger one.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "automata/plant.hpp"
#include "base/function_ref.hpp"

namespace rmpl::automata {

/// `engine` and `temp` make `engine.temp`; `engine` and nothing make `engine`.
std::string qualified(std::string_view instance, std::string_view name);

/// Moves a variable, or every variable of a formula, by `offset`, up or down; domains stay as they are.
void shift(VariableId& id, std::ptrdiff_t offset);
void shift(Formula& formula, std::ptrdiff_t offset);

/// From one of a list to before another.
struct Range {
  std::size_t begin = 0, end = 0;
  [[nodiscard]] bool has(std::size_t i) const { return i >= begin && i < end; }
};

/// Neighbours in every list of a plant; none but the variables among them are spoken of.
struct PlantStretch {
  Range variables, components, interconnections, controls, observables;
};

/// From the name of a variable or component to another.
using Renaming = base::FunctionRef<std::string(const std::string&)>;

/// Puts a copy of the stretch behind what is in `to`: together and in order, so that renaming is adding an offset. The
/// new names must be new there.
void append(Plant& to, const Plant& from, const PlantStretch& stretch, Renaming renamed);

/// Puts a copy of `type` into `whole` under the name of an instance. What is named "" takes the instance's name.
void instantiate(Plant& whole, std::string_view instance, const Plant& type);

}  // namespace rmpl::automata
