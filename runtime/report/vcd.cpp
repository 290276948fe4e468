// Value change dump: declarations, then changes by time.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <functional>
#include <string_view>

#include "automata/owner.hpp"
#include "base/check.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/report/exports.hpp"

namespace rmpl::runtime {
namespace {

using automata::Ticks;

/// A name as an identifier of a dump, which ends at white space. Bytes of a letter beyond ASCII stand for themselves.
std::string identifier(std::string_view name) {
  std::string result;
  for (const char c : name) result += static_cast<unsigned char>(c) <= ' ' || c == 0x7f ? '_' : c;
  return result.empty() ? "_" : result;
}

class Dump {
 public:
  explicit Dump(const Flight& flight) : flight_(flight), plant_(*flight.plant) {}

  std::string text() {
    text_ = "$comment " + identifier(flight_.name) + " $end\n$version rmpl $end\n$timescale 1 ns $end\n";
    open(flight_.program != nullptr ? flight_.program->name : plant_.name);
    for (std::size_t c = 0; c < plant_.components.size(); ++c) declare_component(c);
    declare_variables(npos);
    declare_channels();
    declare_marking();
    close();
    text_ += "$enddefinitions $end\n";
    write_changes();
    return std::move(text_);
  }

 private:
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  struct Written {
    Ticks time;
    std::string change;
  };

  void open(std::string_view name) { text_ += "$scope module " + identifier(name) + " $end\n"; }
  void close() { text_ += "$upscope $end\n"; }

  /// Declares a variable; what comes back names it in changes: printable characters, the shortest first.
  std::string declare(std::string_view type, std::size_t width, std::string_view name) {
    std::string id;
    for (std::size_t number = variables_++;; number = number / 94 - 1) {
      id += static_cast<char>('!' + number % 94);
      if (number < 94) break;
    }
    text_ += "$var " + std::string(type) + " " + std::to_string(width) + " " + id + " " + identifier(name) + " $end\n";
    return id;
  }

  void note(Ticks time, std::string change) { written_.push_back({time, std::move(change)}); }

  /// A track of names, as strings: those have no place in the standard (IEEE 1364), and are what GTKWave, Surfer and
  /// others read. `name_of` gives null for what is not driven, which is a minus sign.
  template <class Value, class NameOf>
  void write_strings(std::string_view name, const Track<Value>& track, const NameOf& name_of) {
    const std::string id = declare("string", 1, name);
    for (const Change<Value>& change : track.changes()) {
      const std::string* value = name_of(change.value);
      note(change.time, "s" + (value == nullptr ? "-" : identifier(*value)) + " " + id);
    }
    if (track.empty() || track.changes().front().time > Ticks{}) note(Ticks{}, "s- " + id);
  }

  /// Opens the scopes of a path; how many there are.
  std::size_t open_path(const std::string& path) {
    std::size_t scopes = 0;
    for (std::size_t from = 0; from <= path.size(); ++scopes) {
      const std::size_t dot = std::min(path.find('.', from), path.size());
      open(path.substr(from, dot - from));
      from = dot + 1;
    }
    return scopes;
  }

  void declare_component(std::size_t c) {
    const automata::Component& component = plant_.components[c];
    const auto name = [&](automata::ModeId mode) { return &component.modes[mode.index()].name; };
    const std::size_t scopes = open_path(component.name);
    if (!flight_.estimate.empty()) {
      write_strings("estimate", flight_.estimate[c], name);
      write_belief(c);
    }
    if (!flight_.truth.empty()) write_strings("truth", flight_.truth[c], name);
    write_fault(component, flight_.estimate.empty() ? flight_.truth[c] : flight_.estimate[c]);
    write_goal(c);
    declare_variables(c);
    for (std::size_t s = 0; s < scopes; ++s) close();
  }

  void write_belief(std::size_t c) {
    const std::string id = declare("real", 64, "belief");
    std::vector<Ticks> times = times_of(std::vector{flight_.estimate[c]});
    for (const auto& change : flight_.belief[c].changes()) times.push_back(change.time);
    std::sort(times.begin(), times.end());
    for (const Ticks time : times) {
      const automata::ModeId* mode = flight_.estimate[c].at(time);
      const Shares* shares = flight_.belief[c].at(time);
      unsigned percent = 100;
      if (mode != nullptr && shares != nullptr && !shares->empty()) {
        const auto own = std::find_if(shares->begin(), shares->end(), [&](const auto& s) { return s.first == *mode; });
        percent = own == shares->end() ? 0 : own->second;
      }
      note(time, "r" + std::to_string(percent) + " " + id);
    }
  }

  void write_fault(const automata::Component& component, const Track<automata::ModeId>& track) {
    const std::string id = declare("wire", 1, "fault");
    for (const auto& change : track.changes()) {
      note(change.time, (component.modes[change.value.index()].fault ? "1" : "0") + id);
    }
  }

  void write_goal(std::size_t c) {
    Track<std::optional<automata::ValueId>> goal;
    goal.set(Ticks{}, std::nullopt);
    bool some = false;
    for (const auto& change : flight_.goals.changes()) {
      std::optional<automata::ValueId> value;
      for (const AssertedGoal& asserted : change.value) {
        if (asserted.goal.variable == plant_.components[c].mode) value = asserted.goal.value;
      }
      some = some || value;
      goal.set(change.time, value);
    }
    if (!some) return;
    write_strings("goal", goal, [&](const auto& value) -> const std::string* {
      return value ? &plant_.components[c].modes[value->index()].name : nullptr;
    });
  }

  /// Commands and readings of a component, or those of none.
  void declare_variables(std::size_t owner) {
    const auto own = [&](const std::string& name) { return owner == npos ? name : name.substr(name.rfind('.') + 1); };
    const auto declare_all = [&](std::string_view scope, std::size_t count, const auto& variable_of,
                                 const auto& write) {
      bool opened = false;
      for (std::size_t i = 0; i < count; ++i) {
        const automata::Variable& variable = plant_.variables[variable_of(i)];
        const auto whose = automata::owner_of(plant_, variable_of(i));
        if ((whose ? whose->index() : npos) != owner) continue;
        if (!opened) open(scope);
        opened = true;
        write(i, own(variable.name), variable.values);
      }
      if (opened) close();
    };
    declare_all(
        "command", flight_.commands.size(), [&](std::size_t i) { return plant_.controls[i].variable; },
        [&](std::size_t i, const std::string& name, const std::vector<std::string>& values) {
          write_strings(name, flight_.commands[i], [&](automata::ValueId value) { return &values[value.index()]; });
        });
    declare_all(
        "reading", flight_.readings.size(), [&](std::size_t i) { return plant_.observables[i]; },
        [&](std::size_t i, const std::string& name, const std::vector<std::string>& values) {
          write_strings(name, flight_.readings[i],
                        [&](const auto& value) { return value ? &values[value->index()] : nullptr; });
        });
  }

  /// A channel with a text among its samples is one of strings.
  void declare_channels() {
    if (flight_.channels.empty()) return;
    open("channel");
    for (const FlownChannel& channel : flight_.channels) {
      const auto& changes = channel.signal.changes();
      const bool numbers = std::all_of(changes.begin(), changes.end(),
                                       [](const Change<Signal>& change) { return change.value.number.has_value(); });
      const std::string id = numbers ? declare("real", 64, channel.name) : declare("string", 1, channel.name);
      if (!numbers && (changes.empty() || changes.front().time > Ticks{})) note(Ticks{}, "s- " + id);
      for (const auto& change : changes) {
        const Signal& signal = change.value;
        const std::string text = signal.number ? JsonLine().number(*signal.number).text() : identifier(signal.text);
        note(change.time, (numbers ? "r" : "s") + text + " " + id);
      }
    }
    close();
  }

  void declare_marking() {
    if (flight_.program == nullptr) return;
    open("marking");
    for (std::size_t l = 0; l < flight_.program->locations.size(); ++l) {
      const std::string id =
          declare("wire", 1, "l" + std::to_string(l + 1) + "_" + flight_.program->locations[l].label);
      Track<bool> marked;
      marked.set(Ticks{}, false);
      for (const auto& change : flight_.marking.changes()) {
        const auto& locations = change.value;
        marked.set(change.time,
                   std::find(locations.begin(), locations.end(), automata::LocationId(l)) != locations.end());
      }
      for (const auto& change : marked.changes()) note(change.time, (change.value ? "1" : "0") + id);
    }
    close();
  }

  void write_changes() {
    std::stable_sort(written_.begin(), written_.end(),
                     [](const Written& a, const Written& b) { return a.time < b.time; });
    std::optional<Ticks> now;
    for (const Written& written : written_) {
      if (now != written.time) {
        text_ += (now == Ticks{} ? "$end\n" : "") + ("#" + std::to_string(written.time.count)) +
                 (now ? "\n" : "\n$dumpvars\n");
        now = written.time;
      }
      text_ += written.change + "\n";
    }
    if (now == Ticks{}) text_ += "$end\n";
    if (!now || *now < flight_.end) text_ += "#" + std::to_string(flight_.end.count) + "\n";
  }

  const Flight& flight_;
  const automata::Plant& plant_;
  std::string text_;
  std::size_t variables_ = 0;
  std::vector<Written> written_;
};

}  // namespace

std::string to_vcd(const Flight& flight) { return Dump(flight).text(); }

}  // namespace rmpl::runtime
