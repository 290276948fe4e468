// Declarations that several languages share: imports, domains, what is observed and controlled.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

/// `{ zero, low, nominal }`, with its place, braces included. One value or more.
struct Values {
  Span span;
  std::vector<Name> names;
};

/// The domain of a declaration: a name, or values in place.
using DomainRef = std::variant<Name, Values>;

/// `domain Level = { zero, low, nominal, high };`
struct Domain {
  Span span;
  Name name;
  Values values;
};

/// `import "descent.rmpl";`
struct Import {
  Span span;
  String path;
};

/// `observe x, y;` of a model program or of a module.
struct Observe {
  Span span;
  std::vector<Name> names;
};

/// `control x, y default v;`
struct Control {
  Span span;
  std::vector<Name> names;
  std::optional<Name> idle;
};

}  // namespace rmpl::grammar
