// Unions of zones, where they are zones again.
//
// What several orders of the same independent steps lead to is one zone cut in pieces (R. Ben Salah, M. Bozga, O.
// Maler: On Interleaving in Timed Automata, CONCUR 2006). Pieces are put together on whole units only: all bounds are
// weak and whole, so that each state that some reading leads to is one that a whole reading leads to.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "verifier/zone/zone.hpp"

namespace rmpl::verifier {

/// The least zone that holds both, which are over the same clocks.
Zone hull(const Zone& a, const Zone& b);

/// Whether no whole reading is in both.
bool disjoint(const Zone& a, const Zone& b);

/// Whether every whole reading of the zone is in one of the others, over the same clocks. Looks at no more than so many
/// pieces; false where they do not suffice to tell. What one part leaves of the zone is cut along the part's bounds,
/// and each piece is looked for in the other parts.
bool within_union(const Zone& zone, std::span<const Zone> parts, std::size_t pieces);

}  // namespace rmpl::verifier
