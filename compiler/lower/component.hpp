// From a component type as written to a timed constraint automaton (thesis 6.1.2), with every check on the way.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/domains.hpp"
#include "compiler/check/resolve.hpp"
#include "compiler/lower/part.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// Lowers one component type. What is wrong is reported and left out.
class ComponentLowering {
 public:
  ComponentLowering(const grammar::Sources& sources, Domains& domains, grammar::Diagnostics& diagnostics)
      : sources_(sources), domains_(domains), diagnostics_(diagnostics) {}

  Part run(const grammar::ComponentDefinition& definition);

 private:
  void declare_modes(const grammar::ComponentDefinition& definition);
  void declare_attributes(const grammar::ComponentDefinition& definition);
  void constrain_modes(const grammar::ComponentDefinition& definition);
  void set_initial(const grammar::ComponentDefinition& definition);
  void add_transitions(const grammar::TransitionText& text, Resolver& resolver);
  /// Whether it leads to a mode that is no fault: faults are drawn, whatever the density.
  [[nodiscard]] bool has_nominal_target(const grammar::TransitionText& text);
  void add_transition(const grammar::TransitionText& text, const grammar::Branch& branch, automata::Weight weight,
                      automata::Transition common);
  /// Whether the text may say `restart`; else an error.
  bool may_restart(const grammar::TransitionText& text, const grammar::Branch& branch, automata::ModeId target,
                   const std::vector<automata::ModeId>& sources);
  void repair_with_rate(const grammar::TransitionText& text, const grammar::Branch& branch, automata::ModeId target,
                        const std::vector<automata::ModeId>& sources, automata::Transition& common);
  /// Warns where the transition stands there already: same ends, guard and bounds. Looks at the first few of the same
  /// ends only, so that a large model does not cost its square.
  void report_twin(const automata::Transition& transition, grammar::Span span);
  std::vector<automata::ModeId> sources_of(const grammar::TransitionText& text, automata::ModeId target);
  std::optional<automata::ModeId> mode(const grammar::Name& name);

  [[nodiscard]] automata::Component& component() { return part_.plant.components.front(); }

  const grammar::Sources& sources_;
  Domains& domains_;
  grammar::Diagnostics& diagnostics_;
  Part part_;
  std::map<std::string, automata::ModeId, std::less<>> modes_;
  std::vector<grammar::Span> mode_names_;        ///< per mode, where it is declared
  std::vector<grammar::Span> transition_spans_;  ///< per transition, for the check of sums
  std::map<std::pair<automata::ModeId, automata::ModeId>, std::vector<std::size_t>> by_ends_;  ///< transitions
  std::set<std::pair<grammar::Span, grammar::Span>> twins_;  ///< transitions that are given twice, and reported
  std::uint32_t branches_ = 0;
};

}  // namespace rmpl::compiler
