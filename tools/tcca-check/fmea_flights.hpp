// Each failure mode in a flight of the executive: what it changes, which reading tells it, and what is done then.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "automata/scenario.hpp"
#include "verifier/safety/fmea.hpp"

namespace rmpl::tools {

/// Flies each row that can happen: the fault happens at the first occasion in its mode, and nothing else fails. Rows
/// that no flight comes to stay as they are. The document has one program and one plant, those of the table. `cycle`:
/// of the executive. `interrupted` ends it: the rows left are not flown.
void fly_rows(const automata::Document& document, verifier::FailureModes& table, automata::Ticks cycle,
              const std::atomic<bool>* interrupted);

}  // namespace rmpl::tools
