// The rules that one file defines and another uses.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "grammar/ast/constraint.hpp"
#include "grammar/ast/declaration.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/ast/program.hpp"
#include "grammar/ast/property.hpp"
#include "grammar/ast/requirement.hpp"
#include "grammar/ast/scenario.hpp"
#include "grammar/parse/lexeme.hpp"

namespace rmpl::grammar {

template <class Id, class Attribute>
using Rule = x3::rule<Id, Attribute>;

/// What `parse_assignments` reads.
struct AssignmentListText {
  std::vector<AssignmentText> assignments;
};

// constraint.cpp
inline constexpr Rule<struct ConstraintId, Constraint> constraint{"a constraint"};
inline constexpr Rule<struct AssignmentId, AssignmentText> assignment{"an assignment"};
inline constexpr Rule<struct AssignmentListId, AssignmentListText> assignment_list{"a list of assignments"};
BOOST_SPIRIT_DECLARE(decltype(constraint), decltype(assignment), decltype(assignment_list))

// declaration.cpp
inline constexpr Rule<struct ImportId, Import> import{"an import"};
inline constexpr Rule<struct DomainId, Domain> domain{"a domain"};
inline constexpr Rule<struct ValuesId, Values> values{"values in braces"};
inline constexpr Rule<struct ObserveId, Observe> observe{"an observation"};
inline constexpr Rule<struct ControlId, Control> control{"a control variable"};
inline constexpr Rule<struct RequirementId, RequirementPart> requirement{"`requirement`"};
BOOST_SPIRIT_DECLARE(decltype(import), decltype(domain), decltype(values), decltype(observe), decltype(control))
BOOST_SPIRIT_DECLARE(decltype(requirement))

// step.cpp
inline constexpr Rule<struct StepId, Step> step{"a step"};
inline constexpr Rule<struct BodyId, Body> body{"a body"};
BOOST_SPIRIT_DECLARE(decltype(step), decltype(body))

// transition.cpp
inline constexpr Rule<struct TransitionId, TransitionText> transition{"a transition"};
BOOST_SPIRIT_DECLARE(decltype(transition))

// component.cpp
inline constexpr Rule<struct AttributeId, AttributeDeclaration> attribute{"a declaration"};
inline constexpr Rule<struct InitialId, Initial> initial{"an initial distribution"};
inline constexpr Rule<struct ComponentId, ComponentDefinition> component{"a component"};
BOOST_SPIRIT_DECLARE(decltype(attribute), decltype(initial), decltype(component))

// module.cpp
inline constexpr Rule<struct ModuleId, ModuleDefinition> module_{"a module"};
BOOST_SPIRIT_DECLARE(decltype(module_))

// program.cpp, plant.cpp, scenario.cpp: whole files
inline constexpr Rule<struct ProgramFileId, ProgramFile> program_file{"a program"};
inline constexpr Rule<struct PlantFileId, PlantFile> plant_file{"a plant model"};
inline constexpr Rule<struct ScenarioFileId, ScenarioFile> scenario_file{"a scenario"};
inline constexpr Rule<struct PropertyFileId, PropertyFile> property_file{"a property"};
BOOST_SPIRIT_DECLARE(decltype(program_file), decltype(plant_file), decltype(scenario_file), decltype(property_file))

/// `requirement` with its tags, into a member that is a vector.
template <auto Member>
constexpr auto requirement_tags() {
  return Keyword("requirement") > comma_list(append<Member>[string]);
}

/// A domain by name, or its values in place.
template <auto Member>
constexpr auto domain_reference() {
  return named("a domain", field<Member>[name] | field<Member>[values]);
}

}  // namespace rmpl::grammar
