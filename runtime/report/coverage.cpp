// Marks, item by item.
// SPDX-License-Identifier: MIT
#include "runtime/report/coverage.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

using automata::Component;
using automata::Location;

const char* to_string(CoverageItem::Kind kind) {
  switch (kind) {
    case CoverageItem::Kind::mode:
      return "mode";
    case CoverageItem::Kind::transition:
      return "transition";
    case CoverageItem::Kind::fault:
      return "fault";
    case CoverageItem::Kind::location:
      return "location";
  }
  return "";
}

Coverage::Coverage(const automata::Plant* plant, const automata::Program* program)
    : plant_(*plant),
      program_(program),
      marked_(program != nullptr ? program->locations.size() : 0),
      before_(plant->components.size()) {
  for (const Component& component : plant_.components) {
    entered_.emplace_back(component.modes.size());
    std::vector<Way>& ways = ways_.emplace_back();
    for (const automata::Transition& one : component.transitions) {
      const bool known =
          std::any_of(ways.begin(), ways.end(), [&](const Way& w) { return w.from == one.from && w.to == one.to; });
      if (!known && one.from != one.to) ways.push_back(Way{one.from, one.to, &one, false});
    }
  }
}

void Coverage::observe(const CycleRecord& record) {
  const automata::Modes& modes = record.truth != nullptr ? *record.truth : record.estimate;
  for (std::size_t c = 0; c < modes.size(); ++c) enter(c, modes[c]);
  for (const automata::LocationId location : record.marking) marked_[location.index()] = true;
}

void Coverage::enter(std::size_t component, automata::ModeId mode) {
  entered_[component][mode.index()] = true;
  for (Way& way : ways_[component]) {
    if (way.from == before_[component] && way.to == mode) way.taken = true;
  }
  before_[component] = mode;
}

void Coverage::follow(const Flight& flight) {
  const auto& tracks = flight.truth.empty() ? flight.estimate : flight.truth;
  for (std::size_t c = 0; c < tracks.size(); ++c) {
    for (const auto& change : tracks[c].changes()) enter(c, change.value);
  }
  for (const auto& change : flight.marking.changes()) {
    for (const automata::LocationId location : change.value) marked_[location.index()] = true;
  }
}

std::vector<CoverageItem> Coverage::items() const {
  using Kind = CoverageItem::Kind;
  std::vector<CoverageItem> items;
  const auto add = [&](Kind kind, const std::string& of, std::string name, const automata::Origin& origin,
                       bool touched) {
    items.push_back(CoverageItem{kind, of, std::move(name), origin, touched ? 1U : 0U});
  };
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    const Component& component = plant_.components[c];
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const automata::Mode& mode = component.modes[m];
      add(Kind::mode, plant_.name, component.name + " = " + mode.name, mode.origin, entered_[c][m]);
    }
    for (const Way& way : ways_[c]) {
      std::string name = component.name;
      name.append(": ").append(component.modes[way.from.index()].name);
      name.append(" -> ").append(component.modes[way.to.index()].name);
      add(component.is_fault(*way.first) ? Kind::fault : Kind::transition, plant_.name, std::move(name),
          way.first->origin, way.taken);
    }
  }
  for (std::size_t l = 0; l < marked_.size(); ++l) {
    const Location& location = program_->locations[l];
    if (location.composite) continue;
    add(Kind::location, program_->name, std::to_string(l + 1) + ": " + location.label, location.origin, marked_[l]);
  }
  return items;
}

void add(std::vector<CoverageItem>& items, const std::vector<CoverageItem>& more) {
  const auto key = [](const CoverageItem& item) {
    return std::tie(item.kind, item.of, item.name, item.origin.file, item.origin.line);
  };
  std::map<decltype(key(items.front())), std::size_t> known;
  items.reserve(items.size() + more.size());  // the keys refer to the items
  for (std::size_t i = 0; i < items.size(); ++i) known.emplace(key(items[i]), i);
  for (const CoverageItem& item : more) {
    const auto found = known.find(key(item));
    if (found != known.end()) {
      items[found->second].runs += item.runs;
    } else {
      items.push_back(item);
      known.emplace(key(items.back()), items.size() - 1);
    }
  }
}

std::string to_json(const std::vector<CoverageItem>& items) {
  JsonLine json;
  json.open('{').key("items").open('[');
  for (const CoverageItem& item : items) {
    json.open('{').key("kind").string(to_string(item.kind)).key("of").string(item.of).key("name").string(item.name);
    if (!item.origin.file.empty()) json.key("file").string(item.origin.file).key("line").number(item.origin.line);
    json.key("runs").number(item.runs).close('}');
  }
  json.close(']').close('}');
  return json.text() + "\n";
}

std::vector<CoverageItem> read_coverage(const std::string& json) {
  using Kind = CoverageItem::Kind;
  try {
    std::vector<CoverageItem> items;
    const nlohmann::json document = nlohmann::json::parse(json);
    for (const nlohmann::json& one : document.at("items")) {
      CoverageItem item;
      const auto kind = one.at("kind").get<std::string>();
      for (const Kind known : {Kind::mode, Kind::transition, Kind::fault, Kind::location}) {
        if (kind == to_string(known)) item.kind = known;
      }
      one.at("of").get_to(item.of);
      one.at("name").get_to(item.name);
      item.origin = {one.value("file", std::string()), one.value("line", 0U), 0};
      one.at("runs").get_to(item.runs);
      items.push_back(std::move(item));
    }
    return items;
  } catch (const nlohmann::json::exception& error) {
    throw base::InputError(std::string("coverage: ") + error.what());
  }
}

}  // namespace rmpl::runtime
