// An automaton under construction: locations and arcs, of which some lead to a tail call's target before that is known.
//
// A construct becomes a fragment: the locations where it starts, and its ends, each a location with the guard under
// which the construct ends there. Locations are numbered as they are made, so each is made before what is inside it or
// follows from it: pre-order of the source.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "automata/program.hpp"
#include "grammar/ast/token.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// Where an arc leads, or a fragment starts: a location, or the starts of an expansion that is still open (a tail
/// call), known when it is closed.
struct Target {
  bool expansion = false;
  std::size_t index = 0;
};

inline Target target(automata::LocationId location) { return {false, location.index()}; }

struct End {
  automata::LocationId location;
  automata::Condition guard;
};

struct Fragment {
  std::vector<Target> starts;
  std::vector<End> ends;
};

/// Fills in the locations of a program. Calls multiply, so the draft counts what is made; beyond its limit that is
/// reported once, and the draft is not complete.
class Draft {
 public:
  /// `entry` names the program, for messages. Refers to its arguments.
  Draft(const grammar::Sources& sources, const grammar::Name& entry, automata::Program& program,
        grammar::Diagnostics& diagnostics)
      : sources_(sources), entry_(entry), program_(program), diagnostics_(diagnostics) {}

  automata::LocationId location(std::string label, grammar::Span span);
  automata::LocationId composite(std::string label, grammar::Span span, automata::Condition maintenance);
  automata::Location& operator[](automata::LocationId id) { return program_.locations[id.index()]; }

  /// Makes what `make` makes the inside of a composite. What is inside ends with the composite. What starts with it and
  /// is an expansion around it, as a call that leads back may be beside other threads, starts with the composite.
  template <class Make>
  Fragment inside(automata::LocationId composite, const Make& make) {
    parents_.push_back(composite);
    const Fragment inner = make();
    parents_.pop_back();
    mark_starts(inner);
    Fragment made{{target(composite)}, {{composite, {}}}};
    std::copy_if(inner.starts.begin(), inner.starts.end(), std::back_inserter(made.starts),
                 [](const Target& start) { return start.expansion; });
    return made;
  }

  void arc(automata::LocationId from, automata::Condition guard, Target to);
  void arcs(automata::LocationId from, const automata::Condition& guard, const std::vector<Target>& to);

  /// A new expansion, which targets may name from now on; and its starts, once they are known.
  std::size_t open_expansion();
  void close_expansion(std::size_t expansion, std::vector<Target> starts) { starts_[expansion] = std::move(starts); }

  /// Counts `more` locations, arcs or conditions.
  void grow(std::size_t more, grammar::Span blame);
  /// Reports why the rest is not looked at.
  void abandon(grammar::Code code, grammar::Span span, std::string reason);
  [[nodiscard]] bool complete() const { return complete_; }
  /// Where each location stands, for good.
  std::vector<grammar::Span> take_spans() { return std::move(spans_); }

  /// What was drawn becomes the arcs of the program, now that every expansion knows its starts.
  void connect();
  /// The locations that targets stand for, once all expansions are closed; each once, in their order.
  [[nodiscard]] std::vector<automata::LocationId> locations(const std::vector<Target>& targets) const;

 private:
  /// An arc whose target may still be an expansion.
  struct DraftArc {
    automata::Condition guard;
    Target target;
  };

  void mark_starts(const Fragment& inner);
  void add_locations(const Target& target, std::vector<automata::LocationId>& found) const;

  const grammar::Sources& sources_;
  const grammar::Name& entry_;
  automata::Program& program_;
  grammar::Diagnostics& diagnostics_;
  std::vector<std::vector<DraftArc>> arcs_;    ///< per location
  std::vector<grammar::Span> spans_;           ///< per location
  std::vector<automata::LocationId> parents_;  ///< the composites that are open, outermost first
  std::vector<std::vector<Target>> starts_;    ///< per expansion
  std::size_t size_ = 0;
  bool complete_ = true;
};

}  // namespace rmpl::compiler
