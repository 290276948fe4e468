// Policy tables as text and as JSON.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/policy_report.hpp"

#include <algorithm>

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

std::string text_of(const Plant& plant, const PolicyEntry& entry) {
  std::string text;
  switch (entry.kind) {
    case PolicyEntry::Kind::arrived:
    case PolicyEntry::Kind::wait:
      return "idle";
    case PolicyEntry::Kind::failure:
      return "failure";
    case PolicyEntry::Kind::command:
      text = text_of(plant, entry.preconditions.front());
      if (entry.preconditions.size() > 1) text += " (or " + std::to_string(entry.preconditions.size() - 1) + " more)";
      if (entry.irreversible) text += " (irreversible)";
      return text;
  }
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
                std::string(width - modes[to].name.size(), ' ') + "  " + text_of(plant, table.entries[from][to]) + "\n";
      }
    }
  }
  return text;
}

void write_policies(JsonLine& json, const Plant& plant, const NominalGraph& graph,
                    const std::vector<ComponentId>& components) {
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
        if (entry.kind == PolicyEntry::Kind::command) {
          json.key("supports").open('[');
          for (const Precondition& precondition : entry.preconditions) {
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
