// Declared names become variables.
// SPDX-License-Identifier: MIT
#include "compiler/lower/attributes.hpp"

namespace rmpl::compiler {

void declare(Part& part, const std::vector<grammar::Name>& names, const grammar::DomainRef& domain, Uniqueness& known,
             Domains& domains, grammar::Diagnostics& diagnostics) {
  const auto values = domains.values(domain);
  for (const grammar::Name& name : names) {
    if (!values) part.broken.insert(name.text);
    if (!known.add(name) || !values || !make_room(part, values->values.size(), name.span, diagnostics)) continue;
    part.plant.variables.add({name.text, values->values});
    part.declared.push_back(values->span);
  }
}

}  // namespace rmpl::compiler
