// Networks for TChecker, in its text format: a process a component, and one for the rounds.
//
// In a round the components have their turns, first all of them to step, then those that may stop time to rest; `m` has
// the modes as it begins, `n` as it ends. No time passes in it, as the process of rounds is in an urgent location. A
// mode is a variable and no location, so that what a component does in several modes is one edge.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include "automata/controls.hpp"
#include "base/check.hpp"
#include "base/error.hpp"
#include "verifier/export/round_process.hpp"
#include "verifier/export/write.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::Plant;
using automata::ValueId;
using automata::VariableId;

namespace {

/// TChecker's constants are 32-bit integers; twice as much is computed with.
constexpr Units greatest = (Units{1} << 30) - 1;

std::string constant(Units units) {
  if (units <= greatest) return std::to_string(units);
  throw base::InputError("tchecker: a time bound of " + std::to_string(units) +
                         " units is beyond its integers; expected coarser or shorter bounds");
}

/// Parts between a separator; nothing where there are none.
class Joined {
 public:
  explicit Joined(std::string separator) : separator_(std::move(separator)) {}
  void add(const std::string& part) {
    if (!part.empty()) text_ += (text_.empty() ? "" : separator_) + part;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string separator_;
  std::string text_;
};

class Writer {
 public:
  Writer(std::ostream& out, const Plant& plant, const Network& network) : out_(out), plant_(plant), network_(network) {
    for (std::size_t c = 0; c < count(); ++c) {
      processes_.push_back(in_rounds(plant, automata::ComponentId(c), network.processes[c]));
      if (!processes_.back().rests.empty()) ++resting_;
    }
  }

  void run() {
    out_ << "# " << plant_.name << ": is a location labelled `target` reachable?\n"
         << "# 1 unit of time is " << automata::format_seconds(network_.time.unit()) << " s\n"
         << "system:plant\n\nevent:tau\n\n";
    variables();
    rounds();
    std::size_t rest = count() + 1;  // the turn of the next component that rests
    for (std::size_t c = 0; c < count(); ++c) {
      process(c, rest);
      if (!processes_[c].rests.empty()) ++rest;
    }
  }

 private:
  /// Whose modes a condition reads.
  enum class When { before, after };

  [[nodiscard]] std::size_t count() const { return plant_.components.size(); }
  [[nodiscard]] std::size_t last_turn() const { return count() + 1 + resting_; }
  static std::string before(std::size_t component) { return "m" + std::to_string(component); }
  static std::string after(std::size_t component) { return "n" + std::to_string(component); }
  static std::string control(std::size_t number) { return "u" + std::to_string(number); }
  static std::string clock(std::size_t component) { return "x" + std::to_string(component); }
  static std::string turn_is(std::size_t turn) { return "turn==" + std::to_string(turn); }
  static std::string turn_to(std::size_t turn) { return "turn=" + std::to_string(turn); }

  void integer(std::size_t last, std::size_t first, const std::string& name) {
    out_ << "int:1:0:" << last << ':' << first << ':' << name << '\n';
  }

  void variables() {
    for (std::size_t c = 0; c < count(); ++c) {
      const automata::Component& component = plant_.components[c];
      out_ << "# " << c << ": " << component.name << ':';
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        out_ << (m == 0 ? " " : ", ") << m << ' ' << component.modes[m].name;
      }
      out_ << '\n';
      integer(component.modes.size() - 1, 0, before(c));
      integer(component.modes.size() - 1, network_.processes[c].initial.front().index(), after(c));
      if (network_.processes[c].clocked) out_ << "clock:1:" << clock(c) << '\n';
    }
    for (std::size_t u = 0; u < plant_.controls.size(); ++u) {
      const automata::Variable& variable = plant_.variables[plant_.controls[u].variable];
      out_ << "# " << variable.name << ':';
      for (std::size_t v = 0; v < variable.values.size(); ++v)
        out_ << (v == 0 ? " " : ", ") << v << ' ' << variable.values[v];
      out_ << '\n';
      integer(variable.values.size() - 1, plant_.controls[u].idle.index(), control(u));
    }
    integer(last_turn(), count(), "turn");
    if (network_.faults > 0) integer(network_.faults, 0, "faults");
  }

  void location(const std::string& process, const std::string& name, const std::string& attributes) {
    out_ << "location:" << process << ':' << name << '{' << attributes << "}\n";
  }
  void edge(const std::string& process, const std::string& from, const std::string& to, const Joined& guard,
            const Joined& effect) {
    Joined attributes(" : ");
    if (!guard.text().empty()) attributes.add("provided:" + guard.text());
    if (!effect.text().empty()) attributes.add("do:" + effect.text());
    out_ << "edge:" << process << ':' << from << ':' << to << ":tau{" << attributes.text() << "}\n";
  }
  static Joined guard_of(const std::string& first) { return joined("&&", first); }
  static Joined effect_of(const std::string& first) { return joined(";", first); }
  static Joined joined(const std::string& separator, const std::string& first) {
    Joined parts(separator);
    parts.add(first);
    return parts;
  }

  static void add_bounds(Joined& guard, const std::string& clock, const Interval& range) {
    if (range.lower > 0) guard.add(clock + ">=" + constant(range.lower));
    if (range.upper != unbounded) guard.add(clock + "<=" + constant(range.upper));
  }

  /// Who has the turn, what is commanded, and what came of a round. It begins at the end of one, with the initial
  /// modes.
  void rounds() {
    out_ << "\nprocess:Rounds\n";
    std::vector<std::size_t> open;  // components with several initial modes
    for (std::size_t c = 0; c < count(); ++c) {
      if (network_.processes[c].initial.size() > 1) open.push_back(c);
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
      location("Rounds", start(i), i == 0 ? "initial: : urgent:" : "urgent:");
    }
    location("Rounds", "round", open.empty() ? "initial: : urgent:" : "urgent:");
    location("Rounds", "rest", "");
    location("Rounds", "reached", "labels:target");
    for (std::size_t i = 0; i < open.size(); ++i) {
      for (const automata::ModeId mode : network_.processes[open[i]].initial) {
        edge("Rounds", start(i), i + 1 < open.size() ? start(i + 1) : "round", guard_of(""),
             effect_of(after(open[i]) + "=" + std::to_string(mode.index())));
      }
    }
    const bool several = network_.commands == Commands::any;
    if (several) {
      location("Rounds", "choice", "urgent:");
      edge("Rounds", "rest", "choice", guard_of(""), effect_of(""));
    }
    edge("Rounds", several ? "choice" : "rest", "round", guard_of(""), effect_of(turn_to(0)));
    for (std::size_t u = 0; u < plant_.controls.size() && network_.commands != Commands::none; ++u) {
      const automata::Control& of = plant_.controls[u];
      for (std::size_t v = 0; v < plant_.variables[of.variable].values.size(); ++v) {
        if (v == of.idle.index()) continue;
        Joined effect = effect_of(control(u) + "=" + std::to_string(v));
        if (several) {
          edge("Rounds", "choice", "choice", guard_of(control(u) + "==" + std::to_string(of.idle.index())), effect);
        } else {
          effect.add(turn_to(0));
          edge("Rounds", "rest", "round", guard_of(""), effect);
        }
      }
    }
    Joined possible = guard_of(turn_is(count()));
    for (const Formula& one : network_.possible) possible.add(condition(one, When::after));
    edge("Rounds", "round", "round", possible, effect_of(turn_to(count() + 1)));
    if (network_.target != automata::constant(false)) {
      Joined reached = guard_of(turn_is(last_turn()));
      reached.add(condition(network_.target, When::after));
      edge("Rounds", "round", "reached", reached, effect_of(""));
    }
    Joined effect(";");
    for (std::size_t c = 0; c < count(); ++c) effect.add(before(c) + "=" + after(c));
    for (std::size_t u = 0; u < plant_.controls.size(); ++u) {
      effect.add(control(u) + "=" + std::to_string(plant_.controls[u].idle.index()));
    }
    edge("Rounds", "round", "rest", guard_of(turn_is(last_turn())), effect);
  }

  static std::string start(std::size_t number) { return "start" + std::to_string(number); }
  static std::string place_of(const RoundRest& rest) {
    if (rest.urgent) return "stops";
    if (rest.restarts) return "renews";
    return rest.clock.upper == unbounded ? "acts" : waits(rest.clock.upper);
  }
  /// The location where time passes up to a bound.
  static std::string waits(Units bound) { return "waits" + std::to_string(bound); }

  /// `rest`: its turn to rest, if it has one.
  void process(std::size_t c, std::size_t rest) {
    const RoundProcess& process = processes_[c];
    const std::string name = "p" + std::to_string(c);
    out_ << "\nprocess:" << name << '\n';
    location(name, "acts", "initial:");
    for (const Units bound : process.bounds)
      location(name, waits(bound), "invariant:" + clock(c) + "<=" + constant(bound));
    if (process.stops) location(name, "stops", "urgent:");
    if (process.renews) location(name, "renews", "");
    for (const Units bound : process.bounds) edge(name, waits(bound), "acts", guard_of(turn_is(c)), effect_of(""));
    if (process.stops) edge(name, "stops", "acts", guard_of(turn_is(c)), effect_of(""));
    if (process.renews) {
      Joined wakes = guard_of(turn_is(c));
      wakes.add(clock(c) + ">=1");
      edge(name, "renews", "acts", wakes, effect_of(clock(c) + "=0"));
    }
    for (const RoundStep& step : process.steps) {
      Joined guard = guard_of(turn_is(c));
      guard.add(condition(step.where, When::before));
      add_bounds(guard, clock(c), step.clock);
      Joined effect = effect_of(after(c) + "=" + (step.to ? std::to_string(step.to->index()) : before(c)));
      if (step.fault) {
        guard.add("faults<" + std::to_string(network_.faults));
        effect.add("faults=faults+1");
      }
      if (step.restarts) effect.add(clock(c) + "=0");
      effect.add(turn_to(c + 1));
      edge(name, "acts", "acts", guard, effect);
    }
    for (const RoundRest& one : process.rests) {
      Joined guard = guard_of(turn_is(rest));
      guard.add(condition(one.where, When::after));
      add_bounds(guard, clock(c), one.clock);
      Joined effect = effect_of(turn_to(rest + 1));
      if (one.restarts) effect.add(clock(c) + "=0");
      edge(name, "acts", place_of(one), guard, effect);
    }
  }

  /// As a conjunction, which is all that TChecker has; empty where it holds always. Else there are conditional terms.
  [[nodiscard]] std::string condition(const Formula& formula, When when) const {
    switch (formula.kind) {
      case Formula::Kind::constant:
        return formula.truth ? "" : "0";
      case Formula::Kind::member:
        return member(formula, when);
      case Formula::Kind::negation: {
        const std::string inner = condition(formula.operands.front(), when);
        return inner.empty() ? "0" : "(if " + inner + " then 0 else 1)";
      }
      case Formula::Kind::conjunction: {
        Joined all("&&");
        for (const Formula& operand : formula.operands) all.add(condition(operand, when));
        return all.text();
      }
      case Formula::Kind::disjunction: {
        std::string text = "0";
        for (auto operand = formula.operands.rbegin(); operand != formula.operands.rend(); ++operand) {
          const std::string one = condition(*operand, when);
          if (one.empty()) return "";
          text = "(if " + one + " then 1 else " + text + ")";
        }
        return text;
      }
      default:
        break;
    }
    CHECK(false && "a condition is made of members");
    return {};
  }

  [[nodiscard]] std::string member(const Formula& formula, When when) const {
    const auto component = plant_.component_of(formula.variable);
    const std::string name = !component             ? control(*automata::control_of(plant_, formula.variable))
                             : when == When::before ? before(component->index())
                                                    : after(component->index());
    const std::size_t all = plant_.variables[formula.variable].values.size();
    // Stretches of values that follow each other.
    std::vector<std::pair<std::size_t, std::size_t>> stretches;
    for (const ValueId value : formula.values) {
      const bool follows = !stretches.empty() && stretches.back().second + 1 == value.index();
      follows ? void(++stretches.back().second) : void(stretches.emplace_back(value.index(), value.index()));
    }
    if (formula.values.size() + 1 == all && all > 2) {
      std::size_t missing = 0;
      while (missing < formula.values.size() && formula.values[missing].index() == missing) ++missing;
      return name + "!=" + std::to_string(missing);
    }
    std::string text = "0";
    for (auto stretch = stretches.rbegin(); stretch != stretches.rend(); ++stretch) {
      const auto& [first, last] = *stretch;
      Joined within("&&");
      if (first == last) {
        within.add(name + "==" + std::to_string(first));
      } else {
        if (first > 0) within.add(name + ">=" + std::to_string(first));
        if (last + 1 < all) within.add(name + "<=" + std::to_string(last));
      }
      if (stretches.size() == 1 || within.text().empty()) return within.text();
      text = "(if " + within.text() + " then 1 else " + text + ")";
    }
    return text;
  }

  std::ostream& out_;
  const Plant& plant_;
  const Network& network_;
  std::vector<RoundProcess> processes_;  ///< by component
  std::size_t resting_ = 0;              ///< components that have a turn to rest
};

}  // namespace

void write_tchecker(std::ostream& out, const Plant& plant, const Network& network) {
  Writer(out, plant, network).run();
}

}  // namespace rmpl::verifier
