// `,` and `;` in one pair of braces: which binds tighter is easily misread.
// SPDX-License-Identifier: MIT
#include "base/overloaded.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/tree_walk.hpp"

namespace rmpl::compiler {

namespace {

void check(const grammar::Body& body, grammar::Diagnostics& found) {
  if (body.threads.size() < 2) return;
  for (const grammar::Sequence& thread : body.threads) {
    if (thread.steps.size() < 2) continue;
    auto& finding = add_finding(found, grammar::Code::mixed_separators, thread.span,
                                "`,` and `;` in the same braces: these steps run in sequence, in parallel to the rest");
    finding.suggestion = "put the sequence in braces of its own: `{ … ; … }`";
    const std::uint32_t begin = thread.steps.front().span.begin;
    const std::uint32_t end = thread.steps.back().span.end;
    finding.fix = {{{thread.span.file, begin, begin}, "{ "}, {{thread.span.file, end, end}, " }"}};
  }
}

}  // namespace

void lint_mixed_separators(const LintInput& input, grammar::Diagnostics& found) {
  const base::Overloaded visit{[&](const grammar::Body& body) { check(body, found); }, [](const grammar::Step&) {}};
  for_each_definition(input, [&](const grammar::Definition& definition) { for_each_step(definition.body, visit); });
}

}  // namespace rmpl::compiler
