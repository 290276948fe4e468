// What there is to say of some texts, with the texts: all that it takes to show it, in whatever form.
// SPDX-License-Identifier: MIT
#pragma once

#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::grammar {

/// Diagnostics as values; `render.hpp` makes text or JSON of them.
struct Findings {
  Sources sources;
  Diagnostics diagnostics;
};

}  // namespace rmpl::grammar
