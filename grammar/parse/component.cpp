// Component types: attributes, modes, initial distributions (language.md "Plant models").
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

const Rule<struct InitialModeId, InitialMode> initial_mode{"a mode"};
const Rule<struct ModeId, ModeDeclaration> mode{"a mode"};

constexpr auto direction = &AttributeDeclaration::direction;
const auto attribute_def =
    record[(set<direction, Direction::input>[statement("input")] |
            set<direction, Direction::output>[statement("output")] |
            set<direction, Direction::internal>[statement("internal")]) >
           comma_list(append<&AttributeDeclaration::names>[name]) > named("`,` or `:` and a domain", colon) >
           domain_reference<&AttributeDeclaration::domain>() > semicolon];

const auto initial_mode_def =
    record[field<&InitialMode::mode>[name] >> -field<&InitialMode::probability>[signed_number]];

const auto initial_def = record[statement("initial") > comma_list(append<&Initial::modes>[initial_mode]) >
                                named("a probability, `,` or `;`", semicolon)];

const auto mode_def = record
    [(set<&ModeDeclaration::fault, false>[statement("mode")] | set<&ModeDeclaration::fault, true>[statement("fault")]) >
     field<&ModeDeclaration::name>[name] >>
     -((open_brace >> close_brace) | (open_brace > field<&ModeDeclaration::constraint>[constraint] > close_brace)) >>
     -(Keyword("reward") > field<&ModeDeclaration::reward>[signed_number]) > named("`{`, `reward` or `;`", semicolon)];

constexpr auto items = &ComponentDefinition::items;
const auto component_def =
    record[-set<&ComponentDefinition::progress, true>[Keyword("progress") >> &Keyword("component")] >>
           Keyword("component") > field<&ComponentDefinition::name>[name] >
           statements_in_braces(
               "a declaration (`input`, `output`, `internal`), `initial`, a `mode`, a `fault` or a transition",
               append<items>[attribute] | append<items>[initial] | append<items>[mode] | append<items>[transition])];

BOOST_SPIRIT_DEFINE(initial_mode, mode)

}  // namespace

BOOST_SPIRIT_DEFINE(attribute, initial, component)
BOOST_SPIRIT_INSTANTIATE(decltype(attribute), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(initial), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(component), Iterator, Context)

}  // namespace rmpl::grammar
