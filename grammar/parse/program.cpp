// Whole `.rmpl` files: imports, definitions, declarations of model programs.
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

const Rule<struct DefinitionId, Definition> definition{"a definition"};
const Rule<struct VariableId, VariableDeclaration> variable{"a variable"};
const Rule<struct StandingId, StandingConstraint> standing{"a constraint"};

/// `clock t, u;` A goal may ask for a mode of what is called `clock`: then no name follows.
const auto clocks = (Keyword("clock") >> &name) > comma_list(append<&Definition::clocks>[name]) >
                    named("`,` or `;`", semicolon);

const auto definition_def =
    record[-set<&Definition::model, true>[Keyword("model") >> &name] >> field<&Definition::name>[name] > open_paren >
           -comma_list(append<&Definition::parameters>[name]) > named("a parameter, `,` or `)`", close_paren) >
           defined_as > open_brace > *clocks > field<&Definition::body>[body] > close_brace];

const auto variable_def = record[Keyword("variable") >> comma_list(append<&VariableDeclaration::names>[name]) > colon >
                                 domain_reference<&VariableDeclaration::domain>() > semicolon];

/// A definition may be called `constraint`: then `::` follows its parameters.
const auto standing_def =
    record[(Keyword("constraint") >> !(open_paren >> -comma_list(name) >> close_paren >> defined_as)) >
           field<&StandingConstraint::constraint>[constraint] > semicolon];

constexpr auto items = &ProgramFile::items;
const auto program_file_def = record[statements_of_file(
    "a definition `Name() :: { … }` or `import`",
    append<items>[import] | append<items>[variable] | append<items>[standing] | append<items>[observe] |
        append<items>[control] | append<items>[domain] | append<items>[definition])];

BOOST_SPIRIT_DEFINE(definition, variable, standing)

}  // namespace

BOOST_SPIRIT_DEFINE(program_file)
BOOST_SPIRIT_INSTANTIATE(decltype(program_file), Iterator, Context)

}  // namespace rmpl::grammar
