// The domains that a model declares, by name; and the values of a declaration's domain.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grammar/ast/declaration.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Values in order, and where they are written.
struct DomainValues {
  std::vector<std::string> values;
  grammar::Span span;
};

/// The named domains of one model. Reports domains and values that are defined twice.
class Domains {
 public:
  explicit Domains(grammar::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void declare(const grammar::Domain& domain);
  /// A domain of a model program that the model imports: it serves where the model declares none of that name.
  void lend(const grammar::Domain& domain);
  /// The values of a declaration, named or in place. An unknown name is reported, and gives nothing.
  std::optional<DomainValues> values(const grammar::DomainRef& domain);

 private:
  DomainValues distinct(const grammar::Values& values);

  struct Named {
    grammar::Span name;
    DomainValues values;
  };
  std::optional<DomainValues> lent(const grammar::Name& name);

  std::map<std::string, Named, std::less<>> named_;
  std::map<std::string, std::vector<Named>, std::less<>> lent_;  ///< those of one name differ
  grammar::Diagnostics& diagnostics_;
};

/// Names that must differ: reports the second use of one, with a note at the first.
class Uniqueness {
 public:
  /// `kind` for the message: "mode", "value of a domain".
  Uniqueness(std::string kind, grammar::Diagnostics& diagnostics) : kind_(std::move(kind)), diagnostics_(diagnostics) {}
  /// Whether the name is new.
  bool add(const grammar::Name& name);

 private:
  std::string kind_;
  std::map<std::string, grammar::Span, std::less<>> seen_;
  grammar::Diagnostics& diagnostics_;
};

}  // namespace rmpl::compiler
