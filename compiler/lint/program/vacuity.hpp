// Claims that say nothing: what properties and expectations share.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "compiler/lint/lint.hpp"
#include "compiler/lint/program/possibilities.hpp"

namespace rmpl::compiler {

/// Why a claim says nothing, empty where it does say something; with the formula that the constraints decide, where
/// they do.
struct Vacuity {
  std::string why;
  automata::Formula contradicted = automata::constant(true);
};

/// Of a claim about whether states satisfy a formula, which is `what` it claims: where none does, or all do.
Vacuity decided(Possibilities& possible, const automata::Formula& formula, const std::string& what);

/// Tells it of `claim`. `excludes`: the formula that it says never to hold, or null; that the constraints alone exclude
/// it may be what is to be checked, so that is a note.
void tell(const Vacuity& vacuity, grammar::Code code, grammar::Span span, const std::string& claim,
          const automata::Formula* excludes, Possibilities& possible, const LintInput& input,
          grammar::Diagnostics& found);

}  // namespace rmpl::compiler
