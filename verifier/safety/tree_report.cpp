// Fault trees for people and for other tools.
// SPDX-License-Identifier: MIT
#include "verifier/safety/tree_report.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <set>

#include "base/xml_text.hpp"
#include "verifier/markov/report.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {

using automata::Plant;
using nlohmann::ordered_json;

namespace {

std::string count_text(Real count) {
  char text[64];
  std::snprintf(text, sizeof text, "%.0Lf", count);
  return text;
}

std::string text_of(const Plant& plant, const Fault& fault) {
  const automata::Component& component = plant[fault.component];
  return component.name + " = " + component.modes[fault.mode.index()].name;
}

Real count_of(const FaultTree& tree) {
  Real all = 0;
  for (const Real count : tree.by_order) all += count;
  return all;
}

ordered_json json_of(const Enclosure& value) {
  const auto [lower, upper] = as_doubles(value);
  return {{"lower", lower}, {"upper", upper}};
}

ordered_json faults_json(const Plant& plant, const FaultTree& tree, const TreeSet& set) {
  ordered_json result = ordered_json::object();
  for (const std::size_t e : set.events) {
    const Fault& fault = tree.events[e].fault;
    result[plant[fault.component].name] = plant[fault.component].modes[fault.mode.index()].name;
  }
  return result;
}

/// Names that the format allows: of letters, digits, underscores and single hyphens; those of the plant where they are.
std::vector<std::string> names_of(const Plant& plant, const FaultTree& tree) {
  std::set<std::string> taken{"top"};
  std::vector<std::string> result;
  for (const TreeEvent& event : tree.events) {
    const automata::Component& component = plant[event.fault.component];
    const auto faults = std::count_if(component.modes.begin(), component.modes.end(),
                                      [](const automata::Mode& mode) { return mode.fault; });
    std::string name = component.name;
    if (faults > 1) name += "_" + component.modes[event.fault.mode.index()].name;
    for (char& c : name) {
      if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
    }
    while (!taken.insert(name).second) name += "_";
    result.push_back(std::move(name));
  }
  return result;
}

}  // namespace

std::string to_text(const Plant& plant, const FaultTreeQuestion& question, const FaultTree& tree,
                    const std::string& asked) {
  std::string text = "fault tree of " + asked + " on " + plant.name + "\n";
  if (tree.exact) {
    text += count_text(count_of(tree)) + " minimal cut sets";
  } else {
    text += std::string(tree.limit ? "at least " : "") + count_text(count_of(tree)) + " minimal cut sets of up to " +
            std::to_string(question.order) + " faults";
  }
  std::string orders;
  for (std::size_t order = 0; order < tree.by_order.size(); ++order) {
    if (tree.by_order[order] == 0) continue;
    orders += (orders.empty() ? "" : ", ") + count_text(tree.by_order[order]) + " of " + std::to_string(order);
  }
  text += (orders.empty() ? "" : ": " + orders) + "\n";
  if (!tree.monotone) text += "the formula is not monotone: repairs or failures elsewhere can make it true\n";
  if (tree.top) {
    text += "probability within " + automata::format_seconds(*question.within) + " s: " + number_text(*tree.top) + "\n";
  }
  for (const TreeSet& set : tree.sets) {
    std::string faults;
    for (const std::size_t e : set.events)
      faults += (faults.empty() ? "" : ", ") + text_of(plant, tree.events[e].fault);
    text += "  { " + faults + " }" + (set.probability ? "  " + number_text(*set.probability) : "") + "\n";
  }
  if (static_cast<Real>(tree.sets.size()) < count_of(tree)) {
    text += "  … and " + count_text(count_of(tree) - static_cast<Real>(tree.sets.size())) + " more\n";
  }
  std::string table;
  for (const TreeEvent& event : tree.events) {
    if (!event.importance) continue;
    const auto& [birnbaum, fussell_vesely, achievement, reduction] = *event.importance;
    table += "  " + text_of(plant, event.fault) + ": probability " + number_text(*event.probability) + ", Birnbaum " +
             number_text(birnbaum) + ", Fussell-Vesely " + number_text(fussell_vesely) + ", achievement worth " +
             number_text(achievement) + ", reduction worth " + (reduction ? number_text(*reduction) : "infinite") +
             "\n";
  }
  if (!table.empty()) text += "importance\n" + table;
  if (tree.limit) text += "undecided: " + reason(tree.limit, tree.progress) + "\n";
  return text;
}

ordered_json to_json(const Plant& plant, const FaultTreeQuestion& question, const FaultTree& tree,
                     const std::string& asked) {
  ordered_json json = {{"property", "fault-tree"}, {"top", asked}, {"exact", tree.exact}, {"monotone", tree.monotone}};
  if (!tree.exact) json["faults_at_most"] = question.order;
  if (tree.limit) {
    json["verdict"] = "undecided";
    json["reason"] = reason(tree.limit, tree.progress);
  }
  json["count"] = static_cast<double>(count_of(tree));
  ordered_json& orders = json["by_order"] = ordered_json::object();
  for (std::size_t order = 0; order < tree.by_order.size(); ++order) {
    if (tree.by_order[order] > 0) orders[std::to_string(order)] = static_cast<double>(tree.by_order[order]);
  }
  json["within"] = question.within ? ordered_json(question.within->seconds()) : ordered_json(nullptr);
  if (tree.top) json["probability"] = json_of(*tree.top);
  ordered_json& sets = json["cut_sets"] = ordered_json::array();
  for (const TreeSet& set : tree.sets) {
    ordered_json one = {{"faults", faults_json(plant, tree, set)}};
    if (set.probability) one["probability"] = json_of(*set.probability);
    sets.push_back(std::move(one));
  }
  ordered_json& events = json["events"] = ordered_json::array();
  for (const TreeEvent& event : tree.events) {
    ordered_json one = {{"component", plant[event.fault.component].name},
                        {"mode", plant[event.fault.component].modes[event.fault.mode.index()].name}};
    if (event.probability) one["probability"] = json_of(*event.probability);
    if (event.importance) {
      one["birnbaum"] = event.importance->birnbaum;
      one["fussell_vesely"] = event.importance->fussell_vesely;
      one["risk_achievement_worth"] = event.importance->achievement;
      one["risk_reduction_worth"] =
          event.importance->reduction ? ordered_json(*event.importance->reduction) : ordered_json(nullptr);
    }
    events.push_back(std::move(one));
  }
  json["statistics"] = statistics_of(tree.progress);
  return json;
}

std::string to_open_psa(const Plant& plant, const FaultTreeQuestion& question, const FaultTree& tree) {
  const std::vector<std::string> names = names_of(plant, tree);
  constexpr double seconds_per_hour = 3600;
  const auto exact = [](double value) { return ordered_json(value).dump(); };
  std::string text =
      "<?xml version=\"1.0\"?>\n<opsa-mef>\n<define-fault-tree name=\"FaultTree\">\n<define-gate name=\"top\">\n";
  // A gate of one input is that input; of none it is a constant.
  const auto event = [&](std::size_t e) { return "<basic-event name=\"" + names[e] + "\"/>"; };
  std::string sets;
  for (const TreeSet& set : tree.sets) {
    std::string all;
    for (const std::size_t e : set.events) all += event(e);
    sets += set.events.empty() ? "<constant value=\"true\"/>" : set.events.size() == 1 ? all : "<and>" + all + "</and>";
    sets += "\n";
  }
  if (tree.sets.empty()) sets = "<constant value=\"false\"/>\n";
  text += tree.sets.size() > 1 ? "<or>\n" + sets + "</or>\n" : sets;
  text += "</define-gate>\n</define-fault-tree>\n<model-data>\n";
  for (std::size_t e = 0; e < tree.events.size(); ++e) {
    const TreeEvent& own = tree.events[e];
    text += "<define-basic-event name=\"" + names[e] + "\"><label>" + base::xml_text(text_of(plant, own.fault)) +
            "</label>";
    if (own.weight.kind == automata::Weight::Kind::rate) {
      text += "<exponential><float value=\"" + exact(own.weight.value * seconds_per_hour) +
              "\"/><system-mission-time unit=\"hours\"/></exponential>";
    } else if (own.once) {
      text += "<float value=\"" + exact(own.weight.value) + "\"/>";
    } else if (own.probability && question.within) {
      text += "<float value=\"" + exact(as_doubles(*own.probability).upper) + "\"/>";
    }
    text += "</define-basic-event>\n";
  }
  return text + "</model-data>\n</opsa-mef>\n";
}

std::string to_dot(const Plant& plant, const FaultTree& tree, const std::string& asked) {
  /// A label in quotes, with a probability in a line of its own.
  const auto label = [](std::string text, const std::optional<Enclosure>& probability) {
    if (probability) text.append("\n").append(number_text(*probability));
    return ordered_json(text).dump();
  };
  std::string text =
      "digraph fault_tree {\n  node [fontname=\"Liberation Sans\", fontsize=11];\n  top [shape=box, label=" +
      label(asked, tree.top) + "];\n";
  std::set<std::size_t> drawn;
  for (std::size_t s = 0; s < tree.sets.size(); ++s) {
    const TreeSet& set = tree.sets[s];
    std::string parent = "top";
    if (set.events.size() != 1) {
      parent = "set" + std::to_string(s);
      text.append("  ").append(parent).append(" [shape=house, label=").append(label("all of", set.probability));
      text.append("];\n  top -> ").append(parent).append(";\n");
    }
    for (const std::size_t e : set.events) {
      const TreeEvent& event = tree.events[e];
      if (drawn.insert(e).second) {
        text += "  event" + std::to_string(e) +
                " [shape=circle, label=" + label(text_of(plant, event.fault), event.probability) + "];\n";
      }
      text += "  " + parent + " -> event" + std::to_string(e) + ";\n";
    }
  }
  return text + "}\n";
}

}  // namespace rmpl::verifier
