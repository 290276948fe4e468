// Plants as engineers write them, with a start and a goal: small, and joined as such things are joined.
// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <ostream>

#include "automata/logic/formula.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::property {

struct Engineered {
  automata::Plant plant;
  automata::Modes start;  ///< possible
  automata::Formula goal;
};
void showValue(const Engineered& engineered, std::ostream& out);

/// Parts, each with its command `x.cmd`, what it gives `x.out` and what it rests on `x.src`, which earlier parts give:
/// supplies with a warm-up, switches, loads that drop off, followers, batteries, levels, brakes that spring back,
/// buttons, motors that are held, arms, discs that burst, pyros, latches that may fail to engage, drivers that hang and
/// boot; interlocks between two of them; a reward now and then. All time bounds are whole seconds, from 1 to 6.
rc::Gen<Engineered> engineered(std::size_t least_parts = 3, std::size_t most_parts = 6);

}  // namespace rmpl::property
