// Domains by name, and names that must differ.
// SPDX-License-Identifier: MIT
#include "compiler/check/domains.hpp"

#include <algorithm>

#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using grammar::Code;

bool Uniqueness::add(const grammar::Name& name) {
  const auto [first, fresh] = seen_.emplace(name.text, name.span);
  if (!fresh) {
    auto& error = diagnostics_.error(Code::duplicate_name, name.span,
                                     kind_ + " " + backquoted(name.text) + " is already defined");
    error.notes.push_back({first->second, backquoted(name.text) + " is first defined here"});
  }
  return fresh;
}

void Domains::declare(const grammar::Domain& domain) {
  DomainValues values = distinct(domain.values);
  const auto [first, fresh] = named_.emplace(domain.name.text, Named{domain.name.span, std::move(values)});
  if (fresh) return;
  auto& error = diagnostics_.error(Code::duplicate_name, domain.name.span,
                                   "domain " + backquoted(domain.name.text) + " is already defined");
  error.notes.push_back({first->second.name, backquoted(domain.name.text) + " is first defined here"});
}

void Domains::lend(const grammar::Domain& domain) {
  DomainValues values{{}, domain.values.span};
  for (const grammar::Name& name : domain.values.names) values.values.push_back(name.text);
  std::vector<Named>& same = lent_[domain.name.text];
  const bool known =
      std::any_of(same.begin(), same.end(), [&](const Named& other) { return other.values.values == values.values; });
  if (!known) same.push_back({domain.name.span, std::move(values)});
}

std::optional<DomainValues> Domains::lent(const grammar::Name& name) {
  const std::vector<Named>& same = lent_.find(name.text)->second;
  if (same.size() == 1) return same.front().values;
  auto& error = diagnostics_.error(Code::ambiguous_name, name.span,
                                   "the imported model programs have different domains " + backquoted(name.text));
  for (const Named& one : same) error.notes.push_back({one.name, "one is here"});
  error.suggestion = "declare the domain that is meant in this model";
  return std::nullopt;
}

std::optional<DomainValues> Domains::values(const grammar::DomainRef& domain) {
  if (const auto* in_place = std::get_if<grammar::Values>(&domain)) return distinct(*in_place);
  const auto& name = std::get<grammar::Name>(domain);
  if (const auto known = named_.find(name.text); known != named_.end()) return known->second.values;
  if (lent_.contains(name.text)) return lent(name);
  const std::size_t before = diagnostics_.error_count();
  auto& error = diagnostics_.error(Code::unknown_name, name.span, "there is no domain " + backquoted(name.text));
  std::vector<std::string> candidates;
  for (const auto& [candidate, values] : named_) candidates.push_back(candidate);
  for (const auto& [candidate, values] : lent_) candidates.push_back(candidate);
  suggest(error, before, name.text, candidates);
  return std::nullopt;
}

DomainValues Domains::distinct(const grammar::Values& values) {
  Uniqueness names("value", diagnostics_);
  DomainValues result{{}, values.span};
  for (const grammar::Name& name : values.names) {
    if (names.add(name)) result.values.push_back(name.text);
  }
  return result;
}

}  // namespace rmpl::compiler
