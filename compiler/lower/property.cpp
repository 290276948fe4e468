// From a file of properties to what is claimed of a plant, and of a program.
// SPDX-License-Identifier: MIT
#include "compiler/lower/property.hpp"

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "base/overloaded.hpp"
#include "compiler/check/plant_resolver.hpp"
#include "compiler/lower/part.hpp"
#include "compiler/lower/requirements.hpp"
#include "compiler/lower/timing.hpp"

namespace rmpl::compiler {

using automata::PlantProperty;
using grammar::Code;
using Claim = PlantProperty::Claim;

namespace {

/// What stands once: the index of an item's kind, all claims counting as one.
std::size_t subject_of(const grammar::PropertyItem& item) {
  constexpr std::size_t last_claim = 6;
  return item.index() <= last_claim ? 0 : item.index();
}

grammar::Span span_of(const grammar::PropertyItem& item) {
  return std::visit([](const auto& part) { return part.span; }, item);
}

Claim claim_of(grammar::GeneralClaim::Kind kind) {
  using Kind = grammar::GeneralClaim::Kind;
  switch (kind) {
    case Kind::stuck:
      return Claim::stuck;
    case Kind::goal_conflict:
      return Claim::goal_conflict;
    case Kind::no_plan:
      return Claim::no_plan;
    case Kind::endless_wait:
      return Claim::endless_wait;
    case Kind::termination:
      return Claim::termination;
    case Kind::undone:
      return Claim::undone;
  }
  return Claim::stuck;
}

class PropertyLowering {
 public:
  PropertyLowering(const grammar::Sources& sources, const automata::Plant& plant, bool under_program,
                   grammar::Diagnostics& diagnostics)
      : sources_(sources),
        plant_(plant),
        under_program_(under_program),
        diagnostics_(diagnostics),
        resolver_(plant, nullptr, diagnostics) {}

  /// `start`: of the file, to blame where it states nothing.
  std::vector<PlantProperty> run(const grammar::PropertyFile& file, grammar::Span start) {
    PlantProperty settings;
    add_all(file.defaults, settings);
    if (file.properties.empty()) {
      auto& error = diagnostics_.error(Code::no_property, start, "the file states no property");
      error.suggestion = "add `property \"name\" { never …; }`";
    }
    std::vector<PlantProperty> result;
    std::map<std::string, grammar::Span> names;
    for (const grammar::PropertyDefinition& definition : file.properties) {
      const auto [first, fresh] = names.emplace(definition.name.text, definition.name.span);
      if (!fresh) {
        report_twice(definition.name.span, "a second property " + quoted(definition.name.text), first->second);
      }
      PlantProperty property = settings;
      property.hazard = definition.hazard;
      property.name = definition.name.text;
      property.origin = origin_of(sources_, definition.span);
      if (!add_all(definition.items, property)) {
        diagnostics_.error(
            Code::property_without_claim, definition.name.span,
            "the property claims nothing, expected `never`, `reach`, `after`, `probability` or `program`");
      }
      if (property.of_program) demand_program(definition);
      if (property.hazard) demand_exclusion(definition);
      result.push_back(std::move(property));
    }
    return result;
  }

 private:
  static std::string quoted(const std::string& text) { return '"' + text + '"'; }

  void report_twice(grammar::Span span, const std::string& what, grammar::Span first) {
    diagnostics_.error(Code::property_repeated_part, span, what).notes.push_back({first, "the first is here"});
  }

  /// What a claim on a program needs, and what it leaves no room for.
  void demand_program(const grammar::PropertyDefinition& definition) {
    for (const grammar::PropertyItem& item : definition.items) {
      if (subject_of(item) == 0 && !under_program_) {
        auto& error = diagnostics_.error(Code::property_without_program, span_of(item),
                                         "this is claimed of a program, and none is given");
        error.suggestion = "give the program after the properties";
      }
      if (std::holds_alternative<grammar::CommandsSetting>(item)) {
        diagnostics_.error(Code::property_commands_of_program, span_of(item),
                           "under a program the executive commands: nothing is left for `commands` to say");
      }
    }
  }

  /// A hazard is what is never to be, or to be improbable.
  void demand_exclusion(const grammar::PropertyDefinition& definition) {
    for (const grammar::PropertyItem& item : definition.items) {
      const auto* probability = std::get_if<grammar::ProbabilityClaim>(&item);
      const bool excludes =
          std::holds_alternative<grammar::NeverClaim>(item) || (probability != nullptr && !probability->at_least);
      if (subject_of(item) != 0 || excludes) continue;
      diagnostics_.error(Code::property_without_claim, span_of(item),
                         "a hazard is what is never to be, expected `never` or `probability of … at most`");
    }
  }

  /// Whether a claim is among them.
  bool add_all(const std::vector<grammar::PropertyItem>& items, PlantProperty& property) {
    constexpr std::array names = {"claim",         "claim",      "claim",    "claim",        "claim",  "claim",
                                  "claim",         "`faults`",   "`time`",   "`commands`",   "`from`", "`entailed`",
                                  "`allow-stuck`", "`severity`", "`expect`", "`requirement`"};
    static_assert(names.size() == std::variant_size_v<grammar::PropertyItem>);
    std::map<std::size_t, grammar::Span> seen;
    TagPlaces tagged;
    for (const grammar::PropertyItem& item : items) {
      if (const auto* part = std::get_if<grammar::RequirementPart>(&item)) {
        for (std::string& tag : fresh_tags(part->tags, tagged, diagnostics_)) {
          property.requirements.push_back(std::move(tag));
        }
        continue;
      }
      const auto [first, fresh] = seen.emplace(subject_of(item), span_of(item));
      if (!fresh) report_twice(span_of(item), std::string("a second ") + names.at(item.index()), first->second);
      std::visit([&](const auto& part) { add(part, property); }, item);
    }
    return seen.count(0) > 0;
  }

  /// What is claimed of a program may ask of its executive's knowledge.
  automata::Formula formula(const grammar::Constraint& constraint, bool of_program) {
    resolver_.ask_of_knowledge(of_program ? std::nullopt
                                          : std::optional<std::string>("of a plant alone, that no executive flies"));
    return resolver_.resolve(constraint);
  }

  void add(const grammar::NeverClaim& part, PlantProperty& property) {
    property.claim = Claim::never;
    property.of_program = part.of_program;
    property.formula = formula(part.constraint, part.of_program);
  }
  void add(const grammar::ReachClaim& part, PlantProperty& property) {
    property.claim = Claim::reach;
    property.formula = formula(part.constraint, false);
  }
  void add(const grammar::ResponseClaim& part, PlantProperty& property) {
    property.claim = Claim::response;
    property.of_program = part.of_program;
    property.formula = formula(part.after, part.of_program);
    property.then = formula(part.then, part.of_program);
    if (const auto within = ticks_of(part.within, diagnostics_)) property.within = *within;
  }
  void add(const grammar::EventuallyClaim& part, PlantProperty& property) {
    property.claim = Claim::eventually;
    property.of_program = true;
    property.formula = formula(part.constraint, true);
    if (const auto within = ticks_of(part.within, diagnostics_)) property.within = *within;
  }
  void add(const grammar::FinallyClaim& part, PlantProperty& property) {
    property.claim = Claim::finally;
    property.of_program = true;
    property.formula = formula(part.constraint, true);
  }
  void add(const grammar::ProbabilityClaim& part, PlantProperty& property) {
    property.claim = Claim::probability;
    property.of_program = part.of_program;
    property.formula = formula(part.constraint, false);
    property.within = automata::Ticks::infinite();
    if (part.within) property.within = ticks_of(*part.within, diagnostics_).value_or(property.within);
    property.at_least = part.at_least;
    property.bound = part.bound.value;
    if (!(property.bound >= 0 && property.bound <= 1)) {
      diagnostics_.error(Code::probability_out_of_range, part.bound.span, "a probability is a number from 0 to 1");
    }
  }
  static void add(const grammar::SeveritySetting& part, PlantProperty& property) {
    using Written = grammar::SeveritySetting::Severity;
    using Severity = PlantProperty::Severity;
    switch (part.severity) {
      case Written::catastrophic:
        property.severity = Severity::catastrophic;
        return;
      case Written::critical:
        property.severity = Severity::critical;
        return;
      case Written::major:
        property.severity = Severity::major;
        return;
      case Written::minor:
        property.severity = Severity::minor;
        return;
    }
  }
  void add(const grammar::GeneralClaim& part, PlantProperty& property) {
    property.claim = claim_of(part.kind);
    property.of_program = part.of_program;
  }
  static void add(const grammar::RequirementPart&, PlantProperty&) {}
  static void add(const grammar::AllowStuckSetting&, PlantProperty& property) { property.allow_stuck = true; }
  void add(const grammar::FaultsSetting& part, PlantProperty& property) {
    // More than any plant has components is as many as one likes.
    property.faults_stated = true;
    property.faults = static_cast<unsigned>(std::min<std::uint64_t>(part.count, std::numeric_limits<unsigned>::max()));
  }
  void add(const grammar::TimeSetting& part, PlantProperty& property) {
    property.period.reset();
    if (!part.period) return;
    property.period = ticks_of(*part.period, diagnostics_);
    if (property.period && (property.period == automata::Ticks{0} || property.period->is_infinite())) {
      diagnostics_.error(Code::property_period, part.period->span, "a period is longer than 0, and finite");
    }
  }
  void add(const grammar::CommandsSetting& part, PlantProperty& property) {
    switch (part.freedom) {
      case grammar::CommandsSetting::Freedom::none:
        property.commands = PlantProperty::Commands::none;
        return;
      case grammar::CommandsSetting::Freedom::one:
        property.commands = PlantProperty::Commands::one;
        return;
      case grammar::CommandsSetting::Freedom::any:
        property.commands = PlantProperty::Commands::any;
        return;
    }
  }
  void add(const grammar::FromSetting& part, PlantProperty& property) {
    property.from.clear();
    std::map<automata::VariableId, grammar::Span> given;
    for (const grammar::AssignmentText& text : part.modes) {
      const auto mode = resolver_.assignment(text.variable, text.value);
      if (!mode) continue;
      if (!plant_.component_of(mode->variable)) {
        diagnostics_.error(Code::property_not_a_mode, text.variable.span,
                           backquoted(text.variable.text) + " is an attribute, expected a component");
        continue;
      }
      const auto [first, fresh] = given.emplace(mode->variable, text.span);
      if (!fresh) report_twice(text.span, "a second mode of " + backquoted(text.variable.text), first->second);
      property.from.push_back(*mode);
    }
  }
  void add(const grammar::EntailedSetting&, PlantProperty& property) { property.entailed = true; }
  void add(const grammar::ExpectedVerdict& part, PlantProperty& property) { property.expect_violated = part.violated; }

  const grammar::Sources& sources_;
  const automata::Plant& plant_;
  bool under_program_;
  grammar::Diagnostics& diagnostics_;
  PlantResolver resolver_;
};

}  // namespace

std::vector<PlantProperty> lower_properties(const grammar::Sources& sources, const grammar::PropertyFile& file,
                                            grammar::Span start, const automata::Plant& plant, bool under_program,
                                            grammar::Diagnostics& diagnostics) {
  return PropertyLowering(sources, plant, under_program, diagnostics).run(file, start);
}

}  // namespace rmpl::compiler
