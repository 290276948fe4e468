// The names that a constraint may speak of, where their domains are written, and what to call the place.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "automata/logic/variables.hpp"
#include "automata/plant.hpp"
#include "grammar/source/codes.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/span.hpp"

namespace rmpl::compiler {

/// Refers to a table that it does not own. Messages that name something put it in back quotes.
struct Vocabulary {
  const automata::Variables& variables;
  const std::vector<grammar::Span>* declared = nullptr;  ///< per variable, where its domain is written; none: no source
  std::string owner;                                     ///< for messages: "component `Engine`"
  grammar::Code unknown = grammar::Code::unknown_name;   ///< the error of a name that is not there
  std::vector<const automata::Component*> software = {};  ///< of which the variables may be modes

  /// Where the domain of a variable is written, if it has a source.
  [[nodiscard]] std::optional<grammar::Span> declaration(automata::VariableId id) const;
  /// The values that are meant by the name of one, ascending: a marking of software may have several modes.
  [[nodiscard]] std::vector<automata::ValueId> meant(automata::VariableId variable, automata::ValueId value) const;
};

/// The components of a plant that are software.
std::vector<const automata::Component*> software_of(const automata::Plant& plant);

/// "`zero`, `low` or `high`"; of a long domain, the first few and how many more.
std::string one_of(const std::vector<std::string>& names);

/// `name` in back quotes.
std::string backquoted(std::string_view name);

/// Adds "did you mean ...?" where a candidate is near. Silent once a run has many errors, so that a large broken model
/// does not cost a search of all its names for each of them.
void suggest(grammar::Diagnostic& diagnostic, std::size_t errors_so_far, std::string_view name,
             const std::vector<std::string>& candidates);

/// The names of all variables, for suggestions.
std::vector<std::string> names_of(const automata::Variables& variables);

}  // namespace rmpl::compiler
