// Component types become automata: modes, attributes, transitions.
// SPDX-License-Identifier: MIT
#include "compiler/lower/component.hpp"

#include <algorithm>
#include <utility>

#include "compiler/check/probabilities.hpp"
#include "compiler/lower/attributes.hpp"
#include "compiler/lower/initial.hpp"
#include "compiler/lower/timing.hpp"

namespace rmpl::compiler {

using automata::ModeId;
using automata::Transition;
using automata::Weight;
using grammar::Code;

namespace {

/// The names of a component type: its own attributes. A name of another component gets an error of its own.
class ComponentResolver final : public Resolver {
 public:
  ComponentResolver(const Part& part, const Vocabulary& vocabulary, grammar::Diagnostics& diagnostics)
      : Resolver(vocabulary, diagnostics), part_(part) {}

 protected:
  [[nodiscard]] bool lost_its_meaning(const grammar::Name& name) const override { return is_broken(part_, name.text); }
  void report_unknown(const grammar::Name& name) override {
    if (name.text.find('.') == std::string::npos) return Resolver::report_unknown(name);
    auto& error = diagnostics().error(Code::foreign_guard, name.span,
                                      backquoted(name.text) + " is no attribute of " + vocabulary().owner +
                                          "; guards and mode constraints read only attributes of their own component");
    error.suggestion = "declare an input, and connect it in the module or plant that holds the instance";
  }

 private:
  const Part& part_;
};

Vocabulary vocabulary_of(const Part& part) {
  return {part.plant.variables, &part.declared, "component " + backquoted(part.plant.name), Code::unknown_name};
}

std::vector<std::string> mode_names(const automata::Component& component) {
  std::vector<std::string> names;
  for (const automata::Mode& mode : component.modes) names.push_back(mode.name);
  return names;
}

}  // namespace

Part ComponentLowering::run(const grammar::ComponentDefinition& definition) {
  part_.plant.name = definition.name.text;
  automata::Component& automaton = part_.plant.components.emplace_back();
  automaton.type = definition.name.text;
  automaton.progress = definition.progress;
  automaton.origin = origin_of(sources_, definition.name.span);
  declare_modes(definition);
  declare_attributes(definition);
  constrain_modes(definition);
  set_initial(definition);
  ComponentResolver resolver(part_, vocabulary_of(part_), diagnostics_);
  for (const grammar::ComponentItem& item : definition.items) {
    if (const auto* text = std::get_if<grammar::TransitionText>(&item)) add_transitions(*text, resolver);
  }
  check_fault_sums(part_.plant, transition_spans_, mode_names_, diagnostics_);
  return std::move(part_);
}

void ComponentLowering::declare_modes(const grammar::ComponentDefinition& definition) {
  Uniqueness names("mode", diagnostics_);
  automata::Variable variable;
  for (const grammar::ComponentItem& item : definition.items) {
    const auto* declaration = std::get_if<grammar::ModeDeclaration>(&item);
    if (declaration == nullptr || !names.add(declaration->name)) continue;
    automata::Mode mode;
    mode.name = declaration->name.text;
    mode.fault = declaration->fault;
    mode.reward = declaration->reward ? declaration->reward->value : 0;
    mode.origin = origin_of(sources_, declaration->name.span);
    modes_.emplace(mode.name, ModeId(component().modes.size()));
    variable.values.push_back(mode.name);
    component().modes.push_back(std::move(mode));
    mode_names_.push_back(declaration->name.span);
  }
  if (component().modes.empty()) {
    diagnostics_.error(Code::no_modes, definition.name.span,
                       "component " + backquoted(definition.name.text) + " has no mode, expected at least one");
  }
  component().mode = part_.plant.variables.add(std::move(variable));
  part_.declared.push_back(definition.name.span);
  // A component costs about as much as eight values, and its modes stand in its domain too.
  make_room(part_, 8 + 2 * component().modes.size(), definition.name.span, diagnostics_);
}

void ComponentLowering::declare_attributes(const grammar::ComponentDefinition& definition) {
  Uniqueness names("attribute", diagnostics_);
  for (const grammar::ComponentItem& item : definition.items) {
    if (const auto* declaration = std::get_if<grammar::AttributeDeclaration>(&item)) {
      declare(part_, declaration->names, declaration->domain, names, domains_, diagnostics_);
    }
  }
}

void ComponentLowering::constrain_modes(const grammar::ComponentDefinition& definition) {
  ComponentResolver resolver(part_, vocabulary_of(part_), diagnostics_);
  std::vector<bool> constrained(component().modes.size(), false);
  for (const grammar::ComponentItem& item : definition.items) {
    const auto* declaration = std::get_if<grammar::ModeDeclaration>(&item);
    if (declaration == nullptr || !declaration->constraint) continue;
    automata::Formula constraint = resolver.resolve(*declaration->constraint);
    const std::size_t position = modes_.at(declaration->name.text).index();
    if (constrained[position]) continue;  // a second mode of this name, reported
    constrained[position] = true;
    component().modes[position].constraint = std::move(constraint);
  }
}

void ComponentLowering::set_initial(const grammar::ComponentDefinition& definition) {
  const grammar::Initial* first = nullptr;
  for (const grammar::ComponentItem& item : definition.items) {
    const auto* initial = std::get_if<grammar::Initial>(&item);
    if (initial == nullptr) continue;
    if (first != nullptr) {
      auto& error =
          diagnostics_.error(Code::duplicate_name, initial->span,
                             "component " + backquoted(definition.name.text) + " has two initial distributions");
      error.notes.push_back({first->span, "the first is here"});
      continue;
    }
    first = initial;
    if (auto distribution = initial_distribution(*initial, component(), diagnostics_)) {
      component().initial = std::move(*distribution);
    }
  }
  if (first == nullptr && !component().modes.empty()) {
    auto& error = diagnostics_.error(Code::initial_distribution, definition.name.span,
                                     "component " + backquoted(definition.name.text) + " has no initial mode");
    error.suggestion = "add `initial " + component().modes.front().name + ";`";
  }
}

void ComponentLowering::add_transitions(const grammar::TransitionText& text, Resolver& resolver) {
  Transition common;
  common.branch = branches_++;
  common.origin = origin_of(sources_, text.span);
  if (text.guard) common.guard = resolver.resolve(*text.guard);
  if (text.timing) common.timing = timing_of(*text.timing, diagnostics_);
  if (common.timing && has_nominal_target(text) && !check_density(*common.timing, text.timing->span, diagnostics_)) {
    common.timing.reset();
  }
  if (!text.braced) {
    const grammar::Branch& only = text.branches.front();
    const auto weight = only.weight ? weight_of(*only.weight, diagnostics_) : std::nullopt;
    return add_transition(text, only, weight.value_or(Weight{}), common);
  }
  Uniqueness targets("target", diagnostics_);
  std::vector<const grammar::Number*> numbers;
  for (const grammar::Branch& branch : text.branches) {
    targets.add(branch.target);
    numbers.push_back(&std::get<grammar::ProbabilityWeight>(*branch.weight).probability);
  }
  const grammar::Span list = join(text.branches.front().span, text.branches.back().span);
  const auto shares = probabilities_of(numbers, list, Code::branch_distribution, "branch", diagnostics_);
  for (std::size_t b = 0; b < text.branches.size(); ++b) {
    const double share = shares ? (*shares)[b] : 0;
    add_transition(text, text.branches[b], {Weight::Kind::probability, share}, common);
  }
}

bool ComponentLowering::has_nominal_target(const grammar::TransitionText& text) {
  return std::any_of(text.branches.begin(), text.branches.end(), [&](const grammar::Branch& branch) {
    const auto target = modes_.find(branch.target.text);
    return target != modes_.end() && !component().modes[target->second.index()].fault;
  });
}

void ComponentLowering::add_transition(const grammar::TransitionText& text, const grammar::Branch& branch,
                                       Weight weight, Transition common) {
  common.weight = weight;
  const auto target = mode(branch.target);
  if (!target) {
    sources_of(text, ModeId(component().modes.size()));  // for the errors in the sources
    return;
  }
  const bool fault = component().modes[target->index()].fault && !text.restart;
  if (fault && !branch.weight) {
    auto& error = diagnostics_.error(
        Code::fault_without_probability, branch.target.span,
        "a transition into the fault mode " + backquoted(branch.target.text) + " needs a probability or a rate");
    error.notes.push_back({mode_names_[target->index()], backquoted(branch.target.text) + " is declared a fault here"});
    error.suggestion = "add `with 0.001` or `with rate 1e-6 /h`";
  }
  const bool repair = !fault && branch.weight && std::holds_alternative<grammar::RateWeight>(*branch.weight);
  const std::vector<ModeId> sources = sources_of(text, *target);
  if (text.restart) {
    if (!may_restart(text, branch, *target, sources)) return;
    common.restart = true;
  } else if (repair) {
    repair_with_rate(text, branch, *target, sources, common);
  }
  common.to = *target;
  for (const ModeId source : sources) {
    if (!make_room(part_, 1, branch.span, diagnostics_)) return;
    Transition transition = common;
    transition.from = source;
    report_twin(transition, branch.span);
    component().transitions.push_back(std::move(transition));
    transition_spans_.push_back(branch.span);
  }
}

/// A restart leads from a mode to that mode, and takes no time: where it is enabled, nothing just stays.
bool ComponentLowering::may_restart(const grammar::TransitionText& text, const grammar::Branch& branch, ModeId target,
                                    const std::vector<ModeId>& sources) {
  const std::string name = backquoted(branch.target.text);
  const auto* named = std::get_if<grammar::NamedSources>(&text.sources.node);
  if (named == nullptr || sources != std::vector{target}) {
    // A source without a mode of that name has been reported.
    if (named != nullptr && sources.empty()) return false;
    auto& error =
        diagnostics_.error(Code::restart_not_allowed, named != nullptr ? named->modes.front().span : text.sources.span,
                           "a restart of " + name + " must leave from " + name + " itself");
    error.suggestion = "write `" + branch.target.text + " -> " + branch.target.text +
                       " restart when …`; a transition from another mode starts the clock without `restart`";
    return false;
  }
  if (text.timing) {
    auto& error = diagnostics_.error(Code::restart_not_allowed, text.timing->span,
                                     "a restart of " + name + " has time bounds: only a guard may trigger a restart");
    error.suggestion = "to cycle as time passes, use two modes";
    return false;
  }
  if (branch.weight && std::holds_alternative<grammar::RateWeight>(*branch.weight)) {
    auto& error = diagnostics_.error(Code::restart_not_allowed, std::get<grammar::RateWeight>(*branch.weight).rate.span,
                                     "a restart of " + name + " has a rate: only a guard may trigger a restart");
    error.suggestion = "leave out the rate";
    return false;
  }
  return true;
}

/// A repair at a rate takes an exponential time: what it leaves over is no chance of a step.
void ComponentLowering::repair_with_rate(const grammar::TransitionText& text, const grammar::Branch& branch,
                                         ModeId target, const std::vector<ModeId>& sources, Transition& common) {
  const grammar::Span at = std::get<grammar::RateWeight>(*branch.weight).rate.span;
  const auto nominal = std::find_if(sources.begin(), sources.end(),
                                    [&](ModeId source) { return !component().modes[source.index()].fault; });
  if (nominal != sources.end()) {
    auto& error =
        diagnostics_.error(Code::weight_not_allowed, at,
                           "a rate on a transition from " + backquoted(component().modes[nominal->index()].name) +
                               " to " + backquoted(branch.target.text) +
                               ", neither of which is a fault mode: only faults and their repairs have rates");
    error.notes.push_back({mode_names_[target.index()], backquoted(branch.target.text) + " is declared here"});
    error.suggestion = "write the time that it takes on average: `in [0 s, inf] ~ exponential(mean)`";
    return;
  }
  if (text.timing) {
    auto& error = diagnostics_.error(Code::weight_not_allowed, at, "a repair has both a rate and time bounds");
    error.suggestion = "leave out one of the two; the rate alone means `in [0 s, inf] ~ exponential(mean)`";
    return;
  }
  const double rate = common.weight.value;
  common.weight = rate > 0 ? Weight{} : Weight{Weight::Kind::probability, 0};
  if (rate == 0) return;
  common.timing =
      automata::Timing{{}, automata::Ticks::infinite(), {automata::Density::Kind::exponential, 1 / rate, 0}};
}

void ComponentLowering::report_twin(const Transition& transition, grammar::Span span) {
  auto& same_way = by_ends_[{transition.from, transition.to}];
  const auto bounds = [](const Transition& t) {
    return t.timing ? std::optional(std::pair(t.timing->lower, t.timing->upper)) : std::nullopt;
  };
  const auto is_twin = [&](std::size_t t) {
    const Transition& known = component().transitions[t];
    // What happens as time passes beside what happens in a step is two things; what never happens is none.
    const bool never = known.weight.value == 0 || transition.weight.value == 0;
    const bool weighed = known.weight.kind != Weight::Kind::none && transition.weight.kind != Weight::Kind::none;
    const bool two_things = weighed && (never || known.weight.kind != transition.weight.kind);
    return !two_things && known.restart == transition.restart && known.branch != transition.branch &&
           known.guard == transition.guard && bounds(known) == bounds(transition);
  };
  const auto twin = std::find_if(same_way.begin(), same_way.end(), is_twin);
  if (twin != same_way.end() && twins_.emplace(transition_spans_[*twin], span).second) {
    const auto name = [&](ModeId mode) { return backquoted(component().modes[mode.index()].name); };
    auto& warning = diagnostics_.warning(
        Code::duplicate_transition, span,
        "the transition from " + name(transition.from) + " to " + name(transition.to) + " is given twice");
    warning.notes.push_back({transition_spans_[*twin], "the first is here"});
  }
  constexpr std::size_t looked_at = 64;
  if (same_way.size() < looked_at) same_way.push_back(component().transitions.size());
}

std::vector<ModeId> ComponentLowering::sources_of(const grammar::TransitionText& text, ModeId target) {
  std::vector<ModeId> found;
  if (const auto* named = std::get_if<grammar::NamedSources>(&text.sources.node)) {
    Uniqueness names("source", diagnostics_);
    for (const grammar::Name& name : named->modes) {
      if (!names.add(name)) continue;
      if (const auto source = mode(name)) found.push_back(*source);
    }
    return found;
  }
  const bool nominal = std::get<grammar::AnySource>(text.sources.node).nominal;
  for (std::size_t m = 0; m < component().modes.size(); ++m) {
    if (ModeId(m) != target && !(nominal && component().modes[m].fault)) found.emplace_back(m);
  }
  return found;
}

std::optional<ModeId> ComponentLowering::mode(const grammar::Name& name) {
  if (const auto known = modes_.find(name.text); known != modes_.end()) return known->second;
  const std::size_t before = diagnostics_.error_count();
  auto& error =
      diagnostics_.error(Code::unknown_name, name.span,
                         "component " + backquoted(part_.plant.name) + " has no mode " + backquoted(name.text));
  suggest(error, before, name.text, mode_names(component()));
  return std::nullopt;
}

}  // namespace rmpl::compiler
