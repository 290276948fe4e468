// The compiler's THCA against the table of semantics 2.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "compiler/session/compiler.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/source/render.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/models.hpp"

namespace rmpl::property {
namespace {

/// Compiles a text as the file of a program.
compiler::Compilation compile(const std::string& text) {
  const std::string name = "program.rmpl";
  compiler::Memory texts;
  texts.put(name, text);
  return compiler::compile({&name, 1}, {.main = reference::name_of_definition(0)}, texts);
}

void same_arcs(std::vector<automata::Arc> found, const std::vector<automata::Arc>& expected) {
  RC_ASSERT(found.size() == expected.size());
  for (const automata::Arc& arc : expected) {
    const auto same = std::find(found.begin(), found.end(), arc);
    RC_ASSERT(same != found.end());
    found.erase(same);
  }
}

RC_GTEST_PROP(Compiler, LowersByTheTable, ()) {
  const Model model = *models();
  const RandomSource source = *sources(model.plant);
  const compiler::Compilation compilation = compile(source.text);
  RC_LOG() << grammar::render_text(compilation.findings(), false);
  RC_ASSERT(compilation.ok());
  RC_ASSERT(compilation.document().programs.size() == 1u);
  const automata::Program found = automata::bind(compilation.document().programs.front(), model.plant).program;
  const automata::Program expected = reference::lower(source.source, model.plant.variables);
  RC_ASSERT(found.clocks == expected.clocks);
  RC_ASSERT(found.locations.size() == expected.locations.size());
  for (std::size_t i = 0; i < expected.locations.size(); ++i) {
    const automata::Location& location = found.locations[i];
    const automata::Location& twin = expected.locations[i];
    RC_LOG() << "location " << i + 1 << ": " << location.label << std::endl;
    RC_ASSERT(location.composite == twin.composite);
    RC_ASSERT(location.parent == twin.parent);
    RC_ASSERT(location.start == twin.start);
    RC_ASSERT(location.apart == twin.apart);
    RC_ASSERT(location.goal == twin.goal);
    RC_ASSERT(location.goal_constraints == twin.goal_constraints);
    RC_ASSERT(location.clock_start == twin.clock_start);
    RC_ASSERT(location.own_clocks == twin.own_clocks);
    RC_ASSERT(location.maintenance == twin.maintenance);
    same_arcs(location.arcs, twin.arcs);
  }
}

}  // namespace
}  // namespace rmpl::property
