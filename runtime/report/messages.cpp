// What happened in a flight as messages: one form, for files and for streams.
// SPDX-License-Identifier: MIT
#include "runtime/report/messages.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/check.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

using automata::Ticks;

namespace {

constexpr std::array<MessageChannel, 9> all_channels{
    {{"/estimate", "the estimated mode of each component"},
     {"/truth", "the mode of each component, in the simulated plant"},
     {"/belief", "for each component, the probability of each possible mode, in percent"},
     {"/goal", "the goals that the program asserts"},
     {"/command", "the controls that are not idle, and why"},
     {"/reading", "the readings of all sensors that are not silent"},
     {"/marking", "the locations of the program that are marked, from 1"},
     {"/event", "surprises, faults and other events"},
     {"/channel", "the latest sample of each telemetry channel"}}};

class Messages {
 public:
  explicit Messages(const Flight& flight) : flight_(flight), plant_(*flight.plant) {}

  std::vector<FlightMessage> all() {
    add_modes(0, flight_.estimate);
    add_modes(1, flight_.truth);
    add_belief();
    add_goals();
    add_commands();
    add_readings();
    add_marking();
    add_events();
    add_samples();
    std::stable_sort(messages_.begin(), messages_.end(),
                     [](const FlightMessage& a, const FlightMessage& b) { return a.time < b.time; });
    return std::move(messages_);
  }

 private:
  template <class Write>
  void add(std::size_t channel, Ticks time, const Write& write) {
    json_.clear();
    json_.open('{');
    write();
    json_.close('}');
    messages_.push_back({time, channel, json_.text()});
  }

  void add_modes(std::size_t channel, const std::vector<Track<automata::ModeId>>& tracks) {
    for (const Ticks time : times_of(tracks)) {
      add(channel, time, [&] {
        for (std::size_t c = 0; c < tracks.size(); ++c) {
          const automata::ModeId* mode = tracks[c].at(time);
          if (mode == nullptr) continue;
          json_.key(plant_.components[c].name).string(plant_.components[c].modes[mode->index()].name);
        }
      });
    }
  }

  void add_belief() {
    for (const Ticks time : times_of(flight_.belief)) {
      add(2, time, [&] {
        for (std::size_t c = 0; c < flight_.belief.size(); ++c) {
          const automata::Component& component = plant_.components[c];
          const Shares* shares = flight_.belief[c].at(time);
          const automata::ModeId* mode = flight_.estimate[c].at(time);
          json_.key(component.name).open('{');
          if (shares != nullptr && !shares->empty()) {
            for (const auto& [m, percent] : *shares) json_.key(component.modes[m.index()].name).number(percent);
          } else if (mode != nullptr) {
            json_.key(component.modes[mode->index()].name).number(100);
          }
          json_.close('}');
        }
      });
    }
  }

  void add_goals() {
    for (const auto& change : flight_.goals.changes()) {
      add(3, change.time, [&] {
        for (const AssertedGoal& goal : change.value) {
          json_.key(plant_.variables.name(goal.goal.variable)).string(plant_.variables.value(goal.goal));
        }
      });
    }
  }

  void add_commands() {
    for (const Ticks time : times_of(flight_.commands)) {
      add(4, time, [&] {
        json_.key("command").open('{');
        bool some = false;
        for (std::size_t i = 0; i < flight_.commands.size(); ++i) {
          const automata::Control& control = plant_.controls[i];
          const automata::ValueId* value = flight_.commands[i].at(time);
          if (value == nullptr || *value == control.idle) continue;
          some = true;
          json_.key(plant_.variables.name(control.variable));
          json_.string(plant_.variables.value({control.variable, *value}));
        }
        json_.close('}');
        const Explanation* why = flight_.explanations.at(time);
        if (some && why != nullptr) json_.key("why").string(why->why);
      });
    }
  }

  void add_readings() {
    for (const Ticks time : times_of(flight_.readings)) {
      add(5, time, [&] {
        for (std::size_t i = 0; i < flight_.readings.size(); ++i) {
          const auto* value = flight_.readings[i].at(time);
          if (value == nullptr || !*value) continue;
          const automata::Variable& variable = plant_.variables[plant_.observables[i]];
          json_.key(variable.name).string(variable.values[(*value)->index()]);
        }
      });
    }
  }

  void add_marking() {
    for (const auto& change : flight_.marking.changes()) {
      add(6, change.time, [&] {
        json_.key("locations").open('[');
        for (const automata::LocationId location : change.value) json_.number(location.index() + 1);
        json_.close(']');
      });
    }
  }

  void add_events() {
    for (const Happening& happening : flight_.happenings) {
      add(7, happening.from, [&] {
        json_.key("kind").string(happening.kind);
        if (happening.component) json_.key("component").string(plant_[*happening.component].name);
        if (happening.to) json_.key("until").seconds(*happening.to);
        json_.key("text").string(happening.text);
      });
    }
  }

  void add_samples() {
    std::vector<Track<Signal>> signals;
    for (const FlownChannel& channel : flight_.channels) signals.push_back(channel.signal);
    for (const Ticks time : times_of(signals)) {
      add(sample_channel, time, [&] {
        for (std::size_t c = 0; c < signals.size(); ++c) {
          const Signal* signal = signals[c].at(time);
          if (signal == nullptr) continue;
          json_.key(flight_.channels[c].name);
          if (signal->number) {
            json_.number(*signal->number);
          } else {
            json_.string(signal->text);
          }
        }
      });
    }
  }

  const Flight& flight_;
  const automata::Plant& plant_;
  JsonLine json_;
  std::vector<FlightMessage> messages_;
};

/// What the messages of each channel hold, as JSON Schema: the fields, and the values that they have.
class Schemas {
 public:
  Schemas(const automata::Plant& plant, const std::vector<FlownChannel>& telemetry)
      : plant_(plant), telemetry_(telemetry) {}

  std::string text(std::size_t channel) {
    json_.clear();
    json_.open('{').key("type").string("object").key("description").string(all_channels[channel].about);
    json_.key("properties").open('{');
    fields(channel);
    json_.close('}').close('}');
    return json_.text();
  }

 private:
  void fields(std::size_t channel) {
    switch (channel) {
      case 0:
      case 1:
      case 3:
        for (const automata::Component& component : plant_.components) value(component.mode);
        return;
      case 2:
        for (const automata::Component& component : plant_.components) shares(component);
        return;
      case 4:
        json_.key("command").open('{').key("type").string("object").key("properties").open('{');
        for (const automata::Control& control : plant_.controls) value(control.variable);
        json_.close('}').close('}');
        plain("why", "string");
        return;
      case 5:
        for (const automata::VariableId observable : plant_.observables) value(observable);
        return;
      case 6:
        json_.key("locations").open('{').key("type").string("array").key("items").open('{');
        json_.key("type").string("integer").close('}').close('}');
        return;
      case sample_channel:
        for (const FlownChannel& one : telemetry_) {
          json_.key(one.name).open('{').key("type").open('[').string("number").string("string").close(']').close('}');
        }
        return;
      default:
        for (const char* name : {"kind", "component", "text"}) plain(name, "string");
        plain("until", "number");
    }
  }

  void plain(std::string_view name, std::string_view type) {
    json_.key(name).open('{').key("type").string(type).close('}');
  }

  /// A variable, by the values of its domain.
  void value(automata::VariableId id) {
    const automata::Variable& variable = plant_.variables[id];
    json_.key(variable.name).open('{').key("type").string("string").key("enum").open('[');
    for (const std::string& one : variable.values) json_.string(one);
    json_.close(']').close('}');
  }

  void shares(const automata::Component& component) {
    json_.key(component.name).open('{').key("type").string("object").key("properties").open('{');
    for (const automata::Mode& mode : component.modes) plain(mode.name, "number");
    json_.close('}').close('}');
  }

  const automata::Plant& plant_;
  const std::vector<FlownChannel>& telemetry_;
  JsonLine json_;
};

}  // namespace

std::span<const MessageChannel> message_channels() { return all_channels; }

std::string message_schema(std::size_t channel, const automata::Plant& plant,
                           const std::vector<FlownChannel>& telemetry) {
  CHECK(channel < all_channels.size());
  return Schemas(plant, telemetry).text(channel);
}

std::vector<FlightMessage> messages_of(const Flight& flight) { return Messages(flight).all(); }

MessageStream::MessageStream(const automata::Document& document, const automata::Scenario& scenario)
    : recorder_(document, scenario), sent_(all_channels.size()) {}

void MessageStream::observe(const CycleRecord& record) {
  recorder_.forget();
  told_events_ = recorder_.flight().happenings.size();
  recorder_.observe(record);
}

std::vector<FlightMessage> MessageStream::take() {
  std::vector<FlightMessage> last(all_channels.size()), fresh;
  std::size_t events = 0;
  for (FlightMessage& message : messages_of(recorder_.flight())) {
    if (message.channel != event_channel) {
      last[message.channel] = std::move(message);
    } else if (events++ >= told_events_) {
      fresh.push_back(std::move(message));
    }
  }
  for (std::size_t c = 0; c < last.size(); ++c) {
    if (last[c].data.empty() || last[c] == sent_[c]) continue;
    sent_[c] = last[c];
    fresh.push_back(std::move(last[c]));
  }
  std::stable_sort(fresh.begin(), fresh.end(),
                   [](const FlightMessage& a, const FlightMessage& b) { return a.time < b.time; });
  return fresh;
}

void MessageStream::begin_anew() { sent_.assign(all_channels.size(), {}); }

}  // namespace rmpl::runtime
