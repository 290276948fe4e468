// Names are gathered key by key; what has no name in a trace is not there.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/named_model.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "automata/json/parse.hpp"
#include "base/error.hpp"

namespace rmpl::tools {
namespace {

using automata::Json;

constexpr const char* at_rest = "at rest";  ///< of a control of which nothing is commanded

const Json& member(const Json& object, const char* key) {
  static const Json none;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? *found : none;
}

std::string text_of(const Json& object, const char* key) {
  const Json& text = member(object, key);
  return text.is_string() ? text.get<std::string>() : std::string();
}

class Names {
 public:
  explicit Names(std::string name) {
    model_.plant.name = "trace";
    model_.program.name = std::move(name);
  }

  void take(const Json& line) {
    for (const char* key : {"estimate", "truth", "goal"}) modes(member(line, key));
    for (const Json& entry : member(line, "belief")) modes(member(entry, "modes"));
    for (const char* key : {"observations", "set_aside"}) {
      each(member(line, key), [this](const std::string& name, const std::string& value) { seen(name, value); });
    }
    each(member(line, "command"), [this](const std::string& name, const std::string& value) { sent(name, value); });
    for (const Json& location : member(line, "marking")) locate(location);
    for (const Json& by : member(line, "asserted_by")) locate(member(by, "location"));
    for (const Json& constraint : member(line, "goal_constraints")) locate(member(constraint, "location"));
    reason(member(line, "reason"));
    for (const Json& event : member(line, "events")) {
      for (const Json& location : member(event, "locations")) locate(location);
      if (const std::string component = text_of(event, "component"); !component.empty()) component_of(component);
    }
    for (const Json& evidence : member(line, "evidence")) take_evidence(evidence);
  }

  NamedModel finish() {
    for (automata::Component& component : model_.plant.components) {
      if (component.modes.empty()) mode_of(component, "unknown");
      component.initial.assign(component.modes.size(), 0);
      component.initial.front() = 1;
    }
    model_.program.locations.resize(locations_);
    for (std::size_t l = 0; l < locations_; ++l)
      model_.program.locations[l].label = "location " + std::to_string(l + 1);
    model_.program.variables = model_.plant.variables;
    return std::move(model_);
  }

 private:
  template <class Take>
  static void each(const Json& object, const Take& take) {
    if (!object.is_object()) return;
    for (const auto& [name, value] : object.items()) {
      if (value.is_string()) take(name, value.template get<std::string>());
    }
  }

  void modes(const Json& object) {
    each(object, [this](const std::string& name, const std::string& mode) { mode_of(component_of(name), mode); });
  }

  automata::Component& component_of(const std::string& name) {
    if (const auto known = model_.plant.find_component(name)) return model_.plant.components[known->index()];
    if (model_.plant.variables.find(name)) throw base::InputError(": '" + name + "' is a component and an attribute");
    automata::Component component;
    component.name = component.type = name;
    component.mode = model_.plant.variables.add({name, {}});
    return model_.plant.components.emplace_back(std::move(component));
  }

  automata::ModeId mode_of(automata::Component& component, const std::string& name) {
    const automata::ValueId value = model_.plant.variables.add_value(component.mode, name);
    if (value.index() == component.modes.size()) {
      automata::Mode mode;
      mode.name = name;
      component.modes.push_back(std::move(mode));
    }
    return automata::ModeId(value.index());
  }

  automata::VariableId attribute(const std::string& name) {
    const auto known = model_.plant.variables.find(name);
    if (known && model_.plant.component_of(*known))
      throw base::InputError(": '" + name + "' is a component and an attribute");
    return known ? *known : model_.plant.variables.add({name, {}});
  }

  void seen(const std::string& name, const std::string& value) {
    const automata::VariableId variable = attribute(name);
    model_.plant.variables.add_value(variable, value);
    auto& all = model_.plant.observables;
    if (std::find(all.begin(), all.end(), variable) == all.end()) all.push_back(variable);
  }

  void sent(const std::string& name, const std::string& value) {
    const automata::VariableId variable = attribute(name);
    auto& all = model_.plant.controls;
    if (std::none_of(all.begin(), all.end(), [&](const auto& control) { return control.variable == variable; })) {
      all.push_back({variable, model_.plant.variables.add_value(variable, at_rest)});
    }
    model_.plant.variables.add_value(variable, value);
  }

  void locate(const Json& number) {
    constexpr std::uint64_t most = 10'000'000;
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() > most) return;
    locations_ = std::max(locations_, number.get<std::size_t>());
  }

  void reason(const Json& reason) {
    if (const std::string name = text_of(reason, "component"); !name.empty()) {
      automata::Component& component = component_of(name);
      if (const std::string aim = text_of(reason, "aim"); !aim.empty()) mode_of(component, aim);
    }
    const Json& step = member(reason, "transition");
    const std::string name = text_of(step, "component");
    if (name.empty()) return;
    automata::Component& component = component_of(name);
    automata::Transition transition;
    transition.from = mode_of(component, text_of(step, "from"));
    transition.to = mode_of(component, text_of(step, "to"));
    const Json& line = member(step, "line");
    if (line.is_number_unsigned()) {
      transition.origin.file = text_of(step, "file");
      transition.origin.line =
          static_cast<std::uint32_t>(std::min<std::uint64_t>(line.get<std::uint64_t>(), UINT32_MAX));
    }
    auto& all = component.transitions;
    if (std::find(all.begin(), all.end(), transition) == all.end()) all.push_back(std::move(transition));
  }

  void take_evidence(const Json& evidence) {
    const std::string name = text_of(evidence, "component");
    if (name.empty()) return;
    automata::Component& component = component_of(name);
    const automata::ModeId fault = mode_of(component, text_of(evidence, "fault"));
    component.modes[fault.index()].fault = true;
    modes(member(evidence, "story"));
    each(member(evidence, "readings"), [this](const std::string& of, const std::string& value) { seen(of, value); });
    for (const Json& one : member(evidence, "interconnections")) {
      const Json& number = member(one, "number");
      constexpr std::uint64_t most = 1'000'000;
      if (!number.is_number_unsigned() || number.get<std::uint64_t>() > most) continue;
      while (model_.plant.interconnections.size() < number.get<std::size_t>())
        model_.plant.interconnections.emplace_back(automata::constant(true));
    }
    for (const Json& mode : member(evidence, "modes")) {
      if (const std::string of = text_of(mode, "component"); !of.empty())
        mode_of(component_of(of), text_of(mode, "mode"));
    }
  }

  NamedModel model_;
  std::size_t locations_ = 1;
};

}  // namespace

NamedModel named_model(const std::string& trace, const std::string& name) {
  Names names(name.substr(name.rfind('/') + 1));
  std::istringstream in(trace);
  std::size_t number = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    const Json line = Json::parse(text, nullptr, false);
    if (line.is_discarded() && in.eof()) break;  // it was never finished
    if (!line.is_object()) throw base::InputError(name + ":" + std::to_string(number) + ": expected a JSON object");
    try {
      names.take(line);
    } catch (const base::InputError& error) {
      throw base::InputError(name + ":" + std::to_string(number) + error.what());
    }
  }
  return names.finish();
}

}  // namespace rmpl::tools
