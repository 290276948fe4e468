// Names to numbers: the reverse of the writer, key by key.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/trace_reader.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "runtime/executive/trace/evidence_line.hpp"
#include "runtime/executive/trace/reasons.hpp"
#include "runtime/executive/trace/told_estimator.hpp"
#include "runtime/reasoning/reconfigure/outcome.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Json;
using automata::ModeId;

namespace {

/// A member, or null.
const Json* member_of(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto at = object.find(key);
  return at == object.end() || at->is_null() ? nullptr : &*at;
}

std::string word_of(const Json& object, const char* key) {
  const Json* found = member_of(object, key);
  return found != nullptr && found->is_string() ? found->get<std::string>() : std::string();
}

/// A number of a line, a location or an interconnection. Json would convert a fraction, and one too large for the type
/// has no conversion.
std::uint64_t count_of(const Json& number) {
  if (!number.is_number_unsigned()) throw base::InputError(" expected a whole number, not " + number.dump());
  return number.get<std::uint64_t>();
}

/// The elements of a member that is an array; none where there is no such member.
const Json& elements_of(const Json& object, const char* key) {
  static const Json none = Json::array();
  const Json* found = member_of(object, key);
  if (found == nullptr) return none;
  if (!found->is_array()) throw base::InputError(" '" + std::string(key) + "': expected an array");
  return *found;
}

/// The position of a name among those of a kind, or nothing.
template <std::size_t count, class Kind, class Name>
std::optional<Kind> named_one(const std::array<Kind, count>& kinds, std::string_view name, const Name& name_of) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](Kind kind) { return name_of(kind) == name; });
  return found == kinds.end() ? std::nullopt : std::optional(*found);
}

constexpr std::array event_kinds = {Event::Kind::goal_conflict, Event::Kind::no_plan,   Event::Kind::irreversible,
                                    Event::Kind::inconsistent,  Event::Kind::cut,       Event::Kind::forced,
                                    Event::Kind::commanded,     Event::Kind::connected, Event::Kind::gone,
                                    Event::Kind::refused,       Event::Kind::late,      Event::Kind::flood,
                                    Event::Kind::unacknowledged};
constexpr std::array outcomes = {Reconfiguration::Outcome::command, Reconfiguration::Outcome::wait,
                                 Reconfiguration::Outcome::no_plan, Reconfiguration::Outcome::nothing_to_do};

}  // namespace

TraceReader::TraceReader(std::istream& in, std::string name, const automata::Plant& plant,
                         const automata::Program& program, Constraint constraint)
    : in_(in),
      name_(std::move(name)),
      plant_(plant),
      names_(plant),
      program_(program),
      constraint_(std::move(constraint)),
      reader_(line_, name_, plant),
      whole_(Json::object()),
      estimator_(std::make_unique<ToldEstimator>()) {
  record_.estimator = estimator_.get();
}

TraceReader::~TraceReader() = default;

/// A line with its end.
std::optional<std::string> TraceReader::next_text() {
  std::string text;
  if (!std::getline(in_, text)) return std::nullopt;
  const bool ended = !in_.eof();
  if (!ended && Json::parse(text, nullptr, false).is_discarded()) return std::nullopt;
  return text;
}

const CycleRecord* TraceReader::next() {
  while (const auto text = next_text()) {
    line_.clear();
    line_.str(*text);
    const std::optional<LogLine> read = reader_.next();
    if (!read) continue;
    try {
      const Json json = automata::parse_json(*text);
      merge_line(whole_, json);
      if (!read->estimate) throw base::InputError(" expected `estimate`, as in a trace of a flight");
      const std::uint64_t cycle = read->cycle.value_or(begun_ ? record_.cycle + 1 : 0);
      if (begun_ && cycle <= record_.cycle)
        throw base::InputError(" 'cycle': expected one after that of the line before");
      const auto passed = static_cast<std::int64_t>(cycle - record_.cycle);
      record_.start =
          begun_ ? automata::Ticks{read->time.count - (read->time.count - record_.time.count) / passed} : read->time;
      record_.cycle = cycle;
      record_.time = read->time;
      record_.command = automata::action_from(plant_, read->command);
      record_.observations = read->observations;
      record_.set_aside = read->set_aside;
      record_.consistent = read->set_aside.empty();
      record_.known = read->known;
      record_.estimate = names_.all_modes(*read->estimate);
      interpret(json);
    } catch (const base::InputError& error) {
      throw base::InputError(name_ + ":" + std::to_string(read->number) + ":" + error.what());
    } catch (const Json::exception&) {
      throw base::InputError(name_ + ":" + std::to_string(read->number) + ": a value of the wrong type");
    }
    begun_ = true;
    return &record_;
  }
  if (in_.bad()) throw base::InputError(name_ + ": cannot be read");
  return nullptr;
}

void merge_line(Json& whole, const Json& line) {
  const bool delta = line.value("delta", Json(false)) == true;
  if (!delta) whole = Json::object();
  for (const auto& [key, value] : line.items()) {
    const bool by_name = key == "goal" || key == "asserted_by" || key == "truth";
    if (!delta || !by_name || !value.is_object() || !whole.contains(key) || !whole[key].is_object()) {
      whole[key] = value;
      continue;
    }
    for (const auto& [name, changed] : value.items()) {
      if (changed.is_null()) {
        whole[key].erase(name);
      } else {
        whole[key][name] = changed;
      }
    }
  }
}

void TraceReader::interpret(const Json& line) {
  record_.truth = nullptr;
  if (const Json* truth = member_of(whole_, "truth")) {
    truth_ = named_modes(*truth);
    record_.truth = &truth_;
  }
  read_channels(line);
  read_marking();
  read_goals();
  read_reason();
  read_events();
  read_evidence(line);
  read_belief(line);
}

/// Samples are of the line alone.
void TraceReader::read_channels(const Json& line) {
  record_.samples.clear();
  const Json* channels = member_of(line, "channels");
  if (channels == nullptr) return;
  record_.channels = &channels_;
  for (const auto& [name, value] : channels->items()) {
    if (value.is_null()) continue;
    const auto known = std::find(channels_.begin(), channels_.end(), name);
    const auto channel = static_cast<std::uint32_t>(known - channels_.begin());
    if (known == channels_.end()) channels_.push_back(name);
    record_.samples.push_back(value.is_number() ? Sample::of_number(channel, value.get<double>(), value.dump())
                                                : Sample::of_text(channel, value.get_ref<const std::string&>()));
  }
}

void TraceReader::read_marking() {
  record_.marking.clear();
  for (const Json& number : elements_of(whole_, "marking")) record_.marking.push_back(location_of(number));
}

void TraceReader::read_goals() {
  record_.goals = {};
  const Json* by = member_of(whole_, "asserted_by");
  if (const Json* goal = member_of(whole_, "goal")) {
    record_.goals.goal = assignments_of(*goal);
    for (const automata::Assignment& one : record_.goals.goal) {
      const std::string& name = plant_.variables.name(one.variable);
      const Json* asserting = by == nullptr ? nullptr : member_of(*by, name.c_str());
      const Json* location = asserting == nullptr ? nullptr : member_of(*asserting, "location");
      if (location == nullptr) throw base::InputError(" 'asserted_by': expected the location of '" + name + "'");
      record_.goals.by.push_back(location_of(*location));
    }
  }
  for (const Json& constraint : elements_of(whole_, "goal_constraints")) {
    const Json* location = member_of(constraint, "location");
    if (location == nullptr) throw base::InputError(" 'goal_constraints': expected a location of each");
    record_.goals.constraints.push_back({constraint_(word_of(constraint, "constraint")), location_of(*location)});
  }
}

void TraceReader::read_reason() {
  record_.outcome = Reconfiguration::Outcome::nothing_to_do;
  record_.why = {};
  const Json* reason = member_of(whole_, "reason");
  if (reason == nullptr) return;
  const auto outcome = named_one(outcomes, word_of(*reason, "outcome"),
                                 [](Reconfiguration::Outcome one) { return runtime::name_of(one); });
  if (!outcome) throw base::InputError(" 'reason': expected an outcome");
  record_.outcome = *outcome;
  Reason& why = record_.why;
  why.proved_best = reason->value("solved", true);
  why.purpose = purpose_named(word_of(*reason, "purpose"));
  why.obstacle = obstacle_named(word_of(*reason, "obstacle"));
  if (const Json* goal = member_of(*reason, "goal")) {
    const auto own = assignments_of(*goal);
    const auto& goals = record_.goals.goal;
    const auto at = own.empty() ? goals.end() : std::find(goals.begin(), goals.end(), own.front());
    if (at != goals.end()) why.conjunct = static_cast<std::uint32_t>(at - goals.begin());
  } else if (const std::string text = word_of(*reason, "goal_constraint"); !text.empty()) {
    const auto& constraints = record_.goals.constraints;
    for (std::size_t c = 0; c < constraints.size() && !why.conjunct; ++c) {
      if (to_text(constraints[c].formula, plant_.variables) != text) continue;
      why.conjunct = static_cast<std::uint32_t>(record_.goals.goal.size() + c);
    }
  }
  if (member_of(*reason, "component") != nullptr) {
    why.component = component_of(*reason);
    if (const Json* aim = member_of(*reason, "aim")) why.aim = mode_of(*why.component, *aim);
  }
  if (const Json* step = member_of(*reason, "transition")) why.step = transition_of(*step);
}

void TraceReader::read_events() {
  record_.events.clear();
  for (const Json& told : elements_of(whole_, "events")) {
    const auto kind =
        named_one(event_kinds, word_of(told, "kind"), [](Event::Kind one) { return runtime::name_of(one); });
    if (!kind) throw base::InputError(" 'events': expected the kind of each");
    Event event{*kind, word_of(told, "message"), std::nullopt, std::nullopt};
    if (member_of(told, "component") != nullptr) event.component = component_of(told);
    const Json& locations = elements_of(told, "locations");
    if (locations.size() == 2) event.locations = {location_of(locations[0]), location_of(locations[1])};
    record_.events.push_back(std::move(event));
  }
}

void TraceReader::read_evidence(const Json& line) {
  record_.evidence.clear();
  for (const Json& told : elements_of(line, "evidence")) {
    Evidence evidence;
    evidence.component = component_of(told);
    if (const Json* fault = member_of(told, "fault")) evidence.fault = mode_of(evidence.component, *fault);
    evidence.kind = evidence_named(word_of(told, "kind"));
    evidence.ratio = told.value("ratio", 0.0);
    if (evidence.kind != Evidence::Kind::unavoidable) {
      evidence.story = record_.estimate;
      for (const auto& [name, mode] : told.at("story").items()) {
        const auto component = plant_.find_component(name);
        if (!component)
          throw base::InputError(" 'evidence': plant '" + plant_.name + "' has no component '" + name + "'");
        evidence.story[component->index()] = mode_of(*component, mode);
      }
    }
    if (const Json* readings = member_of(told, "readings")) evidence.readings = assignments_of(*readings);
    for (const Json& mode : elements_of(told, "modes")) evidence.modes.push_back(component_of(mode));
    for (const Json& one : elements_of(told, "interconnections")) {
      const std::uint64_t number = count_of(one.at("number"));
      if (number < 1 || number > plant_.interconnections.size())
        throw base::InputError(" 'interconnections': the plant has no number " + std::to_string(number));
      evidence.interconnections.push_back(number - 1);
    }
    record_.evidence.push_back(std::move(evidence));
  }
}

void TraceReader::read_belief(const Json& line) {
  Belief belief;
  for (const Json& told : elements_of(line, "belief")) {
    BeliefEntry entry{{named_modes(told.at("modes")), {}}, told.at("probability").get<double>()};
    belief.push_back(std::move(entry));
  }
  estimator_->set(record_.estimate, record_.set_aside, std::move(belief));
  record_.probability = estimator_->estimate().probability;
}

automata::Modes TraceReader::named_modes(const Json& names) const {
  std::vector<automata::Assignment> told;
  for (const auto& [name, value] : names.items()) {
    told.push_back(names_.resolve(LogReader::Role::estimate, name, value.get_ref<const std::string&>()));
  }
  return names_.all_modes(told);
}

ComponentId TraceReader::component_of(const Json& object) const {
  const std::string name = word_of(object, "component");
  if (const auto component = plant_.find_component(name)) return *component;
  throw base::InputError(" plant '" + plant_.name + "' has no component '" + name + "'");
}

ModeId TraceReader::mode_of(ComponentId component, const Json& name) const {
  const auto& modes = plant_[component].modes;
  const auto found = std::find_if(modes.begin(), modes.end(), [&](const auto& mode) { return name == mode.name; });
  if (found != modes.end()) return ModeId(static_cast<std::size_t>(found - modes.begin()));
  throw base::InputError(" '" + plant_[component].name + "' has no mode " + name.dump());
}

automata::LocationId TraceReader::location_of(const Json& number) const {
  const std::uint64_t value = count_of(number);
  if (value >= 1 && value <= program_.locations.size()) return automata::LocationId(value - 1);
  throw base::InputError(" program '" + program_.name + "' has no location " + std::to_string(value));
}

/// The first that leads from where to where it says and stands where it says.
std::optional<TransitionOf> TraceReader::transition_of(const Json& object) const {
  const ComponentId id = component_of(object);
  const automata::Component& component = plant_[id];
  const ModeId from = mode_of(id, object.at("from")), to = mode_of(id, object.at("to"));
  const Json* told = member_of(object, "line");
  const std::uint64_t line = told == nullptr ? 0 : count_of(*told);
  for (std::size_t t = 0; t < component.transitions.size(); ++t) {
    const automata::Transition& one = component.transitions[t];
    if (one.from == from && one.to == to && one.origin.line == line) return TransitionOf{id, automata::TransitionId(t)};
  }
  throw base::InputError(" '" + component.name + "' has no such transition at line " + std::to_string(line));
}

std::vector<automata::Assignment> TraceReader::assignments_of(const Json& object) const {
  std::vector<automata::Assignment> result;
  for (const auto& [name, value] : object.items()) {
    if (value.is_null()) continue;
    const auto variable = plant_.variables.find(name);
    const auto known = variable ? plant_.variables[*variable].find(value.get_ref<const std::string&>()) : std::nullopt;
    if (!known) throw base::InputError(" plant '" + plant_.name + "' has no " + name + " = " + value.dump());
    result.push_back({*variable, *known});
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace rmpl::runtime
