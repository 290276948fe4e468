// A witness scenario flown before it is written, so that every one that is written fails.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "automata/plant.hpp"
#include "verifier/property/property.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::tools {

/// Flies `text` as the scenario at `path`, against what the executive estimates; the search took the estimate to be the
/// truth. Why the flight does not violate `property` as the witness does; nothing where it does. `interrupted` ends it.
std::optional<std::string> rehearse(const std::string& path, const std::string& text, const automata::Plant& plant,
                                    const verifier::ProgramProperty& property, const verifier::Witness& witness,
                                    const std::atomic<bool>* interrupted);

}  // namespace rmpl::tools
