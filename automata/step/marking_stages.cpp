// Parts in order of the first location that they may mark: so the parts of one thread come at the same level, whatever
// the thread is in.
// SPDX-License-Identifier: MIT
#include "automata/step/marking_stages.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <string>

#include "base/hash.hpp"

namespace rmpl::automata {
namespace {

std::uint32_t first_location(const std::vector<MarkingOutcome>& part) {
  std::uint32_t first = std::numeric_limits<std::uint32_t>::max() - 1;
  for (const MarkingOutcome& outcome : part) {
    if (!outcome.marked.empty()) first = std::min(first, outcome.marked.front().value);
  }
  return first;
}

}  // namespace

std::size_t MarkingStages::Sequences::Hash::operator()(std::uint32_t number) const noexcept {
  std::uint64_t hash = base::hash_seed;
  for (const std::uint64_t word : (*all)[number]) hash = base::mix(hash, word);
  return hash;
}

bool MarkingStages::Sequences::Same::operator()(std::uint32_t a, std::uint32_t b) const noexcept {
  const auto first = (*all)[a], second = (*all)[b];
  return std::equal(first.begin(), first.end(), second.begin(), second.end());
}

std::span<const std::uint64_t> MarkingStages::Sequences::operator[](std::uint32_t number) const {
  const std::size_t begin = number == 0 ? 0 : ends_[number - 1];
  return {words_.data() + begin, ends_[number] - begin};
}

std::uint32_t MarkingStages::Sequences::number(std::span<const std::uint64_t> words) {
  const auto next = static_cast<std::uint32_t>(ends_.size());
  words_.insert(words_.end(), words.begin(), words.end());
  ends_.push_back(words_.size());
  const auto [known, fresh] = numbers_.insert(next);
  if (fresh) return next;
  ends_.pop_back();
  words_.resize(words_.size() - words.size());
  return *known;
}

void MarkingStages::Sequences::clear() {
  numbers_.clear();
  words_.clear();
  ends_.clear();
}

void MarkingStages::clear() {
  markings_.clear();
  part_words_.clear();
  keys_.clear();
  rest_keys_.clear();
  parts_.clear();
  rests_.clear();
  places_.clear();
  edges_.clear();
  begins_.clear();
}

MarkingStages::Place MarkingStages::place(std::span<const std::uint64_t> marked, std::uint32_t rest) {
  const std::uint32_t marking = markings_.number(marked);
  const std::uint64_t key = std::uint64_t{marking} << 32 | rest;
  const Place known = keys_.number({&key, 1});
  if (known < places_.size()) return known;
  if (places_.size() >= most_places) {
    throw TooManyOutcomes("the steps of one group of threads have more than " + std::to_string(most_places) +
                          " intermediate results");
  }
  places_.push_back({marking, rest});
  return known;
}

std::uint32_t MarkingStages::part(const std::vector<MarkingOutcome>& outcomes) {
  std::vector<std::uint64_t> words;
  for (const MarkingOutcome& outcome : outcomes) {
    words.push_back(std::bit_cast<std::uint64_t>(outcome.probability));
    words.push_back(outcome.marked.size());
    for (const LocationId l : outcome.marked) words.push_back(l.value);
  }
  const std::uint32_t number = part_words_.number(words);
  if (number == parts_.size()) parts_.push_back(outcomes);
  return number;
}

MarkingStages::Place MarkingStages::begin(MarkingStep::Number marking) {
  std::vector<Place>& known = begins_[step_.current_command()];
  if (known.size() <= marking) known.resize(std::max<std::size_t>(2 * known.size(), marking + 1), none);
  if (known[marking] != none) return known[marking];
  const MarkingMoves& moves = step_.moves(marking);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ordered;  // first location, part
  for (const auto& outcomes : moves.parts) ordered.emplace_back(first_location(outcomes), part(outcomes));
  std::sort(ordered.begin(), ordered.end());
  std::uint32_t rest = none;
  for (auto next = ordered.rbegin(); next != ordered.rend(); ++next) {
    const std::uint64_t key = std::uint64_t{next->second} << 32 | rest;
    const std::uint32_t number = rest_keys_.number({&key, 1});
    if (number == rests_.size()) rests_.push_back({next->second, rest, next->first});
    rest = number;
  }
  std::vector<std::uint64_t> certain;
  for (const LocationId l : moves.certain) certain.push_back(l.value);
  return known[marking] = place(certain, rest);
}

MarkingStep::Number MarkingStages::marking(Place place) {
  Marking marked;
  for (const std::uint64_t l : markings_[places_[place].marked]) marked.emplace_back(static_cast<std::uint32_t>(l));
  return step_.number(marked);
}

void MarkingStages::expand(Place from) {
  if (places_[from].edges != none) return;
  std::vector<Edge> found;
  if (const std::uint32_t rest = places_[from].rest; rest != none) {
    const auto span = markings_[places_[from].marked];
    const std::vector<std::uint64_t> before(span.begin(), span.end());
    std::vector<std::uint64_t> both, more;
    for (const MarkingOutcome& outcome : parts_[rests_[rest].part]) {
      if (!(outcome.probability > 0)) continue;
      more.clear();
      for (const LocationId l : outcome.marked) more.push_back(l.value);
      both.clear();
      std::merge(before.begin(), before.end(), more.begin(), more.end(), std::back_inserter(both));
      found.push_back({place(both, rests_[rest].behind), outcome.probability});
    }
  }
  places_[from].first = edges_.size();
  places_[from].edges = static_cast<std::uint32_t>(found.size());
  edges_.insert(edges_.end(), found.begin(), found.end());
}

}  // namespace rmpl::automata
