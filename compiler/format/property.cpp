// Properties: a claim and its settings, line by line.
// SPDX-License-Identifier: MIT
#include "base/overloaded.hpp"
#include "compiler/format/syntax.hpp"

namespace rmpl::compiler {
namespace {

/// A claim about one constraint: its keyword, after `program` where it is of one, and the constraint.
void write_claim(Document& document, bool of_program, const grammar::Constraint& constraint) {
  if (of_program) document.take();
  document.take();
  write(document, constraint);
}

void write_response(Document& document, const grammar::ResponseClaim& claim) {
  write_claim(document, claim.of_program, claim.after);
  document.line();
  document.take_to(claim.within.span.end);
  document.line();
  write(document, claim.then);
}

void write_eventually(Document& document, const grammar::EventuallyClaim& claim) {
  write_claim(document, true, claim.constraint);
  document.line();
}

void write_probability(Document& document, const grammar::ProbabilityClaim& claim) {
  if (claim.of_program) document.take();
  document.take();
  document.take();
  write(document, claim.constraint);
  document.line();
}

void write_from(Document& document, const grammar::FromSetting& from) {
  document.take();
  write_list(document, from.modes);
}

void write(Document& document, const grammar::PropertyItem& item) {
  document.open_statement();
  const base::Overloaded write_node{
      [&](const grammar::NeverClaim& claim) { write_claim(document, claim.of_program, claim.constraint); },
      [&](const grammar::ReachClaim& claim) { write_claim(document, false, claim.constraint); },
      [&](const grammar::FinallyClaim& claim) { write_claim(document, true, claim.constraint); },
      [&](const grammar::ResponseClaim& claim) { write_response(document, claim); },
      [&](const grammar::EventuallyClaim& claim) { write_eventually(document, claim); },
      [&](const grammar::ProbabilityClaim& claim) { write_probability(document, claim); },
      [&](const grammar::FromSetting& from) { write_from(document, from); },
      [&](const grammar::RequirementPart& part) {
        document.take();
        write_list(document, part.tags);
      },
      [](const auto&) {}};
  std::visit(write_node, item);
  document.take_to(std::visit([](const auto& node) { return node.span.end; }, item));
  document.close_statement();
}

}  // namespace

void write(Document& document, const grammar::PropertyFile& file) {
  const auto begin = [](const grammar::PropertyItem& item) {
    return std::visit([](const auto& node) { return node.span.begin; }, item);
  };
  auto setting = file.defaults.begin();
  // Settings for all stand before, between and behind the properties.
  const auto write_settings = [&](std::uint32_t before) {
    for (; setting != file.defaults.end() && begin(*setting) < before; ++setting) {
      document.hard_line();
      write(document, *setting);
    }
  };
  for (const grammar::PropertyDefinition& property : file.properties) {
    write_settings(property.span.begin);
    document.hard_line();
    document.open_statement();
    if (property.braces) {
      document.take_to(property.name.span.end);
      write_block(document, property.items, [&](const grammar::PropertyItem& item) { write(document, item); });
    } else {
      document.take_to(property.span.end);
    }
    document.close_statement();
  }
  write_settings(0xFFFFFFFF);
  document.hard_line();
  document.take();
}

}  // namespace rmpl::compiler
