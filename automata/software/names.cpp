// Labels made identifiers, and told apart.
// SPDX-License-Identifier: MIT
#include "automata/software/names.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <string_view>

namespace rmpl::automata {
namespace {

constexpr std::size_t most_parts = 3;

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string identifier(std::string_view label) {
  std::string result;
  for (const char c : label) {
    if (is_letter(c)) {
      result += c;
    } else if (!result.empty() && result.back() != '_') {
      result += '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  return result;
}

/// Whether a composite is the call of a definition: `Reporting(valid)`.
bool is_call(const ModelLocation& location) {
  const std::size_t open = location.label.find('(');
  return location.composite && open != std::string::npos && open > 0 &&
         std::all_of(location.label.begin(), location.label.begin() + static_cast<std::ptrdiff_t>(open), is_letter);
}

std::optional<LocationId> call_around(const ModelProgram& program, LocationId location) {
  std::optional<LocationId> at = location;
  while (at && !is_call(program.locations[at->index()])) at = program.locations[at->index()].parent;
  return at;
}

bool is_within(const ModelProgram& program, LocationId location, LocationId composite) {
  for (std::optional<LocationId> at = location; at; at = program.locations[at->index()].parent) {
    if (*at == composite) return true;
  }
  return false;
}

void append(std::string& name, const std::string& part) {
  if (part.empty()) return;
  if (!name.empty()) name += '_';
  name += part;
}

std::string by_what_it_tells(const ModelProgram& program, const Marking& marking) {
  std::string name;
  std::size_t parts = 0;
  for (const LocationId l : marking) {
    const ModelLocation& location = program.locations[l.index()];
    if (!location.told.is_true() && parts++ < most_parts) append(name, identifier(location.label));
  }
  return name;
}

/// Those that stand more than once, with numbers from 2 on behind the first.
void number(std::vector<std::string>& names) {
  std::set<std::string> taken(names.begin(), names.end());
  std::set<std::string> met;
  for (std::string& name : names) {
    if (met.insert(name).second) continue;
    std::size_t next = 2;
    while (taken.contains(name + '_' + std::to_string(next))) ++next;
    name += '_' + std::to_string(next);
    taken.insert(name);
    met.insert(name);
  }
}

}  // namespace

std::string name_of(const ModelProgram& program, const Marking& marking) {
  if (marking.empty()) return "ended";
  std::set<LocationId> calls;
  for (const LocationId l : marking) {
    if (const auto call = call_around(program, l)) calls.insert(*call);
  }
  std::string name;
  std::size_t parts = 0;
  for (const LocationId call : calls) {
    const bool holds_another = std::any_of(
        calls.begin(), calls.end(), [&](LocationId other) { return other != call && is_within(program, other, call); });
    if (!holds_another && parts++ < most_parts) append(name, identifier(program.locations[call.index()].label));
  }
  return name.empty() ? "marked" : name;
}

std::vector<std::string> names_of_markings(const ModelProgram& program, const Thread& thread) {
  std::vector<std::string> names;
  names.reserve(thread.markings.size());
  std::multiset<std::string> all;
  for (const ThreadMarking& marking : thread.markings) {
    names.push_back(name_of(program, marking.marked));
    all.insert(names.back());
  }
  for (std::size_t m = 0; m < names.size(); ++m) {
    if (all.count(names[m]) > 1) append(names[m], by_what_it_tells(program, thread.markings[m].marked));
  }
  number(names);
  return names;
}

std::vector<std::string> names_of_threads(const ModelProgram& program, const std::vector<Thread>& threads,
                                          const std::string& instance, const Variables& variables) {
  const bool alone = instance.empty();
  const std::string& whole = alone ? program.name : instance;
  if (threads.size() == 1 && !variables.find(whole)) return {whole};
  std::vector<std::string> names;
  names.reserve(threads.size());
  for (const Thread& thread : threads) {
    const std::string part = identifier(program.locations[thread.first.index()].label);
    names.push_back((alone ? "" : instance + '.') + (part.empty() ? "thread" : part));
    while (variables.find(names.back())) names.back() += '_';
  }
  number(names);
  return names;
}

}  // namespace rmpl::automata
