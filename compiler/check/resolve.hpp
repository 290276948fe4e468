// From a constraint as written to a formula over a table of variables: every name found, every value in its domain.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "automata/logic/formula.hpp"
#include "compiler/check/vocabulary.hpp"
#include "grammar/ast/constraint.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Resolves constraints against one vocabulary. A part that is wrong is reported and becomes `true`, so that one error
/// causes no others. What programs add to constraints (parameters, clocks) is overridden there.
class Resolver {
 public:
  Resolver(const Vocabulary& vocabulary, grammar::Diagnostics& diagnostics)
      : vocabulary_(vocabulary), diagnostics_(diagnostics) {}
  virtual ~Resolver() = default;

  automata::Formula resolve(const grammar::Constraint& constraint);
  /// From now on a constraint may ask what the executive knows; or, where a reason is given, that is an error which
  /// says why: "in a goal, which no knowledge achieves". At first the reason is that a model tells what is so.
  void ask_of_knowledge(std::optional<std::string> why_not) { no_knowledge_ = std::move(why_not); }
  /// `variable = value`, the right side a value. Nothing where it is wrong; then it has been reported.
  std::optional<automata::Assignment> assignment(const grammar::Name& variable, const grammar::Name& value);
  /// The variable of a name; nothing where there is none, and then it has been reported.
  virtual std::optional<automata::VariableId> variable(const grammar::Name& name);

 protected:
  /// The name that a name stands for: itself, but for a parameter. Nothing: it cannot be known; ask no more.
  virtual std::optional<grammar::Name> meaning(const grammar::Name& name);
  /// A bare name in the place of a constraint.
  virtual automata::Formula reference(const grammar::Reference& reference);
  virtual automata::Formula clock(const grammar::ClockBound& bound);
  /// Whether a variable is the mode of a component.
  [[nodiscard]] virtual bool is_component(automata::VariableId) const { return true; }
  /// The value of a variable; nothing where its domain lacks it (not reported).
  virtual std::optional<automata::ValueId> find_value(automata::VariableId variable, const std::string& value);
  /// Whether the domains are known, so that `x != v` is membership in the rest of the domain.
  [[nodiscard]] virtual bool closed() const { return true; }

  /// Called with the right side of a comparison that was taken for a value because the domains are not known.
  virtual void taken_for_value(const grammar::Name& name);

  /// Whether an error that was reported left the name without meaning, so that no more is said of it.
  [[nodiscard]] virtual bool lost_its_meaning(const grammar::Name&) const { return false; }
  /// Called with each error, for notes on how it came to be.
  virtual void annotate(grammar::Diagnostic& diagnostic);
  /// The error of a name that no variable has.
  virtual void report_unknown(const grammar::Name& name);
  void report_value(automata::VariableId variable, const grammar::Name& value);

  [[nodiscard]] const Vocabulary& vocabulary() const { return vocabulary_; }
  [[nodiscard]] grammar::Diagnostics& diagnostics() { return diagnostics_; }

 private:
  automata::Formula comparison(const grammar::Comparison& comparison);
  automata::Formula membership(const grammar::Membership& membership);
  automata::Formula knowledge(const grammar::KnowledgeAtom& atom, grammar::Span span);
  automata::Formula is_value(automata::VariableId variable, automata::ValueId value, bool equal);
  std::vector<automata::Formula> resolve_all(const std::vector<grammar::Constraint>& constraints);
  void note_domain(grammar::Diagnostic& diagnostic, automata::VariableId variable);

  Vocabulary vocabulary_;
  grammar::Diagnostics& diagnostics_;
  std::optional<std::string> no_knowledge_ = "in a model, which tells what is so";
  /// The values of variables with large domains, so that a look-up does not walk the domain.
  std::map<automata::VariableId, std::unordered_map<std::string, automata::ValueId>> large_;
};

}  // namespace rmpl::compiler
