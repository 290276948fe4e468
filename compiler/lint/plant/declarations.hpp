// Where the variables of a plant are declared: its instances as the text has them.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/lint/lint.hpp"

namespace rmpl::compiler {

/// An attribute of an instance.
struct PlantAttribute {
  std::string name;  ///< of the variable
  std::string type;  ///< component or module
  std::string attribute;
  grammar::Direction direction = grammar::Direction::input;
  grammar::Span span;
  bool of_component = false;
};

/// In the order of the variables of the plant; instances in modules too.
struct PlantDeclarations {
  std::vector<PlantAttribute> attributes;
  std::map<std::string, grammar::Span> instances;  ///< of components, by name
  std::map<std::string, grammar::Span> controls;   ///< by name of the variable, where it is declared a control
  grammar::Span plant;                             ///< its name
};

/// Those of a plant of the document. Empty, and at the start of the first file, where its text is not there.
PlantDeclarations declarations_of(const LintInput& input, const automata::Plant& plant);

}  // namespace rmpl::compiler
