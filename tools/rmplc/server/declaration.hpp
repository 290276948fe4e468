// What a name's declaration is: the statement it stands in, and what that stands in.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "compiler/session/files.hpp"

namespace rmpl::tools {

/// The statement that declares a name, and the pointers of what it is and where it is; all others are null.
struct Declaration {
  grammar::Span statement;
  const grammar::ComponentDefinition* component = nullptr;  ///< itself, or around it
  const grammar::ModuleDefinition* module = nullptr;        ///< itself, or around it
  const grammar::AttributeDeclaration* attribute = nullptr;
  const grammar::ModeDeclaration* mode = nullptr;
  const grammar::InstanceDeclaration* instance = nullptr;
  const grammar::Domain* domain = nullptr;
  const grammar::VariableDeclaration* variable = nullptr;
  const grammar::Definition* definition = nullptr;  ///< itself, or around a clock or parameter
  const grammar::ScenarioDefinition* scenario = nullptr;
  const grammar::MonitorDefinition* monitor = nullptr;
};

/// The declaration of the name that stands there. Without a statement where there is none.
Declaration find_declaration(const compiler::File& file, grammar::Span name);

/// The comment lines right above a statement, without their marks; of a file's first lines, not the licence.
std::string comment_above(const grammar::SourceFile& source, grammar::Span statement);

}  // namespace rmpl::tools
