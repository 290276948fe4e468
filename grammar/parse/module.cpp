// Modules and the plant: ports, instances, connections (language.md "Plant models").
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

const Rule<struct InstanceId, InstanceDeclaration> instance{"an instance"};
const Rule<struct InterconnectionId, Interconnection> interconnection{"a constraint"};

// An instance may be called `progress`: then no name follows.
const auto instance_def =
    record[-set<&InstanceDeclaration::progress, true>[Keyword("progress") >> &name] >>
           comma_list(append<&InstanceDeclaration::names>[name]) >> colon >
           -set<&InstanceDeclaration::model, true>[Keyword("model") >> &name] >
           field<&InstanceDeclaration::type>[name] > -(open_brace > field<&InstanceDeclaration::initial>[initial] >
                                                       close_brace) > named("`{` or `;`", semicolon)];

// Two names side by side are neither an instance nor a constraint.
const auto interconnection_def =
    record[(name >> &name > Missing("`:` and a type, or an operator")) |
           (field<&Interconnection::constraint>[constraint] > named("an operator or `;`", semicolon))];

constexpr auto items = &ModuleDefinition::items;
const auto module__def =
    record[(set<&ModuleDefinition::plant, false>[Keyword("module")] |
            set<&ModuleDefinition::plant, true>[Keyword("plant")]) > field<&ModuleDefinition::name>[name] >
           statements_in_braces("a port (`input`, `output`, `internal`), an instance `name : Type`, `control`, "
                                "`observe` or a constraint",
                                append<items>[attribute] | append<items>[control] | append<items>[observe] |
                                    append<items>[instance] | append<items>[interconnection])];

BOOST_SPIRIT_DEFINE(instance, interconnection)

}  // namespace

BOOST_SPIRIT_DEFINE(module_)
BOOST_SPIRIT_INSTANTIATE(decltype(module_), Iterator, Context)

}  // namespace rmpl::grammar
