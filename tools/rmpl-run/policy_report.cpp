// Policy tables as text and as JSON.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/policy_report.hpp"

#include <algorithm>
#include <iterator>

#include "automata/dependencies/plant_index.hpp"
#include "base/product.hpp"
#include "runtime/reasoning/reconfigure/policy.hpp"

namespace rmpl::tools {

using automata::ComponentId;
using automata::Plant;
using runtime::JsonLine;
using runtime::NominalGraph;
using runtime::PolicyEntry;
using runtime::PolicyTable;
using runtime::Precondition;
using runtime::Requirement;

namespace {

std::string text_of(const Plant& plant, const Precondition& precondition) {
  std::string text;
  for (const Requirement& r : precondition) {
    text += (text.empty() ? "" : ", ") + to_text(member(r.variable, r.values), plant.variables);
  }
  return text;
}

/// Whether one of these requirements on modes is met whatever the modes are, while nothing has failed. Where that would
/// have to be asked of very many, they count as requirements.
bool always_met(const Plant& plant, const automata::PlantIndex& index, const std::vector<Precondition>& supports) {
  std::vector<automata::VariableId> modes;
  std::vector<std::vector<automata::ValueId>> domains;
  for (const Precondition& support : supports) {
    for (const Requirement& r : support) {
      if (std::find(modes.begin(), modes.end(), r.variable) != modes.end()) continue;
      modes.push_back(r.variable);
      auto& domain = domains.emplace_back();
      const automata::Component& component = plant[*index.component_of(r.variable)];
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        if (!component.modes[m].fault) domain.emplace_back(m);
      }
    }
  }
  constexpr std::size_t most = 1u << 16;
  std::size_t count = 1;
  for (const auto& domain : domains) {
    count *= domain.size();
    if (count > most) return false;
  }
  bool all = true;
  base::for_each_combination(domains, [&](const std::vector<automata::ValueId>& values) {
    const auto is_met = [&](const Requirement& r) {
      const auto at = std::find(modes.begin(), modes.end(), r.variable) - modes.begin();
      return std::binary_search(r.values.begin(), r.values.end(), values[static_cast<std::size_t>(at)]);
    };
    all = all && std::any_of(supports.begin(), supports.end(), [&](const Precondition& support) {
            return std::all_of(support.begin(), support.end(), is_met);
          });
  });
  return all;
}

/// What is to be achieved: of a wait modes alone, and nothing where every state has those of one of the preconditions.
std::vector<Precondition> supports_of(const Plant& plant, const automata::PlantIndex& index, const PolicyEntry& entry) {
  if (entry.kind == PolicyEntry::Kind::command) return entry.preconditions;
  std::vector<Precondition> supports;
  if (entry.kind != PolicyEntry::Kind::wait) return supports;
  for (const Precondition& precondition : entry.preconditions) {
    Precondition& modes = supports.emplace_back();
    std::copy_if(precondition.begin(), precondition.end(), std::back_inserter(modes),
                 [&](const Requirement& r) { return index.component_of(r.variable).has_value(); });
  }
  return always_met(plant, index, supports) ? std::vector<Precondition>{} : supports;
}

std::string text_of(const Plant& plant, const automata::PlantIndex& index, const PolicyEntry& entry) {
  if (entry.kind == PolicyEntry::Kind::arrived) return "idle";
  if (entry.kind == PolicyEntry::Kind::failure) return "failure";
  const std::vector<Precondition> supports = supports_of(plant, index, entry);
  const bool wait = entry.kind == PolicyEntry::Kind::wait;
  if (supports.empty()) return "idle";
  std::string text = (wait ? "idle while " : "") + text_of(plant, supports.front());
  if (supports.size() > 1) text += " (or " + std::to_string(supports.size() - 1) + " more)";
  if (entry.irreversible) text += " (irreversible)";
  return text;
}

std::string_view name_of(PolicyEntry::Kind kind) {
  switch (kind) {
    case PolicyEntry::Kind::arrived:
      return "arrived";
    case PolicyEntry::Kind::wait:
      return "wait";
    case PolicyEntry::Kind::command:
      return "command";
    case PolicyEntry::Kind::failure:
      return "failure";
  }
  return {};
}

}  // namespace

std::string policy_text(const Plant& plant, const NominalGraph& graph, const std::vector<ComponentId>& components) {
  const automata::PlantIndex index(plant);
  std::string text;
  for (const ComponentId c : components) {
    const auto& modes = plant[c].modes;
    const PolicyTable table = policy_table(plant, graph, c);
    std::size_t width = 0;
    for (const auto& mode : modes) width = std::max(width, mode.name.size());
    text += (text.empty() ? "" : "\n") + plant[c].name + "\n";
    for (std::size_t from = 0; from < modes.size(); ++from) {
      for (std::size_t to = 0; to < modes.size(); ++to) {
        const std::string current = to == 0 ? modes[from].name : "";
        text += "  " + current + std::string(width - current.size(), ' ') + "  -> " + modes[to].name +
                std::string(width - modes[to].name.size(), ' ') + "  " +
                text_of(plant, index, table.entries[from][to]) + "\n";
      }
    }
  }
  return text;
}

void write_policies(JsonLine& json, const Plant& plant, const NominalGraph& graph,
                    const std::vector<ComponentId>& components) {
  const automata::PlantIndex index(plant);
  json.open('{').key("policies").open('[');
  for (const ComponentId c : components) {
    const auto& modes = plant[c].modes;
    const PolicyTable table = policy_table(plant, graph, c);
    json.open('{').key("component").string(plant[c].name).key("entries").open('[');
    for (std::size_t from = 0; from < modes.size(); ++from) {
      for (std::size_t to = 0; to < modes.size(); ++to) {
        const PolicyEntry& entry = table.entries[from][to];
        json.open('{').key("current").string(modes[from].name).key("target").string(modes[to].name);
        json.key("action").string(name_of(entry.kind));
        if (entry.irreversible) json.key("irreversible").digits("true");
        if (const std::vector<Precondition> supports = supports_of(plant, index, entry); !supports.empty()) {
          json.key("supports").open('[');
          for (const Precondition& precondition : supports) {
            json.open('{');
            for (const Requirement& r : precondition) {
              json.key(plant.variables.name(r.variable)).open('[');
              for (const automata::ValueId v : r.values) json.string(plant.variables[r.variable].values[v.index()]);
              json.close(']');
            }
            json.close('}');
          }
          json.close(']');
        }
        json.close('}');
      }
    }
    json.close(']').close('}');
  }
  json.close(']').close('}');
}

}  // namespace rmpl::tools
