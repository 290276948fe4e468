// How findings about plants are told: once a type, with the instances that they are about.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compiler/lint/lint.hpp"
#include "compiler/lint/plant/declarations.hpp"
#include "compiler/lint/plant/findings.hpp"
#include "compiler/lint/removal.hpp"

namespace rmpl::compiler {

/// What is told about a plant, and what it is told with.
class PlantReport {
 public:
  PlantReport(const LintInput& input, const automata::Plant& plant, grammar::Diagnostics& found);

  [[nodiscard]] const LintInput& input() const { return input_; }
  [[nodiscard]] const automata::Plant& plant() const { return plant_; }
  [[nodiscard]] PlantAnalysis& analysis() { return analysis_; }
  [[nodiscard]] const PlantDeclarations& declarations() const { return declarations_; }
  /// The attributes that are inputs which nothing drives.
  [[nodiscard]] const std::set<automata::VariableId>& undriven() const { return undriven_; }

  grammar::Diagnostic& add(grammar::Code code, grammar::Span span, std::string message) {
    return add_finding(found_, code, span, std::move(message));
  }
  /// A finding that was told already, with more to it: it takes the place of what was told.
  void add(grammar::Diagnostic finding) { found_.add(std::move(finding)); }
  /// What the compiler and other passes have told.
  [[nodiscard]] const std::vector<grammar::Diagnostic>& told() const { return found_.all(); }
  [[nodiscard]] Removals& removals() { return removals_; }
  /// Whether a place is in the file that holds the plant: what other files hold, other plants may use in other ways.
  [[nodiscard]] bool is_beside_plant(grammar::Span place) const { return place.file == declarations_.plant.file; }
  [[nodiscard]] grammar::Span at(const automata::Origin& origin) const { return input_.places.at(origin); }
  [[nodiscard]] grammar::Span at(PlantMode mode) const;
  [[nodiscard]] grammar::Span at(PlantTransition transition) const;
  [[nodiscard]] const automata::Transition& operator[](PlantTransition transition) const {
    return plant_[transition.component].transitions[transition.transition.index()];
  }

  /// `Valve` where these are all instances of their type, else the instances by name; in backquotes.
  [[nodiscard]] std::string name(const std::vector<automata::ComponentId>& instances) const;
  /// Whether these are all instances of their type.
  [[nodiscard]] bool all(const std::vector<automata::ComponentId>& instances) const;
  [[nodiscard]] std::string mode(PlantMode mode) const;
  /// `valve.cmd = open`, in backquotes, several with commas; the first few, and what they have more.
  [[nodiscard]] std::string list(const std::vector<automata::Assignment>& assignments) const;
  /// Notes for what contradicts.
  void blame(grammar::Diagnostic& finding, const Contradiction& contradiction) const;

 private:
  const LintInput& input_;
  const automata::Plant& plant_;
  grammar::Diagnostics& found_;
  PlantAnalysis analysis_;
  PlantDeclarations declarations_;
  std::set<automata::VariableId> undriven_;
  Removals removals_;
};

/// The inputs that nothing drives: only other inputs are joined with them, none of which is commanded or observed.
std::set<automata::VariableId> undriven_inputs(const automata::Plant& plant, const PlantDeclarations& declarations);

/// `a`, `b` and 3 more, of names that are quoted already.
std::string enumerated(const std::vector<std::string>& names, std::size_t limit);

// A function a file; each tells of its findings.
void report_modes(PlantReport& report);
void report_guards(PlantReport& report);
void report_duplicates(PlantReport& report);
void report_timed_faults(PlantReport& report);
void report_commands(PlantReport& report);
void report_sensing(PlantReport& report);
void report_attributes(PlantReport& report);
void report_stuck(PlantReport& report);
void report_timers(PlantReport& report);
void report_readings(PlantReport& report);
void report_blocked_goals(PlantReport& report);
/// Of a plant without an initial state; of what it reaches nothing is told.
void report_initial_state(PlantReport& report);
/// Of a plant without any possible state; nothing else is told of it.
void report_impossible_plant(PlantReport& report);

}  // namespace rmpl::compiler
