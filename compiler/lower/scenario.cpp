// Scenarios: times, events, rules and expectations over a plant.
// SPDX-License-Identifier: MIT
#include "compiler/lower/scenario.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/overloaded.hpp"
#include "compiler/check/mention.hpp"
#include "compiler/check/plant_resolver.hpp"
#include "compiler/lower/requirements.hpp"
#include "compiler/lower/software_mode.hpp"
#include "compiler/lower/timing.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Formula;
using automata::Ticks;
using automata::VariableId;
using grammar::Code;

namespace {

class ScenarioLowering {
 public:
  ScenarioLowering(const grammar::Sources& sources, const Part* plant, grammar::Diagnostics& diagnostics)
      : sources_(sources), plant_(plant), diagnostics_(diagnostics) {
    if (plant == nullptr) return;
    const automata::Plant& p = plant->plant;
    resolver_.emplace(p, &plant->declared, diagnostics);
    for (std::size_t c = 0; c < p.components.size(); ++c) {
      components_.emplace(p.components[c].mode, automata::ComponentId(c));
    }
    observables_.insert(p.observables.begin(), p.observables.end());
    for (const automata::Control& control : p.controls) controls_.insert(control.variable);
  }

  automata::Scenario run(const grammar::ScenarioDefinition& definition) {
    scenario_.name = definition.name.text;
    scenario_.origin = origin_of(sources_, definition.span);
    set_frame(definition);
    for (const grammar::ScenarioItem& item : definition.items) {
      std::visit([&](const auto& part) { add(part); }, item);
    }
    return std::move(scenario_);
  }

 private:
  /// Cycle, duration, seed and the kind of plant come first: other parts are judged by them.
  void set_frame(const grammar::ScenarioDefinition& definition) {
    const grammar::Span* cycle = nullptr;
    const grammar::Span* duration = nullptr;
    const grammar::Span* seed = nullptr;
    for (const grammar::ScenarioItem& item : definition.items) {
      std::visit(base::Overloaded{[&](const grammar::CyclePart& part) {
                                    const auto period = ticks_of(part.period, diagnostics_);
                                    if (!once(part.span, cycle, "cycle") || !period) return;
                                    if (*period == Ticks{0}) report_cycle(part.period.span);
                                    scenario_.cycle = *period;
                                  },
                                  [&](const grammar::DurationPart& part) {
                                    const auto length = ticks_of(part.duration, diagnostics_);
                                    if (once(part.span, duration, "duration") && length) scenario_.duration = *length;
                                  },
                                  [&](const grammar::PlantPart& part) { scenario_.rules_only = part.rules_only; },
                                  [&](const grammar::SeedPart& part) {
                                    if (once(part.span, seed, "seed")) scenario_.seed = part.seed;
                                  },
                                  [&](const grammar::RequirementPart& part) {
                                    for (std::string& tag : fresh_tags(part.tags, tagged_, diagnostics_)) {
                                      scenario_.requirements.push_back(std::move(tag));
                                    }
                                  },
                                  [](const auto&) {}},
                 item);
    }
  }

  bool once(const grammar::Span& span, const grammar::Span*& first, const char* what) {
    if (first == nullptr) {
      first = &span;
      return true;
    }
    auto& error = diagnostics_.error(Code::scenario_repeated_part, span, std::string("a second ") + what);
    error.notes.push_back({*first, "the first is here"});
    return false;
  }

  /// Where the plant follows the rules only, it has readings and nothing behind them.
  void report_no_truth(grammar::Span span, const std::string& what, const std::string& instead) {
    if (!scenario_.rules_only) return;
    diagnostics_
        .error(Code::scenario_without_truth, span, what + ", but this plant has no modes: it is declared `rules only`")
        .suggestion = instead;
  }

  void report_cycle(grammar::Span span) {
    diagnostics_.error(Code::scenario_finer_than_cycle, span, "the cycle is 0, expected a longer time");
  }

  void add(const grammar::ProgramPart&) {}
  void add(const grammar::CyclePart&) {}
  void add(const grammar::DurationPart&) {}
  void add(const grammar::SeedPart&) {}
  void add(const grammar::PlantPart&) {}
  void add(const grammar::RequirementPart&) {}

  void add(const grammar::TruthPart& part) {
    report_no_truth(part.span, "`truth` sets modes of the plant",
                    "leave it out: the estimate starts with the initial modes of the plant");
    for (const grammar::AssignmentText& text : part.modes) {
      const std::vector<Assignment> meant = modes_of(text, SoftwareMoment::start);
      const auto mode = the_one(text, meant);
      if (!mode) continue;
      const auto [first, fresh] = truths_.emplace(mode->variable, text.span);
      if (fresh) {
        scenario_.truth.push_back(*mode);
        continue;
      }
      auto& error = diagnostics_.error(Code::scenario_repeated_part, text.span,
                                       "the initial mode of " + backquoted(text.variable.text) + " is given twice");
      error.notes.push_back({first->second, "the first is here"});
    }
  }

  void add(const grammar::FaultEvent& event) {
    report_no_truth(event.span, "a fault sets a mode of the plant",
                    "give the readings that would show the fault: `at … observe x = v`");
    const auto at = time_of(event.at, event.span);
    const std::vector<Assignment> meant = modes_of(event.mode, SoftwareMoment::fault);
    const bool same = std::all_of(meant.begin(), meant.end(),
                                  [&](const Assignment& mode) { return mode.variable == meant.front().variable; });
    const auto mode = same && !meant.empty() ? std::optional(meant.front()) : the_one(event.mode, meant);
    if (!at || !mode) return;
    automata::ForcedMode forced{*at, components_.at(mode->variable), automata::ModeId(mode->value.index()),
                                origin_of(sources_, event.span)};
    const auto told = resolver_->assignment(event.mode.variable, event.mode.value);
    if (told != mode) forced.told = told;
    for (std::size_t m = 1; m < meant.size(); ++m) forced.also.emplace_back(meant[m].value.index());
    scenario_.forced.push_back(std::move(forced));
  }

  void add(const grammar::ObserveEvent& event) {
    const auto at = time_of(event.at, event.span);
    const auto length = event.duration ? ticks_of(*event.duration, diagnostics_) : Ticks::infinite();
    const auto reading = reading_of(event.reading);
    if (!at || !length || !reading) return;
    scenario_.overrides.push_back({*at, *length, *reading, origin_of(sources_, event.span)});
  }

  void add(const grammar::CommandEvent& event) {
    const auto at = time_of(event.at, event.span);
    const auto length = event.duration ? ticks_of(*event.duration, diagnostics_) : scenario_.cycle;
    const auto command = command_of(event.command);
    if (!at || !length || !command) return;
    scenario_.commands.push_back({*at, *length, *command, origin_of(sources_, event.span)});
  }

  /// What the channel means is not known here: monitors are an input of their own.
  void add(const grammar::ChannelEvent& event) {
    const auto at = time_of(event.at, event.span);
    if (!at) return;
    const auto [first, fresh] = sampled_.emplace(std::pair(event.channel.text, *at), event.span);
    if (!fresh) {
      auto& error = diagnostics_.error(
          Code::scenario_repeated_part, event.span,
          "a second sample of channel \"" + event.channel.text + "\" at " + automata::format_seconds(*at) + " s");
      error.notes.push_back({first->second, "the first is here"});
      return;
    }
    automata::ChannelSample sample{*at, event.channel.text, std::nullopt, {}, origin_of(sources_, event.span)};
    std::visit(base::Overloaded{[&](const grammar::String& text) { sample.text = text.text; },
                                [&](const grammar::Number& number) {
                                  sample.number = number.value;
                                  sample.text = number.text;
                                }},
               event.sample);
    scenario_.samples.push_back(std::move(sample));
  }

  void add(const grammar::RuleText& text) {
    const bool command = text.stream == grammar::RuleText::Stream::command;
    automata::Rule rule;
    rule.stream = command ? automata::Rule::Stream::command : automata::Rule::Stream::estimate;
    rule.origin = origin_of(sources_, text.span);
    if (text.delay) {
      if (const auto* cycles = std::get_if<grammar::Cycles>(&*text.delay)) rule.delay_cycles = cycles->count;
      if (const auto* delay = std::get_if<grammar::Duration>(&*text.delay)) rule.delay = ticks_of(*delay, diagnostics_);
    }
    const auto length = text.duration ? ticks_of(*text.duration, diagnostics_) : Ticks::infinite();
    if (resolver_) resolver_->ask_of_knowledge("in a rule: a rule describes the plant");
    const auto trigger = condition(text.trigger);
    const auto reading = reading_of(text.reading);
    if (trigger) check_trigger(*trigger, command, text.trigger);
    if (!length || !trigger || !reading) return;
    rule.trigger = *trigger;
    rule.reading = *reading;
    rule.duration = *length;
    scenario_.rules.push_back(std::move(rule));
  }

  void add(const grammar::ExpectText& text) {
    if (text.truth)
      report_no_truth(text.span, "`expect truth` reads modes of the plant", "expect the estimate: leave out `truth`");
    automata::Expectation expectation;
    switch (text.kind) {
      case grammar::ExpectText::Kind::eventually:
        expectation.kind = automata::Expectation::Kind::eventually;
        break;
      case grammar::ExpectText::Kind::never:
        expectation.kind = automata::Expectation::Kind::never;
        break;
      case grammar::ExpectText::Kind::finished:
        expectation.kind = automata::Expectation::Kind::finished;
        break;
      case grammar::ExpectText::Kind::never_finished:
        expectation.kind = automata::Expectation::Kind::never_finished;
        break;
      case grammar::ExpectText::Kind::goal_conflict:
        expectation.kind = automata::Expectation::Kind::goal_conflict;
        break;
      case grammar::ExpectText::Kind::no_plan:
        expectation.kind = automata::Expectation::Kind::no_plan;
        break;
    }
    expectation.truth = text.truth;
    expectation.origin = origin_of(sources_, text.span);
    expectation.text = written(text);
    if (text.requirement) {
      TagPlaces tagged = tagged_;
      expectation.requirements = fresh_tags(text.requirement->tags, tagged, diagnostics_);
    }
    if (text.within) expectation.within = deadline_of(*text.within, text.span);
    if (resolver_) {
      resolver_->ask_of_knowledge(text.truth ? std::optional<std::string>("in `expect truth`: it reads the plant")
                                             : std::nullopt);
    }
    if (text.condition) {
      if (auto formula = condition(*text.condition)) expectation.condition = std::move(*formula);
    }
    if (text.after) expectation.after = condition(*text.after);
    scenario_.expectations.push_back(std::move(expectation));
  }

  /// What stands between `expect` and `;`, or the requirements.
  std::string written(const grammar::ExpectText& expectation) {
    constexpr std::string_view keyword = "expect";
    constexpr std::string_view space = " \t\r\n";
    grammar::Span span = expectation.span;
    if (expectation.requirement) span.end = expectation.requirement->span.begin;
    std::string_view text = sources_.text(span);
    if (text.substr(0, keyword.size()) == keyword) text.remove_prefix(keyword.size());
    if (!text.empty() && text.back() == ';') text.remove_suffix(1);
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(space) - first + 1));
  }

  std::optional<Formula> condition(const grammar::Constraint& constraint) {
    if (!resolver_) return std::nullopt;
    return resolver_->resolve(constraint);
  }

  /// A time of an event; one behind the end of the scenario gets a warning, since the event never comes.
  std::optional<Ticks> time_of(const grammar::Duration& at, grammar::Span event) {
    const auto ticks = ticks_of(at, diagnostics_);
    if (ticks) warn_behind_end(*ticks, event, "this happens");
    return ticks;
  }

  /// A deadline; one behind the end of the scenario gets a warning, since it is judged before.
  std::optional<Ticks> deadline_of(const grammar::Duration& within, grammar::Span expectation) {
    const auto ticks = ticks_of(within, diagnostics_);
    if (ticks)
      warn_behind_end(*ticks, expectation,
                      "the " + automata::format_seconds(*ticks) + " s of this expectation have passed");
    return ticks;
  }

  void warn_behind_end(Ticks time, grammar::Span span, const std::string& what) {
    if (time <= scenario_.duration) return;
    diagnostics_.warning(
        Code::scenario_after_end, span,
        "the scenario ends after " + automata::format_seconds(scenario_.duration) + " s, before " + what);
  }

  /// Of software also those that tell it by themselves, of those that it may start in, or that are faults. None where
  /// that is wrong, which is reported.
  std::vector<Assignment> modes_of(const grammar::AssignmentText& text, SoftwareMoment moment) {
    if (!resolver_) return {};
    const auto mode = resolver_->assignment(text.variable, text.value);
    if (!mode) return {};
    if (components_.count(mode->variable) != 0) return {*mode};
    std::vector<Assignment> telling = modes_that_tell(plant_->plant, *mode, moment);
    if (!telling.empty()) return telling;
    const bool software = std::any_of(plant_->plant.components.begin(), plant_->plant.components.end(),
                                      [](const automata::Component& component) { return component.software; });
    const std::string which = moment == SoftwareMoment::start ? "no start" : "no fault";
    auto& error = diagnostics_.error(
        Code::scenario_not_a_mode, text.variable.span,
        backquoted(text.variable.text) + " is an attribute, expected a component" +
            (software ? ": " + which + " of software tells that it is " + backquoted(text.value.text) : ""));
    note_domain(error, mode->variable);
    return {};
  }

  /// If there are several, that is reported.
  std::optional<Assignment> the_one(const grammar::AssignmentText& text, const std::vector<Assignment>& meant) {
    if (meant.empty()) return std::nullopt;
    if (meant.size() == 1) return meant.front();
    const auto told = resolver_->assignment(text.variable, text.value);
    report_several(*plant_, *told, meant, text.variable.span, diagnostics_);
    return std::nullopt;
  }

  std::optional<Assignment> reading_of(const grammar::AssignmentText& text) {
    if (!resolver_) return std::nullopt;
    const auto reading = resolver_->assignment(text.variable, text.value);
    if (!reading || observables_.count(reading->variable) != 0) return reading;
    std::vector<std::string> names;
    for (const VariableId id : plant_->plant.observables) names.push_back(plant_->plant.variables.name(id));
    const bool mode = components_.count(reading->variable) != 0;
    auto& error =
        diagnostics_.error(Code::scenario_not_observable, text.variable.span,
                           backquoted(text.variable.text) +
                               (mode ? " is a component, and no sensor reads its mode" : " is not observable") +
                               (names.empty() ? "" : ", expected " + one_of(names)));
    if (!mode) error.suggestion = "declare it in the plant: `observe " + text.variable.text + ";`";
    return std::nullopt;
  }

  std::optional<Assignment> command_of(const grammar::AssignmentText& text) {
    if (!resolver_) return std::nullopt;
    const auto command = resolver_->assignment(text.variable, text.value);
    if (!command || controls_.count(command->variable) != 0) return command;
    report_no_control(command->variable, text.variable.span);
    return std::nullopt;
  }

  void report_no_control(VariableId id, grammar::Span span) {
    auto& error = diagnostics_.error(Code::scenario_not_a_command, span,
                                     backquoted(plant_->plant.variables.name(id)) +
                                         " is no control variable of plant " + backquoted(plant_->plant.name));
    note_domain(error, id);
  }

  /// A command is judged by control variables, an estimate by modes.
  void check_trigger(const Formula& trigger, bool command, const grammar::Constraint& text) {
    for (const VariableId id : automata::variables_of(trigger)) {
      if (command ? controls_.count(id) != 0 : components_.count(id) != 0) continue;
      const std::string& name = plant_->plant.variables.name(id);
      if (command) {
        report_no_control(id, mention_of(name, text));
        continue;
      }
      auto& error =
          diagnostics_.error(Code::scenario_not_a_mode, mention_of(name, text),
                             backquoted(name) + " is no component of plant " + backquoted(plant_->plant.name));
      note_domain(error, id);
    }
  }

  void note_domain(grammar::Diagnostic& error, VariableId id) {
    if (id.index() < plant_->declared.size())
      error.notes.push_back({plant_->declared[id.index()], "its domain is here"});
  }

  const grammar::Sources& sources_;
  const Part* plant_;
  grammar::Diagnostics& diagnostics_;
  std::optional<PlantResolver> resolver_;
  automata::Scenario scenario_;
  std::unordered_map<VariableId, automata::ComponentId> components_;  ///< by mode variable
  std::unordered_set<VariableId> observables_;
  std::unordered_set<VariableId> controls_;
  std::unordered_map<VariableId, grammar::Span> truths_;  ///< initial modes that are given, and where
  TagPlaces tagged_;                                      ///< requirements of the scenario as a whole
  std::map<std::pair<std::string, Ticks>, grammar::Span> sampled_;
};

}  // namespace

ScenarioFiles files_of(const grammar::ScenarioDefinition& definition, grammar::Diagnostics& diagnostics) {
  ScenarioFiles files;
  const auto take = [&](const auto& part, auto& place, const char* what) {
    if (place == nullptr) {
      place = &part;
      return;
    }
    auto& error = diagnostics.error(Code::scenario_repeated_part, part.span, std::string("a second ") + what);
    error.notes.push_back({place->span, "the first is here"});
  };
  for (const grammar::ScenarioItem& item : definition.items) {
    if (const auto* program = std::get_if<grammar::ProgramPart>(&item)) take(*program, files.program, "program");
    if (const auto* plant = std::get_if<grammar::PlantPart>(&item)) take(*plant, files.plant, "plant");
  }
  const auto require = [&](const void* part, const std::string& what, const std::string& fix) {
    if (part != nullptr) return;
    auto& error = diagnostics.error(Code::scenario_missing_part, definition.name.span,
                                    "scenario \"" + definition.name.text + "\" names no " + what);
    error.suggestion = "add " + fix;
  };
  require(files.program, "program", "`program \"….rmpl\";`");
  require(files.plant, "plant", "`plant \"….tcca\";`");
  return files;
}

automata::Scenario lower_scenario(const grammar::Sources& sources, const grammar::ScenarioDefinition& definition,
                                  const Part* plant, grammar::Diagnostics& diagnostics) {
  return ScenarioLowering(sources, plant, diagnostics).run(definition);
}

}  // namespace rmpl::compiler
