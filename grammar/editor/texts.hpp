// The list of words and the grammars, as the programs carry them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace rmpl::grammar {

extern const std::string_view keyword_list;  ///< grammar/editor/keywords.txt
extern const std::string_view rmpl_notation, tcca_notation, scn_notation, props_notation,
    mon_notation;  ///< the EBNF of each language

}  // namespace rmpl::grammar
