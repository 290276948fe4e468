// Preconditions by counterexample-guided refinement over the constraint store.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/precondition_finder.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <tuple>

#include "automata/store/model.hpp"

namespace rmpl::runtime {

using automata::Assignment;
using automata::Component;
using automata::Formula;
using automata::Plant;
using automata::Theory;
using automata::ValueId;
using automata::VariableId;

namespace {

constexpr std::size_t yes = 1;

/// Exclusions after which the theory is built anew before the next question.
constexpr std::size_t exclusion_limit = 16;

/// The plant with a variable for each question, and for each mode one that tells its constraint to hold, whatever the
/// mode is; `?` keeps the names apart from those of models.
Plant with_questions(const Plant& plant, std::size_t conjuncts, std::vector<VariableId>& questions,
                     std::vector<std::vector<VariableId>>& tolerates) {
  Plant extended = plant;
  for (const Component& component : plant.components) {
    auto& of_component = tolerates.emplace_back();
    for (const auto& mode : component.modes) {
      of_component.push_back(extended.variables.add({component.name + "?" + mode.name, {"no", "yes"}}));
    }
  }
  for (std::size_t i = 0; i < conjuncts; ++i) {
    questions.push_back(extended.variables.add({"?" + std::to_string(i), {"no", "yes"}}));
  }
  return extended;
}

/// The formula with some variables replaced by their values; constants are left to the encoder.
Formula substituted(const Formula& formula, const std::function<std::optional<ValueId>(VariableId)>& value_of) {
  switch (formula.kind) {
    case Formula::Kind::constant:
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      return formula;
    case Formula::Kind::member: {
      const auto value = value_of(formula.variable);
      if (!value) return formula;
      return automata::constant(std::binary_search(formula.values.begin(), formula.values.end(), *value));
    }
    case Formula::Kind::equality: {
      const auto left = value_of(formula.variable);
      const auto right = value_of(formula.other);
      if (left && right) return automata::constant(*left == *right);
      if (left) return automata::is(formula.other, *left);
      if (right) return automata::is(formula.variable, *right);
      return formula;
    }
    case Formula::Kind::negation:
    case Formula::Kind::conjunction:
    case Formula::Kind::disjunction:
    case Formula::Kind::implication:
    case Formula::Kind::equivalence: {
      Formula result = formula;
      for (Formula& operand : result.operands) operand = substituted(operand, value_of);
      return result;
    }
  }
  return formula;
}

bool reads(const Formula& formula, const std::vector<bool>& set) {
  const auto variables = variables_of(formula);
  return std::any_of(variables.begin(), variables.end(), [&](VariableId v) { return set[v.index()]; });
}

}  // namespace

/// One conjunct of the guard: what is asked, and what may be decided to bring it about.
struct PreconditionFinder::Question {
  Assignment asked;  ///< assumed where the conjunct is wanted and what is excluded stays excluded
  Formula guard;
  Theory::Handle refuted;              ///< its negation
  std::vector<VariableId> decisions;   ///< modes of other components and controls
  std::vector<VariableId> attributes;  ///< that the decisions may leave open
};

PreconditionFinder::PreconditionFinder(const Plant& plant, Assignment source, const Formula& guard)
    : source_(source),
      conjuncts_(conjuncts_of(guard)),
      plant_(with_questions(plant, conjuncts_.size(), questions_, tolerates_)),
      variables_(plant.variables.size()),
      theory_(fresh_theory()),
      regions_(plant_, variables_) {}

Theory PreconditionFinder::fresh_theory() const {
  Theory theory = model_theory(plant_, Theory::Upkeep::searched);
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    for (std::size_t m = 0; m < tolerates_[c].size(); ++m) {
      theory.tell_if({tolerates_[c][m], ValueId(yes)}, plant_.components[c].modes[m].constraint);
    }
  }
  return theory;
}

FoundPreconditions PreconditionFinder::preconditions() {
  std::vector<Precondition> found{{}};
  for (std::size_t i = 0; i < conjuncts_.size(); ++i) {
    Question question{.asked = {questions_[i], ValueId(yes)},
                      .guard = conjuncts_[i],
                      .refuted = {},
                      .decisions = {},
                      .attributes = {}};
    std::vector<bool> chosen(plant_.variables.size());
    chosen[source_.variable.index()] = true;
    const auto choose = [&](VariableId v, std::vector<VariableId>& from) {
      if (!chosen[v.index()]) from.push_back(v);
      chosen[v.index()] = true;
    };
    for (const VariableId v : variables_of(conjuncts_[i])) {
      const Regions::Region* const region = regions_.of(v);
      if (region == nullptr) {
        choose(v, question.decisions);
        continue;
      }
      for (const VariableId decision : region->decisions) choose(decision, question.decisions);
      for (const VariableId attribute : region->attributes) choose(attribute, question.attributes);
    }
    std::sort(question.decisions.begin(), question.decisions.end());
    found = joined(found, part_preconditions(question));
  }
  const automata::PlantIndex index(plant_);
  const auto rank = [&](const Precondition& precondition) {
    return std::make_tuple(commanded_controls(plant_, index, precondition), precondition.size());
  };
  std::sort(found.begin(), found.end(), [&](const Precondition& a, const Precondition& b) {
    return std::tuple_cat(rank(a), std::tie(a)) < std::tuple_cat(rank(b), std::tie(b));
  });
  if (found.size() > limit) {
    found.resize(limit);
    all_ = false;
  }
  return {std::move(found), all_};
}

/// The unions that the store permits, without those that a wider one makes superfluous.
std::vector<Precondition> PreconditionFinder::joined(const std::vector<Precondition>& left,
                                                     const std::vector<Precondition>& right) {
  std::vector<Precondition> unions;
  for (const Precondition& l : left) {
    for (const Precondition& r : right) {
      if (auto whole = both(l, r)) unions.push_back(std::move(*whole));
    }
  }
  std::sort(unions.begin(), unions.end());
  unions.erase(std::unique(unions.begin(), unions.end()), unions.end());
  std::vector<Precondition> result;
  for (const Precondition& precondition : unions) {
    const bool superfluous = std::any_of(unions.begin(), unions.end(), [&](const Precondition& other) {
      return &other != &precondition && subsumes(other, precondition);
    });
    if (!superfluous && theory_.allows(std::span(&source_, 1), theory_.encode(formula_of(precondition)))) {
      result.push_back(precondition);
    }
  }
  return result;
}

std::vector<Precondition> PreconditionFinder::part_preconditions(Question& question) {
  // What was told for the questions before only slows the solver down.
  if (excluded_ > exclusion_limit) {
    theory_ = fresh_theory();
    excluded_ = 0;
  }
  question.refuted = theory_.encode(negation(question.guard));
  theory_.tell_if(question.asked, question.guard);
  std::vector<Precondition> found;
  const std::vector<Assignment> wanted{question.asked, source_};
  while (theory_.consistent(wanted)) {
    if (found.size() == limit) {
      all_ = false;
      break;
    }
    const World proposal = read_world();
    std::vector<Assignment> decisions{source_};
    for (const VariableId v : question.decisions) decisions.push_back({v, proposal[v.index()]});
    if (theory_.allows(decisions, question.refuted)) {
      exclude(question, proposal);
    } else {
      Precondition precondition = shrink(question);
      widen(question, precondition);
      theory_.tell_if(question.asked, negation(formula_of(precondition)));
      found.push_back(std::move(precondition));
    }
  }
  return found;
}

PreconditionFinder::World PreconditionFinder::read_world() const {
  World world;
  for (std::size_t v = 0; v < variables_; ++v) world.push_back(theory_.value(VariableId(v)));
  return world;
}

/// After the decisions were found to imply the guard: those that are needed for it, one value each.
Precondition PreconditionFinder::shrink(const Question& question) {
  std::vector<Assignment> core = theory_.conflict();
  std::erase(core, source_);
  for (std::size_t i = 0; i < core.size();) {
    std::vector<Assignment> rest{source_};
    for (std::size_t j = 0; j < core.size(); ++j) {
      if (j != i) rest.push_back(core[j]);
    }
    if (theory_.allows(rest, question.refuted)) {
      ++i;
    } else {
      core.assign(rest.begin() + 1, rest.end());
    }
  }
  std::sort(core.begin(), core.end());
  Precondition precondition;
  for (const Assignment& a : core) precondition.push_back({a.variable, {a.value}});
  return precondition;
}

/// Adds each value with which the precondition stays one, whatever the others are, and which the store permits.
void PreconditionFinder::widen(const Question& question, Precondition& precondition) {
  for (std::size_t i = 0; i < precondition.size(); ++i) {
    Precondition others = precondition;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Formula context = formula_of(others);
    const auto permitted = theory_.encode(context);
    const auto refuted = theory_.encode(automata::conjunction({context, negation(question.guard)}));
    const VariableId variable = precondition[i].variable;
    std::vector<ValueId> values;
    for (std::size_t v = 0; v < plant_.variables[variable].values.size(); ++v) {
      const std::vector<Assignment> with{source_, {variable, ValueId(v)}};
      if (theory_.allows(with, permitted) && !theory_.allows(with, refuted)) values.emplace_back(v);
    }
    precondition[i].values = std::move(values);
  }
}

/// After a world was found that refutes the guard under the assumptions: another one that satisfies the constraints of
/// as many modes as can be added one by one, so that it refutes as many proposals as possible.
PreconditionFinder::World PreconditionFinder::most_tolerant(const Question& question,
                                                            std::vector<Assignment> assumptions) {
  World world = read_world();
  const auto tolerated = [&](std::size_t c, std::size_t m) {
    return evaluate(plant_.components[c].modes[m].constraint, [&](VariableId v) { return world[v.index()]; });
  };
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    const Component& component = plant_.components[c];
    if (!std::binary_search(question.decisions.begin(), question.decisions.end(), component.mode)) continue;
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      assumptions.push_back({tolerates_[c][m], ValueId(yes)});
      if (tolerated(c, m)) continue;
      if (theory_.allows(assumptions, question.refuted)) {
        world = read_world();
      } else {
        assumptions.pop_back();
      }
    }
  }
  return world;
}

/// The attributes that are to have their values from the refuting world: those that differ from the proposal, and
/// around them all that can take part without any mode being at odds with it that is not at odds already.
std::vector<bool> PreconditionFinder::swapped(const Question& question, const World& proposal,
                                              const World& refuting) const {
  const auto at_odds = [&](Assignment mode) {
    const auto& modes = plant_[*plant_.component_of(mode.variable)].modes;
    return !evaluate(modes[mode.value.index()].constraint, [&](VariableId v) { return refuting[v.index()]; });
  };
  std::vector<bool> swapped(plant_.variables.size());
  std::vector<bool> seen(plant_.variables.size());
  std::vector<Assignment> refused;
  std::vector<VariableId> open;
  for (const VariableId v : question.attributes) {
    if (refuting[v.index()] == proposal[v.index()]) continue;
    swapped[v.index()] = seen[v.index()] = true;
    open.push_back(v);
    const auto& readers = regions_.readers(v);
    std::copy_if(readers.begin(), readers.end(), std::back_inserter(refused), at_odds);
  }
  while (!open.empty()) {
    const VariableId v = open.back();
    open.pop_back();
    for (const VariableId w : regions_.neighbours(v)) {
      if (seen[w.index()]) continue;
      seen[w.index()] = true;
      const auto& readers = regions_.readers(w);
      const bool harmless = std::all_of(readers.begin(), readers.end(), [&](Assignment mode) {
        return !at_odds(mode) || std::find(refused.begin(), refused.end(), mode) != refused.end();
      });
      if (!harmless) continue;
      swapped[w.index()] = true;
      open.push_back(w);
    }
  }
  return swapped;
}

/// After the proposal's decisions were found not to imply the guard. A refuting world is looked for that keeps as many
/// attributes as the proofs of its impossibility allow. Whatever world the values of those that are swapped, put in
/// place of its own, turn into one that satisfies the store and refutes the guard, it proposes no precondition: its own
/// decisions admit that other world. Only constraints that read what is swapped can tell, so only those are in what is
/// excluded.
void PreconditionFinder::exclude(const Question& question, const World& proposal) {
  std::vector<Assignment> fixed{source_};
  for (const VariableId v : question.decisions) fixed.push_back({v, proposal[v.index()]});
  std::vector<Assignment> kept;
  for (const VariableId v : question.attributes) kept.push_back({v, proposal[v.index()]});
  for (;;) {
    std::vector<Assignment> assumptions = fixed;
    assumptions.insert(assumptions.end(), kept.begin(), kept.end());
    if (theory_.allows(assumptions, question.refuted)) break;
    const std::vector<Assignment> blamed = theory_.conflict();
    std::erase_if(kept,
                  [&](const Assignment& a) { return std::find(blamed.begin(), blamed.end(), a) != blamed.end(); });
  }
  fixed.insert(fixed.end(), kept.begin(), kept.end());
  const World refuting = most_tolerant(question, fixed);
  const std::vector<bool> changed = swapped(question, proposal, refuting);

  const auto value_of = [&](VariableId v) {
    return changed[v.index()] ? std::optional(refuting[v.index()]) : std::nullopt;
  };
  std::vector<Formula> parts{negation(substituted(question.guard, value_of))};
  for (const automata::Interconnection& q : plant_.interconnections) {
    if (reads(q.constraint, changed)) parts.push_back(substituted(q.constraint, value_of));
  }
  for (const Component& component : plant_.components) {
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const Formula& constraint = component.modes[m].constraint;
      if (!reads(constraint, changed)) continue;
      parts.push_back(implication(is(component.mode, ValueId(m)), substituted(constraint, value_of)));
    }
  }
  theory_.tell_if(question.asked, negation(automata::conjunction(std::move(parts))));
  ++excluded_;
}

}  // namespace rmpl::runtime
