// RMPL as a tree of our own, its text, and its THCA straight from the table of semantics 2.
// SPDX-License-Identifier: MIT
#include "tests/reference/rmpl.hpp"

#include <set>

#include "base/check.hpp"

namespace rmpl::reference {

using automata::ClockId;
using automata::Condition;
using automata::Location;
using automata::LocationId;
using automata::Program;

namespace {

class Printer {
 public:
  Printer(const Rmpl& source, const automata::Variables& variables) : variables_(variables), clocks_(source.clocks) {
    clocks_.emplace_back(own_clock);
  }

  [[nodiscard]] std::string text(const Statement& s) const {
    const auto body = [&](std::size_t part) { return "{ " + text(s.parts[part]) + " }"; };
    const auto constraint = [&] { return automata::to_text(s.constraint, variables_, clocks_); };
    switch (s.kind) {
      case Statement::Kind::goal:
        return automata::to_text(automata::conjunction_of(s.goal), variables_);
      case Statement::Kind::clock_start:
        return clocks_[s.clock.index()] + " = 0";
      case Statement::Kind::sequence:
        return joined(s.parts, "; ");
      case Statement::Kind::parallel:
        return joined(s.parts, ", ");
      case Statement::Kind::if_then:
        return "if " + constraint() + " thennext " + body(0);
      case Statement::Kind::if_else:
        return "if " + constraint() + " thennext " + body(0) + " elsenext " + body(1);
      case Statement::Kind::unless:
        return "unless " + constraint() + " thennext " + body(0);
      case Statement::Kind::when:
        return "when " + constraint() + " donext " + body(0);
      case Statement::Kind::whenever:
        return "whenever " + constraint() + " donext " + body(0);
      case Statement::Kind::always:
        return "always " + body(0);
      case Statement::Kind::repeat:
        return "repeat " + body(0);
      case Statement::Kind::next:
        return "next " + body(0);
      case Statement::Kind::nothing:
        return "{ }";
      case Statement::Kind::each:
        return "each { " + joined(s.parts, ", ") + " }";
      case Statement::Kind::watching:
        return "do " + body(0) + " watching " + constraint();
      case Statement::Kind::maintaining:
        return body(0) + " maintaining " + constraint();
      case Statement::Kind::call:
        return name_of_definition(s.callee) + "()";
    }
    return {};
  }

 private:
  [[nodiscard]] std::string joined(const std::vector<Statement>& parts, const std::string& separator) const {
    std::string result;
    for (const Statement& part : parts) {
      const bool list = part.kind == Statement::Kind::sequence || part.kind == Statement::Kind::parallel;
      result += (result.empty() ? "" : separator) + (list ? "{ " + text(part) + " }" : text(part));
    }
    return result;
  }

  const automata::Variables& variables_;
  std::vector<std::string> clocks_;
};

class Lowering {
 public:
  Lowering(const Rmpl& source, const automata::Variables& variables) : source_(source) {
    program_.name = name_of_definition(0);
    program_.variables = variables;
    program_.clocks = source.clocks;
  }

  Program lower() {
    definition(std::nullopt, 0);
    return std::move(program_);
  }

 private:
  /// Where a piece begins, and from where, under which guard, what follows it is reached.
  struct Piece {
    std::vector<LocationId> starts;
    std::vector<std::pair<LocationId, Condition>> ends;
  };

  LocationId add(std::optional<LocationId> parent) {
    program_.locations.emplace_back().parent = parent;
    return LocationId(program_.locations.size() - 1);
  }
  Location& at(LocationId id) { return program_.locations[id.index()]; }
  void connect(LocationId from, const Condition& guard, const std::vector<LocationId>& targets) {
    for (LocationId target : targets) at(from).arcs.push_back({guard, target});
  }
  static void append(auto& to, const auto& more) { to.insert(to.end(), more.begin(), more.end()); }

  /// A composite around a body, whose parallel parts need no composite of their own.
  Piece composite(std::optional<LocationId> parent, const Condition& maintenance, const Statement& body) {
    const LocationId self = add(parent);
    at(self).composite = true;
    at(self).maintenance = maintenance;
    Piece inside;
    if (body.kind == Statement::Kind::parallel) {
      for (const Statement& part : body.parts) append(inside.starts, piece(self, part).starts);
    } else {
      inside = piece(self, body);
    }
    for (LocationId start : inside.starts) at(start).start = true;
    return {{self}, {{self, {}}}};
  }

  /// Each use of a definition has a clock of its own, called after the number of its composite.
  Piece definition(std::optional<LocationId> parent, std::size_t position) {
    const ClockId outer = own_;
    if (source_.has_own[position]) {
      own_ = ClockId(program_.clocks.size());
      program_.clocks.push_back(std::string(own_clock) + "@" + std::to_string(program_.locations.size() + 1));
    }
    const LocationId self(program_.locations.size());
    Piece made = composite(parent, {}, source_.definitions[position]);
    if (source_.has_own[position]) at(self).own_clocks = {own_};
    own_ = outer;
    return made;
  }

  [[nodiscard]] ClockId clock(ClockId written) const {
    return written.index() < source_.clocks.size() ? written : own_;
  }

  [[nodiscard]] automata::Formula formula(automata::Formula written) const {
    if (written.kind == automata::Formula::Kind::clock) written.clock = clock(written.clock);
    for (automata::Formula& operand : written.operands) operand = formula(operand);
    return written;
  }

  Piece piece(LocationId parent, const Statement& s) {
    const Condition entailed{true, formula(s.constraint)};
    const Condition not_entailed{false, formula(s.constraint)};
    switch (s.kind) {
      case Statement::Kind::goal:
      case Statement::Kind::clock_start: {
        const LocationId self = add(parent);
        at(self).goal = s.goal;
        if (s.kind == Statement::Kind::clock_start) at(self).clock_start = clock(s.clock);
        return {{self}, {{self, {}}}};
      }
      case Statement::Kind::nothing: {
        const LocationId self = add(parent);
        return {{self}, {{self, {}}}};
      }
      case Statement::Kind::repeat: {
        Piece again = piece(parent, s.parts[0]);
        for (const auto& [end, guard] : again.ends) connect(end, guard, again.starts);
        return {again.starts, {}};
      }
      case Statement::Kind::each: {
        const LocationId self = add(parent);
        at(self).composite = true;
        for (const Statement& part : s.parts) {
          const Piece branch = composite(self, {}, part);
          at(branch.starts.front()).apart = at(branch.starts.front()).start = true;
        }
        return {{self}, {{self, {}}}};
      }
      case Statement::Kind::sequence: {
        Piece whole = piece(parent, s.parts[0]);
        for (std::size_t i = 1; i < s.parts.size(); ++i) {
          Piece after = piece(parent, s.parts[i]);
          for (const auto& [end, guard] : whole.ends) connect(end, guard, after.starts);
          whole.ends = std::move(after.ends);
        }
        return whole;
      }
      case Statement::Kind::parallel:
        return composite(parent, {}, s);
      case Statement::Kind::watching:
        return composite(parent, not_entailed, s.parts[0]);
      case Statement::Kind::maintaining:
        return composite(parent, entailed, s.parts[0]);
      case Statement::Kind::call:
        return definition(parent, s.callee);
      case Statement::Kind::if_then:
      case Statement::Kind::if_else:
      case Statement::Kind::unless:
      case Statement::Kind::when:
      case Statement::Kind::whenever:
      case Statement::Kind::always:
      case Statement::Kind::next:
        return headed(parent, s, entailed, not_entailed);
    }
    return {};
  }

  /// The constructs that begin with an empty location of their own.
  Piece headed(LocationId parent, const Statement& s, const Condition& entailed, const Condition& not_entailed) {
    const LocationId self = add(parent);
    Piece then = piece(parent, s.parts[0]);
    Piece whole{{self}, then.ends};
    switch (s.kind) {
      case Statement::Kind::if_then:
        connect(self, entailed, then.starts);
        whole.ends.emplace_back(self, not_entailed);
        break;
      case Statement::Kind::unless:
        connect(self, not_entailed, then.starts);
        whole.ends.emplace_back(self, entailed);
        break;
      case Statement::Kind::if_else: {
        connect(self, entailed, then.starts);
        const Piece otherwise = piece(parent, s.parts[1]);
        connect(self, not_entailed, otherwise.starts);
        append(whole.ends, otherwise.ends);
        break;
      }
      case Statement::Kind::when:
        connect(self, not_entailed, {self});
        connect(self, entailed, then.starts);
        break;
      case Statement::Kind::whenever:
        connect(self, {}, {self});
        connect(self, entailed, then.starts);
        whole.ends.clear();
        break;
      case Statement::Kind::always:
        connect(self, {}, {self});
        connect(self, {}, then.starts);
        append(whole.starts, then.starts);
        whole.ends.clear();
        break;
      case Statement::Kind::next:
        connect(self, {}, then.starts);
        break;
      case Statement::Kind::goal:
      case Statement::Kind::clock_start:
      case Statement::Kind::sequence:
      case Statement::Kind::parallel:
      case Statement::Kind::watching:
      case Statement::Kind::maintaining:
      case Statement::Kind::repeat:
      case Statement::Kind::nothing:
      case Statement::Kind::each:
      case Statement::Kind::call:
        CHECK(false);
    }
    return whole;
  }

  const Rmpl& source_;
  Program program_;
  ClockId own_{};  ///< of the definition that is being lowered
};

void add_callees(const Statement& s, std::set<std::size_t>& callees) {
  if (s.kind == Statement::Kind::call) callees.insert(s.callee);
  for (const Statement& part : s.parts) add_callees(part, callees);
}

}  // namespace

std::string name_of_definition(std::size_t position) { return "Definition" + std::to_string(position); }

std::string to_text(const Rmpl& source, const automata::Variables& variables) {
  std::set<std::size_t> called = {0};
  for (std::size_t i = 0; i < source.definitions.size(); ++i)
    if (called.contains(i)) add_callees(source.definitions[i], called);
  std::string result;
  for (std::size_t i : called)
    result += name_of_definition(i) + "() :: { " + (source.has_own[i] ? "clock own; " : "") +
              Printer(source, variables).text(source.definitions[i]) + " }\n";
  return result;
}

Program lower(const Rmpl& source, const automata::Variables& variables) { return Lowering(source, variables).lower(); }

}  // namespace rmpl::reference
