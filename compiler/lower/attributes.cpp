// Attributes become variables.
// SPDX-License-Identifier: MIT
#include "compiler/lower/attributes.hpp"

namespace rmpl::compiler {

void declare(Part& part, const grammar::AttributeDeclaration& declaration, Uniqueness& names, Domains& domains,
             grammar::Diagnostics& diagnostics) {
  const auto domain = domains.values(declaration.domain);
  for (const grammar::Name& name : declaration.names) {
    if (!domain) part.broken.insert(name.text);
    if (!names.add(name) || !domain || !make_room(part, domain->values.size(), name.span, diagnostics)) continue;
    part.plant.variables.add({name.text, domain->values});
    part.declared.push_back(domain->span);
  }
}

}  // namespace rmpl::compiler
