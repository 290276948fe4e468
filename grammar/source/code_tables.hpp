// The registry of codes in parts, one per subject.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "grammar/source/codes.hpp"

namespace rmpl::grammar {

std::span<const CodeInfo> text_codes();
std::span<const CodeInfo> name_codes();
std::span<const CodeInfo> plant_codes();
std::span<const CodeInfo> chance_codes();
std::span<const CodeInfo> program_codes();
std::span<const CodeInfo> model_codes();
std::span<const CodeInfo> scenario_codes();
std::span<const CodeInfo> lint_codes();
std::span<const CodeInfo> lint_flight_codes();
std::span<const CodeInfo> lint_plant_codes();
std::span<const CodeInfo> lint_transition_codes();
std::span<const CodeInfo> lint_sensing_codes();
std::span<const CodeInfo> document_codes();
std::span<const CodeInfo> property_codes();
std::span<const CodeInfo> netlist_codes();

}  // namespace rmpl::grammar
