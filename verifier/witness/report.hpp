// Results as text and as JSON (grammar/schema/verdict.schema.json).
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "verifier/property/property.hpp"

namespace rmpl::verifier {

/// `holds`, `violated`, `undecided`.
std::string_view to_text(Verdict verdict);

/// Why a result is undecided, or its trace perhaps not the fastest, and how far the search got, in words; empty where
/// no limit was hit.
std::string reason(const Result& result);

/// The result for programs. Times are seconds.
nlohmann::ordered_json to_json(const automata::Plant& plant, const Property& property, const CheckOptions& options,
                               const Result& result);

/// The result for people, lines ended; with a line of statistics if asked for, in colour if asked for.
std::string to_text(const automata::Plant& plant, const Property& property, const CheckOptions& options,
                    const Result& result, bool statistics, bool color);

}  // namespace rmpl::verifier
