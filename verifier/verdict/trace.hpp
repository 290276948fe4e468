// Witnesses as text and as JSON.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "verifier/verdict/subject.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// A line an event in which something happens: the time, right-aligned; the goals that are new; the command, if any;
/// what changed. Of the start the modes are told that are not the most likely ones. `end` is said of the last event.
std::string text_of(const Subject& subject, const Witness& witness, const std::string& end);

/// The events, in order. Times are seconds.
nlohmann::ordered_json json_of(const Subject& subject, const Witness& witness);

}  // namespace rmpl::verifier
