// Whether a run shows what it is a witness of.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "automata/step/plain_step.hpp"
#include "verifier/property/property.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// How formulas and times are read, as in CheckOptions.
struct ClaimTerms {
  bool entailed = false;
  std::optional<automata::Ticks> period = std::nullopt;  ///< of a cycle; none in dense time
};

/// Why the run does not show that the property holds (reachability) or is violated (all others); nothing where it does.
/// Whether the run is possible is for `replay` to say.
std::optional<std::string> failure_to_show(automata::PlainStep& rules, const Property& property,
                                           const ClaimTerms& terms, const Witness& witness);

/// The event of a run from which on a response is owed and missed; nothing where every one comes in time. Where time
/// stands still it is missed if it does not come at all; where the run is stuck, if what could follow came too late.
std::optional<std::size_t> owed_since(automata::PlainStep& rules, const Response& response, const ClaimTerms& terms,
                                      const Witness& witness);

}  // namespace rmpl::verifier
