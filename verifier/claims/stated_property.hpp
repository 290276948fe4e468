// A property as a file states it, as the verifier is asked.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"
#include "automata/property.hpp"
#include "verifier/property/property.hpp"

namespace rmpl::verifier {

Property property_of(const automata::PlantProperty& stated, const automata::Plant& plant);

}  // namespace rmpl::verifier
