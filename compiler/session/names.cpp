// The index of names: mentions in order, and the walk through the trees that finds them.
// SPDX-License-Identifier: MIT
#include "compiler/session/names.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/overloaded.hpp"
#include "compiler/session/name_scopes.hpp"

namespace rmpl::compiler {

using grammar::Name;

namespace {

/// Finds the mentions of one file. Trees may be parts: names may be empty, and then they are no mention.
class Walk {
 public:
  Walk(const NameScopes& scopes, std::vector<Mention>& mentions) : scopes_(scopes), mentions_(mentions) {}

  void run(const File& file) {
    if (file.plant) items(file.plant->items);
    if (file.program) items(file.program->items);
    if (file.properties) {
      items(file.properties->defaults);
      for (const grammar::PropertyDefinition& property : file.properties->properties) items(property.items);
    }
    if (file.monitors) {
      for (const grammar::MonitorDefinition& monitor : file.monitors->monitors) add(monitor);
    }
    if (!file.scenarios) return;
    for (const grammar::ScenarioDefinition& scenario : file.scenarios->scenarios) {
      declare(scenario.name.span, NameKind::scenario);
      items(scenario.items);
    }
  }

 private:
  void declare(grammar::Span span, NameKind kind) {
    if (span.begin != span.end) mentions_.push_back({span, kind, span});
  }
  void refer(const Name& name, const Declared* to) {
    if (to != nullptr && !name.text.empty()) mentions_.push_back({name.span, to->kind, to->span});
  }

  /// A name of the scope that the walk is in, part by part.
  void refer(const Name& name) {
    if (const auto own = own_.find(name.text); own != own_.end()) return refer(name, &own->second);
    for (const NamePart& part : type_.empty() ? scopes_.visible_parts(name.text) : scopes_.parts(type_, name.text)) {
      const auto begin = name.span.begin + static_cast<std::uint32_t>(part.begin);
      const grammar::Span span{name.span.file, begin, begin + static_cast<std::uint32_t>(part.length)};
      mentions_.push_back({span, part.declared->kind, part.declared->span});
    }
  }

  void items(const auto& list) {
    for (const auto& item : list) std::visit([this](const auto& one) { this->add(one); }, item);
  }

  // What all languages share.
  void add(const grammar::Import&) {}
  void add(const grammar::Values& values) {
    for (const Name& name : values.names) declare(name.span, NameKind::value);
  }
  void add(const grammar::Domain& domain) {
    declare(domain.name.span, NameKind::domain);
    add(domain.values);
  }
  void add(const grammar::DomainRef& domain) {
    if (const auto* values = std::get_if<grammar::Values>(&domain)) return add(*values);
    const Name& name = std::get<Name>(domain);
    refer(name, scopes_.domain(name.text));
  }
  void add(const grammar::Observe& observe) {
    for (const Name& name : observe.names) refer(name);
  }
  void add(const grammar::Control& control) {
    for (const Name& name : control.names) {
      const Declared* variable = find(name.text);
      refer(name);
      if (variable != nullptr && control.idle) refer(*control.idle, scopes_.value(*variable, control.idle->text));
    }
  }

  // Plants.
  void add(const grammar::AttributeDeclaration& attribute) {
    for (const Name& name : attribute.names) declare(name.span, NameKind::attribute);
    add(attribute.domain);
  }
  void add(const grammar::ComponentDefinition& component) {
    declare(component.name.span, NameKind::component);
    type_ = component.name.text;
    items(component.items);
    type_.clear();
  }
  void add(const grammar::ModuleDefinition& module) {
    declare(module.name.span, module.plant ? NameKind::plant : NameKind::module);
    type_ = module.name.text;
    items(module.items);
    type_.clear();
  }
  void mode(const std::string& type, const Name& name) {
    refer(name, scopes_.value({{}, NameKind::instance, nullptr, type}, name.text));
  }
  void add(const grammar::Initial& initial) {
    for (const grammar::InitialMode& start : initial.modes) mode(type_, start.mode);
  }
  void add(const grammar::ModeDeclaration& declaration) {
    declare(declaration.name.span, NameKind::mode);
    if (declaration.constraint) add(*declaration.constraint);
  }
  void add(const grammar::TransitionText& transition) {
    if (const auto* named = std::get_if<grammar::NamedSources>(&transition.sources.node)) {
      for (const Name& name : named->modes) mode(type_, name);
    }
    for (const grammar::Branch& branch : transition.branches) mode(type_, branch.target);
    if (transition.guard) add(*transition.guard);
  }
  void add(const grammar::InstanceDeclaration& instance) {
    for (const Name& name : instance.names) declare(name.span, NameKind::instance);
    refer(instance.type, instance.model ? scopes_.definition(instance.type.text) : scopes_.type(instance.type.text));
    if (!instance.initial || instance.model) return;
    for (const grammar::InitialMode& start : instance.initial->modes) mode(instance.type.text, start.mode);
  }
  void add(const grammar::Interconnection& interconnection) { add(interconnection.constraint); }

  // Programs.
  void add(const grammar::VariableDeclaration& variable) {
    for (const Name& name : variable.names) declare(name.span, NameKind::variable);
    add(variable.domain);
  }
  void add(const grammar::StandingConstraint& standing) { add(standing.constraint); }
  void add(const grammar::Definition& definition) {
    declare(definition.name.span, NameKind::definition);
    for (const Name& parameter : definition.parameters) {
      declare(parameter.span, NameKind::parameter);
      own_.emplace(parameter.text, Declared{parameter.span, NameKind::parameter, nullptr, {}});
    }
    for (const Name& clock : definition.clocks) {
      declare(clock.span, NameKind::clock);
      own_.emplace(clock.text, Declared{clock.span, NameKind::clock, nullptr, {}});
    }
    add(definition.body);
    own_.clear();
  }
  void add(const grammar::Body& body) {
    for (const grammar::Sequence& thread : body.threads) {
      for (const grammar::Step& step : thread.steps) add(step);
    }
  }
  void add(const grammar::Step& step) {
    std::visit([this](const auto& node) { add(node); }, step.node);
  }
  void add(const grammar::Goal& goal) { add(goal.constraint); }
  void add(const grammar::ClockStart& start) { clock(start.clock); }
  void add(const grammar::Call& call) {
    refer(call.definition, scopes_.definition(call.definition.text));
    for (const grammar::Argument& argument : call.arguments) {
      if (const auto* constraint = std::get_if<grammar::Constraint>(&argument.node)) add(*constraint);
      if (const auto* name = std::get_if<Name>(&argument.node)) refer(*name);
    }
  }
  void add(const grammar::Block& block) { add(block.body); }
  void add(const grammar::If& step) {
    add(step.condition);
    add(*step.step);
    if (step.otherwise) add(**step.otherwise);
  }
  void add(const grammar::Always& step) { add(*step.step); }
  void add(const grammar::Nothing&) {}
  void add(const grammar::Each& each) { add(each.body); }
  void add(const grammar::Repeat& step) { add(*step.step); }
  void add(const grammar::Next& step) { add(*step.step); }
  void add(const grammar::Choose& choose) {
    for (const grammar::Choice& choice : choose.choices) add(choice.step);
  }
  template <class Guarded>
  requires requires(const Guarded& step) { step.condition, step.step; }
  void add(const Guarded& step) {
    add(step.condition);
    add(*step.step);
  }
  /// A clock is declared by what mentions it first.
  void clock(const Name& name) {
    if (name.text.empty()) return;
    const auto own = own_.find(name.text);
    if (own != own_.end()) return refer(name, &own->second);
    const auto [known, fresh] = clocks_.emplace(name.text, Declared{name.span, NameKind::clock, nullptr, {}});
    refer(name, &known->second);
  }

  // Scenarios.
  void add(const grammar::ProgramPart& part) {
    if (part.main) refer(*part.main, scopes_.definition(part.main->text));
  }
  void add(const grammar::TruthPart& part) {
    for (const grammar::AssignmentText& assignment : part.modes) add(assignment);
  }
  void add(const grammar::FaultEvent& event) { add(event.mode); }
  void add(const grammar::ObserveEvent& event) { add(event.reading); }
  void add(const grammar::CommandEvent& event) { add(event.command); }
  void add(const grammar::RuleText& rule) {
    add(rule.trigger);
    add(rule.reading);
  }
  void add(const grammar::ExpectText& expectation) {
    if (expectation.condition) add(*expectation.condition);
    if (expectation.after) add(*expectation.after);
  }
  void add(const grammar::AssignmentText& assignment) { compared(assignment.variable, assignment.value); }
  void add(const grammar::PlantPart&) {}
  void add(const grammar::CyclePart&) {}
  void add(const grammar::DurationPart&) {}
  void add(const grammar::SeedPart&) {}
  void add(const grammar::RequirementPart&) {}

  void add(const grammar::ChannelEvent& event) { channel(event.channel); }
  void channel(const grammar::String& name) {
    const Declared* to = scopes_.channel(name.text);
    if (to != nullptr && name.span.begin != name.span.end) mentions_.push_back({name.span, to->kind, to->span});
  }

  // Monitors.
  void add(const grammar::MonitorDefinition& monitor) {
    channel(monitor.channel);
    if (monitor.minus) channel(*monitor.minus);
    const Declared* attribute = find(monitor.attribute.text);
    refer(monitor.attribute);
    if (attribute == nullptr) return;
    const auto mean = [&](const Name& value) { refer(value, scopes_.value(*attribute, value.text)); };
    for (const grammar::MonitorItem& item : monitor.items) {
      if (const auto* band = std::get_if<grammar::BandText>(&item)) mean(band->value);
      if (const auto* literals = std::get_if<grammar::LiteralsText>(&item)) mean(literals->value);
    }
  }

  // Properties.
  void add(const grammar::NeverClaim& claim) { add(claim.constraint); }
  void add(const grammar::ReachClaim& claim) { add(claim.constraint); }
  void add(const grammar::ResponseClaim& claim) {
    add(claim.after);
    add(claim.then);
  }
  void add(const grammar::EventuallyClaim& claim) { add(claim.constraint); }
  void add(const grammar::FinallyClaim& claim) { add(claim.constraint); }
  void add(const grammar::ProbabilityClaim& claim) { add(claim.constraint); }
  void add(const grammar::GeneralClaim&) {}
  void add(const grammar::FromSetting& setting) {
    for (const grammar::AssignmentText& assignment : setting.modes) add(assignment);
  }
  void add(const grammar::FaultsSetting&) {}
  void add(const grammar::TimeSetting&) {}
  void add(const grammar::CommandsSetting&) {}
  void add(const grammar::EntailedSetting&) {}
  void add(const grammar::AllowStuckSetting&) {}
  void add(const grammar::SeveritySetting&) {}
  void add(const grammar::ExpectedVerdict&) {}

  // Constraints.
  void add(const grammar::Constraint& constraint) {
    std::visit(base::Overloaded{[](const grammar::Truth&) {}, [this](const grammar::Reference& r) { refer(r.name); },
                                [this](const grammar::Comparison& c) { compared(c.left, c.right); },
                                [this](const grammar::Membership& m) {
                                  const Declared* variable = find(m.variable.text);
                                  refer(m.variable);
                                  for (const Name& name : m.values) value(variable, name);
                                },
                                [this](const grammar::ClockBound& b) { clock(b.clock); },
                                [this](const grammar::KnowledgeAtom& k) {
                                  if (k.component) refer(*k.component);
                                  for (const grammar::Constraint& operand : k.operands) add(operand);
                                },
                                [this](const auto& connective) {
                                  for (const grammar::Constraint& operand : connective.operands) add(operand);
                                }},
               constraint.node);
  }
  void compared(const Name& variable, const Name& right) {
    const Declared* found = find(variable.text);
    refer(variable);
    value(found, right);
  }
  /// A value of a variable, or what else the name stands for.
  void value(const Declared* variable, const Name& name) {
    const Declared* value = variable == nullptr ? nullptr : scopes_.value(*variable, name.text);
    if (value != nullptr) return refer(name, value);
    refer(name);
  }
  const Declared* find(std::string_view name) const {
    if (const auto own = own_.find(name); own != own_.end()) return &own->second;
    return type_.empty() ? scopes_.visible(name) : scopes_.member(type_, name);
  }

  const NameScopes& scopes_;
  std::vector<Mention>& mentions_;
  std::string type_;  ///< that the walk is in
  Members own_;       ///< of the definition that the walk is in: its parameters
  Members clocks_;
};

}  // namespace

NameIndex::NameIndex(std::vector<Mention> mentions) : mentions_(std::move(mentions)) {
  std::sort(mentions_.begin(), mentions_.end());
  const auto same_place = [](const Mention& a, const Mention& b) { return a.span == b.span; };
  mentions_.erase(std::unique(mentions_.begin(), mentions_.end(), same_place), mentions_.end());
}

std::optional<Mention> NameIndex::at(std::uint32_t file, std::uint32_t offset) const {
  const auto begins_behind = [](const std::pair<std::uint32_t, std::uint32_t>& place, const Mention& mention) {
    return place < std::pair(mention.span.file, mention.span.begin);
  };
  const auto next = std::upper_bound(mentions_.begin(), mentions_.end(), std::pair(file, offset), begins_behind);
  if (next == mentions_.begin()) return std::nullopt;
  const Mention& found = *std::prev(next);
  if (found.span.file != file || offset > found.span.end) return std::nullopt;
  return found;
}

std::vector<Mention> NameIndex::of(grammar::Span declaration) const {
  std::vector<Mention> found;
  for (const Mention& mention : mentions_) {
    if (mention.declaration == declaration) found.push_back(mention);
  }
  return found;
}

NameIndex index_names(std::span<const File* const> files) {
  const NameScopes scopes(files);
  std::vector<Mention> mentions;
  Walk walk(scopes, mentions);
  for (const File* file : files) walk.run(*file);
  return NameIndex(std::move(mentions));
}

}  // namespace rmpl::compiler
