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
    model_ = definitions_.all[caller].definition->model;
    body(definitions_.all[caller].definition->body, {});
  }

 private:
  /// Where a step stands.
  struct Position {
    std::string not_last;
    bool immediate = true;
    bool whole = true;
  };

  void body(const grammar::Body& body, Position position) {
    // In a model program a call that leads back is an arc, beside which other threads go on.
    if (body.threads.size() > 1 && !model_) position.not_last = "it is one of several parallel threads";
    position.whole = position.whole && body.threads.size() == 1;
    for (const grammar::Sequence& thread : body.threads) sequence(thread, position);
  }

  void sequence(const grammar::Sequence& sequence, const Position& position) {
    for (std::size_t s = 0; s < sequence.steps.size(); ++s) {
      Position inner = position;
      inner.immediate = position.immediate && s == 0;
      inner.whole = position.whole && sequence.steps.size() == 1;
      if (s + 1 < sequence.steps.size()) inner.not_last = "other steps follow it";
      step(sequence.steps[s], inner);
    }
  }

  void inside(const grammar::Step& body, Position position, const char* not_last) {
    position.immediate = false;
    position.whole = false;
    if (*not_last != '\0') position.not_last = not_last;
    step(body, position);
  }

  void step(const grammar::Step& step, const Position& position) {
    const char* const last = "";
    std::visit(base::Overloaded{
                   [](const grammar::Goal&) {}, [](const grammar::ClockStart&) {},
                   [&](const grammar::Call& c) { call(c, position); },
                   [&](const grammar::Block& b) { body(b.body, position); }, [](const grammar::Nothing&) {},
                   [&](const grammar::Each& e) { each(e, step.span, position); },
                   [&](const grammar::Repeat& r) { inside(*r.step, position, "a `repeat` starts it again"); },
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
                   [&](const grammar::Choose& c) { choose(c, step.span, position); }},
               step.node);
  }

  /// Its branches start in the same instant.
  void each(const grammar::Each& each, grammar::Span span, Position position) {
    if (model_) {
      auto& error = diagnostics_.error(Code::control_only, span,
                                       "`each` stands in control programs only, and this is a model program");
      error.suggestion = "what is told side by side is told together: leave `each` out";
    }
    position.not_last = "an `each` encloses it";
    body(each.body, position);
  }

  /// The branch that is drawn starts in the same instant. Beside model definitions the mixture is reported.
  void choose(const grammar::Choose& choose, grammar::Span span, Position position) {
    if (!model_ && !definitions_.model) {
      diagnostics_.error(Code::model_program, span,
                         "`choose` stands in model programs only, and this is a control program");
    }
    position.whole = false;
    for (const grammar::Choice& choice : choose.choices) step(choice.step, position);
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
    if (callee.model != model_) return report_mixed_call(call, callee);
    definitions_.all[caller_].calls.push_back(
        {&call, known->second, position.not_last, position.immediate, position.whole});
    if (position.immediate) definitions_.immediate.insert(&call);
    definitions_.callees.emplace(&call, known->second);
  }

  void report_mixed_call(const grammar::Call& call, const grammar::Definition& callee) {
    const auto kind = [](bool model) { return model ? "model" : "control"; };
    auto& error = diagnostics_.error(Code::mixed_program, call.definition.span,
                                     std::string("a ") + kind(model_) + " definition calls " +
                                         backquoted(callee.name.text) + ", which is a " + kind(callee.model) +
                                         " definition: a program either tells what holds or asserts what should");
    error.notes.push_back({callee.name.span, backquoted(callee.name.text) + " is defined here"});
    if (model_)
      error.suggestion = "if it tells what holds, write `model " + callee.name.text + "(…)` where it is defined";
    definitions_.mixed = true;
  }

  Definitions& definitions_;
  grammar::Diagnostics& diagnostics_;
  std::size_t caller_ = 0;
  bool model_ = false;  ///< the caller is a model definition
};

void report_model_item(grammar::Span span, const std::string& what, grammar::Diagnostics& diagnostics) {
  auto& error =
      diagnostics.error(Code::model_program, span, what + " belongs in a model program, and this is a control program");
  error.suggestion = "write `model` before its definitions, or say what a plant does in a `.tcca` file";
}

/// What a control program does not have.
void check_control_items(const std::vector<ProgramSource>& files, grammar::Diagnostics& diagnostics) {
  for (const ProgramSource& source : files) {
    for (const grammar::ProgramItem& item : source.file->items) {
      std::visit(
          base::Overloaded{
              [](const grammar::Import&) {}, [](const grammar::Definition&) {},
              [&](const grammar::VariableDeclaration& v) { report_model_item(v.span, "`variable`", diagnostics); },
              [&](const grammar::StandingConstraint& c) { report_model_item(c.span, "`constraint`", diagnostics); },
              [&](const grammar::Observe& o) { report_model_item(o.span, "`observe`", diagnostics); },
              [&](const grammar::Control& c) { report_model_item(c.span, "`control`", diagnostics); },
              [&](const grammar::Domain& d) { report_model_item(d.span, "`domain`", diagnostics); }},
          item);
    }
  }
}

/// Whether the files declare what only a model program has.
bool declares_variables(const std::vector<ProgramSource>& files) {
  return std::any_of(files.begin(), files.end(), [](const ProgramSource& source) {
    return std::any_of(source.file->items.begin(), source.file->items.end(), [](const grammar::ProgramItem& item) {
      return std::holds_alternative<grammar::VariableDeclaration>(item);
    });
  });
}

/// Reports the first definition that is of the other kind than the first of all.
void check_kinds(Definitions& definitions, grammar::Diagnostics& diagnostics) {
  const auto& all = definitions.all;
  const auto other = std::find_if(all.begin(), all.end(), [&](const Definitions::Entry& entry) {
    return entry.definition->model != all.front().definition->model;
  });
  if (other == all.end() || definitions.mixed) return;
  definitions.mixed = true;
  const grammar::Definition& first = *all.front().definition;
  const auto kind = [](const grammar::Definition& d) {
    return d.model ? " is a model definition" : " is a control definition";
  };
  auto& error = diagnostics.error(Code::mixed_program, other->definition->name.span,
                                  backquoted(other->definition->name.text) + kind(*other->definition) + ", and " +
                                      backquoted(first.name.text) + kind(first) +
                                      ": a program either tells what holds or asserts what should");
  error.notes.push_back({first.name.span, backquoted(first.name.text) + " is defined here"});
  error.suggestion =
      other->definition->name.span.file == first.name.span.file
          ? "write `model` before every definition, or keep the two kinds in files of their own"
          : "name a file of a model program beside the control program, without an import: it is the plant";
}

void declare(const grammar::Definition& definition, bool root, Uniqueness& names, Definitions& definitions,
             grammar::Diagnostics& diagnostics) {
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
      const auto* definition = std::get_if<grammar::Definition>(&item);
      if (definition != nullptr) declare(*definition, source.root, names, definitions, diagnostics);
    }
  }
  definitions.model = std::any_of(definitions.all.begin(), definitions.all.end(),
                                  [](const Definitions::Entry& entry) { return entry.definition->model; });
  if (definitions.all.empty()) definitions.model = declares_variables(files);
  if (!definitions.model) check_control_items(files, diagnostics);
  CallCollector collector(definitions, diagnostics);
  for (std::size_t d = 0; d < definitions.all.size(); ++d) collector.run(d);
  check_kinds(definitions, diagnostics);
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
    error.suggestion = definitions.model ? "add `model Name() :: { … }`" : "add `Name() :: { … }`";
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
    names.reserve(candidates.size());
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
