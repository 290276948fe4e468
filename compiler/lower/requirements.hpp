// Tags of requirements, as scenarios and properties bear them.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grammar/ast/token.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Where requirements were tagged first, by tag.
using TagPlaces = std::map<std::string, grammar::Span>;

/// Those of the tags that are names and were not there before, in their order; they join `known`. Reports the others.
std::vector<std::string> fresh_tags(const std::vector<grammar::String>& tags, TagPlaces& known,
                                    grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
