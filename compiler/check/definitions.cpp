// Definitions and their calls.
// SPDX-License-Identifier: MIT
#include "compiler/check/definitions.hpp"

#include <algorithm>

#include "base/overloaded.hpp"
#include "compiler/check/domains.hpp"
#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using grammar::Code;

namespace {

/// Walks definitions and notes their calls with their positions.
class CallCollector {
 public:
  CallCollector(Definitions& definitions, grammar::Diagnostics& diagnostics)
      : definitions_(definitions), diagnostics_(diagnostics) {}

  void run(std::size_t caller) {
    caller_ = caller;
    body(definitions_.all[caller].definition->body, {});
  }

 private:
  /// Where a step stands.
  struct Position {
    std::string not_last;
    bool immediate = true;
  };

  void body(const grammar::Body& body, Position position) {
    if (body.threads.size() > 1) position.not_last = "it is one of several parallel threads";
    for (const grammar::Sequence& thread : body.threads) sequence(thread, position);
  }

  void sequence(const grammar::Sequence& sequence, const Position& position) {
    for (std::size_t s = 0; s < sequence.steps.size(); ++s) {
      Position inner = position;
      inner.immediate = position.immediate && s == 0;
      if (s + 1 < sequence.steps.size()) inner.not_last = "other steps follow it";
      step(sequence.steps[s], inner);
    }
  }

  void inside(const grammar::Step& body, Position position, const char* not_last) {
    position.immediate = false;
    if (*not_last != '\0') position.not_last = not_last;
    step(body, position);
  }

  void step(const grammar::Step& step, const Position& position) {
    const char* const last = "";
    std::visit(base::Overloaded{
                   [](const grammar::Goal&) {}, [](const grammar::ClockStart&) {},
                   [&](const grammar::Call& c) { call(c, position); },
                   [&](const grammar::Block& b) { body(b.body, position); },
                   [&](const grammar::Watching& w) { inside(*w.step, position, "a `do … watching` encloses it"); },
                   [&](const grammar::Maintaining& m) { inside(*m.step, position, "a `maintaining` encloses it"); },
                   [&](const grammar::If& i) {
                     inside(*i.step, position, last);
                     if (i.otherwise) inside(**i.otherwise, position, last);
                   },
                   [&](const grammar::Unless& u) { inside(*u.step, position, last); },
                   [&](const grammar::When& w) { inside(*w.step, position, last); },
                   [&](const grammar::Whenever& w) { inside(*w.step, position, "a `whenever` repeats it for ever"); },
                   [&](const grammar::Always& a) { inside(*a.step, position, "an `always` repeats it for ever"); },
                   [&](const grammar::Next& n) { inside(*n.step, position, last); },
                   [&](const grammar::Choose& c) {
                     diagnostics_.error(Code::model_program, step.span,
                                        "`choose` stands in model programs only, and this is a control program");
                     for (const grammar::Choice& choice : c.choices) inside(choice.step, position, "");
                   }},
               step.node);
  }

  void call(const grammar::Call& call, const Position& position) {
    const auto known = definitions_.by_name.find(call.definition.text);
    if (known == definitions_.by_name.end()) {
      if (!definitions_.unknown.insert(call.definition.text).second) return;
      const std::size_t before = diagnostics_.error_count();
      auto& error = diagnostics_.error(Code::unknown_name, call.definition.span,
                                       "there is no definition " + backquoted(call.definition.text));
      std::vector<std::string> candidates;
      for (const Definitions::Entry& entry : definitions_.all) candidates.push_back(entry.definition->name.text);
      suggest(error, before, call.definition.text, candidates);
      return;
    }
    if (known->second != caller_) definitions_.all[known->second].called = true;
    const grammar::Definition& callee = *definitions_.all[known->second].definition;
    if (callee.parameters.size() != call.arguments.size()) {
      const std::size_t expected = callee.parameters.size();
      auto& error = diagnostics_.error(Code::wrong_argument_count, call.definition.span,
                                       backquoted(call.definition.text) + " takes " + std::to_string(expected) +
                                           (expected == 1 ? " argument" : " arguments") + ", found " +
                                           std::to_string(call.arguments.size()));
      error.notes.push_back({callee.name.span, backquoted(callee.name.text) + " is defined here"});
      return;
    }
    definitions_.all[caller_].calls.push_back({&call, known->second, position.not_last, position.immediate});
    definitions_.callees.emplace(&call, known->second);
  }

  Definitions& definitions_;
  grammar::Diagnostics& diagnostics_;
  std::size_t caller_ = 0;
};

void report_model_item(grammar::Span span, const std::string& what, grammar::Diagnostics& diagnostics) {
  diagnostics.error(Code::model_program, span,
                    what +
                        " belongs in a model program, and a control program is expected here: what a plant does is "
                        "said in a `.tcca` file");
}

void declare(const grammar::Definition& definition, bool root, Uniqueness& names, Definitions& definitions,
             grammar::Diagnostics& diagnostics) {
  if (definition.model) report_model_item(definition.name.span, "`model`", diagnostics);
  Uniqueness parameters("parameter", diagnostics);
  for (const grammar::Name& parameter : definition.parameters) parameters.add(parameter);
  if (!names.add(definition.name)) return;
  definitions.by_name.emplace(definition.name.text, definitions.all.size());
  Uniqueness clocks("clock", diagnostics);
  for (const grammar::Name& clock : definition.clocks) {
    const bool parameter = std::any_of(definition.parameters.begin(), definition.parameters.end(),
                                       [&](const grammar::Name& p) { return p.text == clock.text; });
    if (clocks.add(clock) && parameter) {
      diagnostics.error(Code::duplicate_name, clock.span,
                        backquoted(clock.text) + " is a parameter of the definition already, and cannot be its clock");
    }
  }
  definitions.all.push_back({&definition, root, false, {}});
}

}  // namespace

Definitions collect_definitions(const std::vector<ProgramSource>& files, grammar::Diagnostics& diagnostics) {
  Definitions definitions;
  Uniqueness names("definition", diagnostics);
  for (const ProgramSource& source : files) {
    for (const grammar::ProgramItem& item : source.file->items) {
      std::visit(
          base::Overloaded{
              [](const grammar::Import&) {},
              [&](const grammar::Definition& d) { declare(d, source.root, names, definitions, diagnostics); },
              [&](const grammar::VariableDeclaration& v) { report_model_item(v.span, "`variable`", diagnostics); },
              [&](const grammar::Observe& o) { report_model_item(o.span, "`observe`", diagnostics); },
              [&](const grammar::Control& c) { report_model_item(c.span, "`control`", diagnostics); },
              [&](const grammar::Domain& d) { report_model_item(d.span, "`domain`", diagnostics); }},
          item);
    }
  }
  CallCollector collector(definitions, diagnostics);
  for (std::size_t d = 0; d < definitions.all.size(); ++d) collector.run(d);
  return definitions;
}

std::optional<std::size_t> find_entry(const Definitions& definitions, const std::string& main,
                                      std::optional<grammar::Span> main_span, grammar::Span blame,
                                      grammar::Diagnostics& diagnostics) {
  if (!main.empty()) {
    if (const auto known = definitions.by_name.find(main); known != definitions.by_name.end()) return known->second;
    const std::size_t before = diagnostics.error_count();
    auto& error = diagnostics.error(Code::no_entry, main_span.value_or(blame),
                                    "there is no definition " + backquoted(main) + " to start from");
    std::vector<std::string> candidates;
    for (const Definitions::Entry& entry : definitions.all) candidates.push_back(entry.definition->name.text);
    suggest(error, before, main, candidates);
    return std::nullopt;
  }
  if (definitions.all.empty()) {
    auto& error = diagnostics.error(Code::no_program, blame, "the program has no definition");
    error.suggestion = "add `Name() :: { … }`";
    return std::nullopt;
  }
  for (const bool root : {true, false}) {
    std::vector<std::size_t> candidates;
    for (std::size_t d = 0; d < definitions.all.size(); ++d) {
      if (definitions.all[d].root == root && !definitions.all[d].called) candidates.push_back(d);
    }
    if (candidates.size() == 1) return candidates.front();
    if (candidates.empty()) continue;
    if (!definitions.unknown.empty()) return std::nullopt;
    std::vector<std::string> names;
    for (const std::size_t c : candidates) names.push_back(definitions.all[c].definition->name.text);
    auto& error =
        diagnostics.error(Code::ambiguous_entry, definitions.all[candidates[1]].definition->name.span,
                          "no other definition calls " + one_of(names) + ", so it is not clear where to start");
    error.notes.push_back({definitions.all[candidates[0]].definition->name.span, "the first candidate is here"});
    error.suggestion = main_span ? "say which" : "say which with `--main NAME`, or in a scenario with `main NAME`";
    return std::nullopt;
  }
  auto& error = diagnostics.error(Code::no_entry, definitions.all.front().definition->name.span,
                                  "every definition is called by another, so it is not clear where to start");
  error.suggestion = "say which with `--main NAME`, or in a scenario with `main NAME`";
  return std::nullopt;
}

}  // namespace rmpl::compiler
