// Locations and arcs as they are made, and the arcs of the program at the end.
// SPDX-License-Identifier: MIT
#include "compiler/lower/draft.hpp"

#include <utility>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lower/part.hpp"

namespace rmpl::compiler {

using automata::Condition;
using automata::Location;
using automata::LocationId;
using grammar::Code;

namespace {

/// Locations, arcs and conditions of one program; calls multiply, and this is where it ends.
constexpr std::size_t draft_limit = 1'000'000;

}  // namespace

LocationId Draft::location(std::string label, grammar::Span span) {
  Location made;
  if (!parents_.empty()) made.parent = parents_.back();
  made.label = std::move(label);
  made.origin = origin_of(sources_, span);
  const LocationId id(program_.locations.size());
  program_.locations.push_back(std::move(made));
  arcs_.emplace_back();
  spans_.push_back(span);
  grow(1, span);
  return id;
}

LocationId Draft::composite(std::string label, grammar::Span span, Condition maintenance) {
  const LocationId id = location(std::move(label), span);
  Location& made = (*this)[id];
  made.composite = true;
  made.maintenance = std::move(maintenance);
  return id;
}

void Draft::mark_starts(const Fragment& inner) {
  for (const Target& start : inner.starts) {
    if (!start.expansion) program_.locations[start.index].start = true;
  }
}

void Draft::arc(LocationId from, Condition guard, Target to) {
  arcs_[from.index()].push_back({std::move(guard), to});
  grow(1, {});
}

void Draft::arcs(LocationId from, const Condition& guard, const std::vector<Target>& to) {
  for (const Target& one : to) arc(from, guard, one);
}

std::size_t Draft::open_expansion() {
  starts_.emplace_back();
  return starts_.size() - 1;
}

void Draft::grow(std::size_t more, grammar::Span blame) {
  size_ += more;
  if (size_ <= draft_limit || !complete_) return;
  abandon(Code::too_large, blame == grammar::Span{} ? entry_.span : blame,
          "program " + backquoted(entry_.text) + " grows beyond " + std::to_string(draft_limit) +
              " locations, arcs and conditions");
}

void Draft::abandon(Code code, grammar::Span span, std::string reason) {
  diagnostics_.error(code, span, std::move(reason));
  complete_ = false;
}

void Draft::add_locations(const Target& target, std::vector<LocationId>& found) const {
  if (!target.expansion) {
    const LocationId location(target.index);
    if (std::find(found.begin(), found.end(), location) == found.end()) found.push_back(location);
    return;
  }
  // Where a call starts with its caller, no way of such calls leads back: that is reported, and cut.
  for (const Target& start : starts_[target.index]) add_locations(start, found);
}

std::vector<LocationId> Draft::locations(const std::vector<Target>& targets) const {
  std::vector<LocationId> found;
  for (const Target& target : targets) add_locations(target, found);
  return found;
}

void Draft::connect() {
  for (std::size_t l = 0; l < arcs_.size() && complete_; ++l) {
    auto& arcs = program_.locations[l].arcs;
    for (DraftArc& draft : arcs_[l]) {
      if (!draft.target.expansion) {
        arcs.push_back({std::move(draft.guard), LocationId(draft.target.index)});
        continue;
      }
      for (const LocationId start : locations({draft.target})) {
        arcs.push_back({draft.guard, start});
        grow(1, {});
      }
    }
  }
}

}  // namespace rmpl::compiler
