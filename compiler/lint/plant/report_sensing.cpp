// Told: modes that no observation tells apart.
// SPDX-License-Identifier: MIT
#include "base/partition.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::ComponentId;
using automata::ModeId;
using automata::VariableId;
using grammar::Code;

namespace {

/// Modes of a component that are all alike, and attributes that would tell some of them apart.
struct Alike {
  std::vector<ModeId> modes;
  std::set<VariableId> would_tell;
};

std::vector<Alike> classes(const automata::Component& component, const std::vector<AlikeModes>& pairs) {
  base::Partition partition(component.modes.size());
  for (const AlikeModes& pair : pairs) partition.join(pair.first.index(), pair.second.index());
  std::map<std::size_t, Alike> result;
  for (const AlikeModes& pair : pairs) {
    result[partition.root(pair.first.index())].would_tell.insert(pair.would_tell.begin(), pair.would_tell.end());
  }
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (const auto at = result.find(partition.root(m)); at != result.end()) at->second.modes.emplace_back(m);
  }
  std::vector<Alike> list;
  for (auto& [root, alike] : result) list.push_back(std::move(alike));
  return list;
}

void report_alike(PlantReport& report, const std::vector<AlikeModes>& found, Code code, const std::string& kind) {
  std::map<ComponentId, std::vector<AlikeModes>> by_component;
  for (const AlikeModes& pair : found) by_component[pair.component].push_back(pair);
  std::map<std::pair<std::string, std::vector<ModeId>>, std::pair<Alike, std::vector<ComponentId>>> by_type;
  for (const auto& [component, pairs] : by_component) {
    for (Alike& alike : classes(report.plant()[component], pairs)) {
      const std::vector<ModeId> modes = alike.modes;
      auto& entry = by_type[{report.plant()[component].type, modes}];
      if (entry.second.empty()) entry.first = std::move(alike);
      entry.second.push_back(component);
    }
  }
  for (const auto& [key, entry] : by_type) {
    const auto& [alike, instances] = entry;
    std::vector<std::string> names, attributes;
    for (const ModeId mode : alike.modes) names.push_back(report.mode({instances.front(), mode}));
    for (const VariableId v : alike.would_tell) attributes.push_back(backquoted(report.plant().variables.name(v)));
    const PlantMode first{instances.front(), alike.modes.front()};
    auto& finding = report.add(
        code, report.at(first),
        "no observation tells the " + kind + " " + enumerated(names, 6) + " of " + report.name(instances) + " apart");
    if (!attributes.empty()) finding.suggestion = "observe " + enumerated(attributes, 3) + ", which differs";
  }
}

void report_undetectable(PlantReport& report, const std::vector<PlantMode>& found) {
  std::map<std::pair<std::string, ModeId>, std::vector<ComponentId>> by_type;
  for (const PlantMode& mode : found) {
    by_type[{report.plant()[mode.component].type, mode.mode}].push_back(mode.component);
  }
  for (const auto& [key, instances] : by_type) {
    const PlantMode first{instances.front(), key.second};
    report.add(Code::undetectable_fault, report.at(first),
               "no observation tells the fault " + report.mode(first) + " of " + report.name(instances) +
                   " from its nominal modes");
  }
}

/// Nothing tells anything from anything then: one note, instead of one a mode.
void report_unobserved(PlantReport& report) {
  for (std::size_t c = 0; c < report.plant().components.size(); ++c) {
    const automata::Component& component = report.plant().components[c];
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const PlantMode fault{ComponentId(c), ModeId(m)};
      if (!component.modes[m].fault || !report.analysis().reach().reached[c][m]) continue;
      auto& finding = report.add(Code::unobserved_plant, report.declarations().plant,
                                 "nothing of " + backquoted(report.plant().name) +
                                     " is observed: no fault can be noticed, and the estimate only follows the model");
      finding.notes.push_back({report.at(fault), "for example this one of " + report.name({ComponentId(c)})});
      return;
    }
  }
}

}  // namespace

void report_sensing(PlantReport& report) {
  if (report.plant().observables.empty()) return report_unobserved(report);
  Indistinguishable found = find_indistinguishable(report.analysis());
  report_undetectable(report, found.undetectable);
  // Faults that look nominal look alike, too: that is no more than was told.
  const std::set<PlantMode> undetectable(found.undetectable.begin(), found.undetectable.end());
  std::erase_if(found.faults, [&](const AlikeModes& pair) {
    return undetectable.contains({pair.component, pair.first}) && undetectable.contains({pair.component, pair.second});
  });
  report_alike(report, found.modes, Code::indistinguishable_modes, "modes");
  report_alike(report, found.faults, Code::indistinguishable_faults, "faults");
}

}  // namespace rmpl::compiler
