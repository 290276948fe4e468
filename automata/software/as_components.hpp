// The threads of model programs as components of a plant: their markings are modes (semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/plant.hpp"
#include "automata/software/model_component.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::automata {

/// A component that a thread became.
struct SoftwareThread {
  std::size_t model;                           ///< the program that it is of, by position
  std::vector<std::vector<Marking>> markings;  ///< per mode, all that it is of: primitive locations
};

struct SoftwarePlant {
  Plant plant;
  std::vector<SoftwareThread> threads;  ///< of the components behind those that the plant had, in order
};

/// The plant with a component more for each thread of its model programs, behind its own, in their order. A mode tells
/// what its marking tells, and is a fault if every way there takes an improbable draw. A step out of a marking is a
/// transition for each of its outcomes, under the conditions that it takes: into a fault mode by an improbable draw it
/// is a fault, else nominal. A belief over such a plant is that over the markings. Modes that no state of the plant can
/// come to are left out. Throws base::LimitError where a thread has too many markings or conditions.
SoftwarePlant with_software(const PlantWithModels& whole);

/// The plant that a model program is by itself, as it is before its threads become components: they have the names of
/// their definitions. A control without an idle value has one more value, `unknown`, which is idle and tells nothing.
PlantWithModels plant_of(const ModelProgram& program);

}  // namespace rmpl::automata
