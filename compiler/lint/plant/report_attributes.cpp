// Told: inputs that nothing drives, and attributes that nothing mentions.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "automata/plant.hpp"
#include "base/partition.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::Plant;
using automata::VariableId;
using grammar::Code;
using grammar::Direction;

std::set<VariableId> undriven_inputs(const Plant& plant, const PlantDeclarations& declarations) {
  std::vector<bool> input(plant.variables.size());
  for (const PlantAttribute& attribute : declarations.attributes) {
    const auto variable = plant.variables.find(attribute.name);
    if (variable && attribute.direction == Direction::input) input[variable->index()] = true;
  }
  base::Partition joined(plant.variables.size());
  std::vector<VariableId> drivers = plant.observables;
  for (const automata::Control& control : plant.controls) drivers.push_back(control.variable);
  for (const automata::Interconnection& q : plant.interconnections) {
    const std::vector<VariableId> variables = variables_of(q.constraint);
    for (const VariableId v : variables) joined.join(v.index(), variables.front().index());
    if (q.constraint.kind != Formula::Kind::equality) drivers.insert(drivers.end(), variables.begin(), variables.end());
  }
  std::vector<bool> driven(plant.variables.size());
  for (const VariableId v : drivers) driven[joined.root(v.index())] = true;
  for (std::size_t v = 0; v < input.size(); ++v) {
    if (!input[v]) driven[joined.root(v)] = true;
  }
  std::set<VariableId> result;
  for (std::size_t v = 0; v < input.size(); ++v) {
    if (input[v] && !driven[joined.root(v)]) result.insert(VariableId(v));
  }
  return result;
}

namespace {

/// Instances of one attribute, as it is declared.
struct Declared {
  const PlantAttribute* attribute;
  std::vector<const PlantAttribute*> undriven;
  std::size_t instances = 0;
  bool read = false;       ///< by the component itself, in some instance
  bool mentioned = false;  ///< by anything, in some instance
  bool observed = false;
};

std::vector<Declared> by_declaration(PlantReport& report, const std::set<VariableId>& own,
                                     const std::set<VariableId>& others) {
  std::map<grammar::Span, Declared> result;
  for (const PlantAttribute& attribute : report.declarations().attributes) {
    const auto variable = report.plant().variables.find(attribute.name);
    if (!variable) continue;
    Declared& declared = result.try_emplace(attribute.span, Declared{&attribute, {}}).first->second;
    ++declared.instances;
    declared.read = declared.read || own.contains(*variable);
    declared.mentioned = declared.mentioned || own.contains(*variable) || others.contains(*variable);
    declared.observed = declared.observed || report.analysis().observed(*variable);
    if (report.undriven().contains(*variable)) declared.undriven.push_back(&attribute);
  }
  std::vector<Declared> list;
  for (auto& [span, declared] : result) list.push_back(std::move(declared));
  return list;
}

/// The inputs of modules that undriven inputs of components are joined with.
class OpenPorts {
 public:
  explicit OpenPorts(const PlantReport& report) : plant_(report.plant()), joined_(plant_.variables.size()) {
    for (const automata::Interconnection& q : plant_.interconnections) {
      if (q.constraint.kind == Formula::Kind::equality)
        joined_.join(q.constraint.variable.index(), q.constraint.other.index());
    }
    for (const PlantAttribute& attribute : report.declarations().attributes) {
      const auto variable = plant_.variables.find(attribute.name);
      if (!variable || attribute.of_component || !report.undriven().contains(*variable)) continue;
      const PlantAttribute*& port = ports_.try_emplace(joined_.root(variable->index()), &attribute).first->second;
      if (depth(attribute) < depth(*port)) port = &attribute;
    }
  }
  /// The outermost one, the first of several: that is what can be connected. Null where there is none.
  const PlantAttribute* of(const PlantAttribute& attribute) {
    const auto port = ports_.find(joined_.root(plant_.variables.find(attribute.name)->index()));
    return port == ports_.end() ? nullptr : port->second;
  }

 private:
  static std::ptrdiff_t depth(const PlantAttribute& attribute) {
    return std::count(attribute.name.begin(), attribute.name.end(), '.');
  }

  const Plant& plant_;
  base::Partition joined_;
  std::map<std::size_t, const PlantAttribute*> ports_;  ///< by the root of what is joined
};

/// What guards and mode constraints read, and what the rest reads.
std::pair<std::set<VariableId>, std::set<VariableId>> mentions(const Plant& plant) {
  std::set<VariableId> own, others(plant.observables.begin(), plant.observables.end());
  const auto add = [](const Formula& formula, std::set<VariableId>& to) {
    for (const VariableId v : variables_of(formula)) to.insert(v);
  };
  for (const automata::Component& component : plant.components) {
    for (const automata::Mode& mode : component.modes) add(mode.constraint, own);
    for (const automata::Transition& transition : component.transitions) add(transition.guard, own);
  }
  for (const automata::Interconnection& q : plant.interconnections) add(q.constraint, others);
  for (const automata::Control& control : plant.controls) others.insert(control.variable);
  return {own, others};
}

void report_unused(PlantReport& report, const Declared& declared) {
  const PlantAttribute& attribute = *declared.attribute;
  const std::string what = backquoted(attribute.attribute) + " of " + backquoted(attribute.type);
  if (!declared.mentioned) {
    auto& finding = report.add(Code::unused_attribute, attribute.span, "nothing mentions the attribute " + what);
    const bool here = report.is_beside_plant(attribute.span) && report.input().names.of(attribute.span).size() == 1;
    if (here) propose(finding, report.removals().of_name(attribute.span));
  } else if (attribute.of_component && attribute.direction == Direction::input && !declared.read &&
             !declared.observed) {
    report.add(Code::unused_attribute, attribute.span, "no guard and no mode constraint reads the input " + what);
  }
}

/// Inputs of one declaration that nothing drives, with the inputs within that they lead to.
void report_undriven(PlantReport& report, const Declared& declared, const std::vector<const PlantAttribute*>& undriven,
                     const std::set<grammar::Span>& inside) {
  const PlantAttribute& attribute = *declared.attribute;
  std::vector<std::string> names;
  for (const PlantAttribute* one : undriven) names.push_back(backquoted(one->name));
  auto& finding = report.add(
      Code::unconnected_input, attribute.span,
      undriven.size() == declared.instances
          ? "the input " + backquoted(attribute.attribute) + " of " + backquoted(attribute.type) +
                " is neither connected nor commanded"
          : enumerated(names, 3) + (names.size() == 1 ? " is" : " are") + " neither connected nor commanded");
  for (const grammar::Span& within : inside) finding.notes.push_back({within, "it leads to this input"});
  finding.suggestion = "connect " + (names.size() == 1 ? names.front() + ", or declare it" : "them, or declare them") +
                       " with `control`";
}

void report_undriven(PlantReport& report, const std::vector<Declared>& all) {
  OpenPorts ports(report);
  std::map<const PlantAttribute*, std::set<grammar::Span>> inside;  // by port, the inputs of components that read it
  for (const Declared& declared : all) {
    if (!declared.attribute->of_component || !declared.read) continue;
    std::vector<const PlantAttribute*> own;
    for (const PlantAttribute* one : declared.undriven) {
      const PlantAttribute* const port = ports.of(*one);
      if (port == nullptr) own.push_back(one);
      if (port != nullptr) inside[port].insert(one->span);
    }
    if (!own.empty()) report_undriven(report, declared, own, {});
  }
  for (const Declared& declared : all) {
    std::vector<const PlantAttribute*> own;
    std::set<grammar::Span> within;
    for (const PlantAttribute* one : declared.undriven) {
      const auto known = inside.find(one);
      if (known == inside.end()) continue;
      own.push_back(one);
      within.insert(known->second.begin(), known->second.end());
    }
    if (!own.empty()) report_undriven(report, declared, own, within);
  }
}

}  // namespace

void report_attributes(PlantReport& report) {
  const auto [own, others] = mentions(report.plant());
  const std::vector<Declared> all = by_declaration(report, own, others);
  for (const Declared& declared : all) report_unused(report, declared);
  report_undriven(report, all);
}

}  // namespace rmpl::compiler
