// Steps of a model program, part by part: many markings whose steps are products of parts lead to many others in few
// edges, as steps that have the same parts to come, and have marked the same, go on together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "automata/step/marking_step.hpp"

namespace rmpl::automata {

/// K threads of n values each take K n^(K+1) edges so, and n^2K where every step is multiplied out. A graph without
/// circles, over all markings that were asked about. Keeps a reference to the step; not for two threads at once.
class MarkingStages {
 public:
  using Place = std::uint32_t;
  struct Edge {
    Place to;
    double probability;
  };

  /// So many places are kept at most: some hundred bytes each.
  static constexpr std::size_t most_places = std::size_t{1} << 21;

  explicit MarkingStages(MarkingStep& step) : step_(step) {}

  /// Where the step out of a marking begins that the step's command permits.
  Place begin(MarkingStep::Number marking);
  /// Whether all parts have turned out, and what is marked then, consistent or not.
  [[nodiscard]] bool ended(Place place) const { return places_[place].rest == none; }
  MarkingStep::Number marking(Place place);

  /// Calls `visit(place, edges)` for each place that is reached from some, before all that it leads to; in the same
  /// order whatever was asked before. An ended place has no edges. Throws TooManyOutcomes where there are more than
  /// `most_places`.
  template <class Visit>
  void for_each_reached(const std::vector<Place>& from, const Visit& visit) {
    std::map<std::uint32_t, std::vector<Place>> open;  // by level
    ++pass_;
    const auto add = [&](Place place) {
      if (std::exchange(places_[place].pass, pass_) != pass_) open[level(place)].push_back(place);
    };
    for (const Place place : from) add(place);
    while (!open.empty()) {
      const std::vector<Place> now = std::move(open.begin()->second);
      open.erase(open.begin());
      for (const Place place : now) {
        expand(place);
        const std::span<const Edge> edges(edges_.data() + places_[place].first, places_[place].edges);
        visit(place, edges);
        for (const Edge& edge : edges) add(edge.to);
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return places_.size(); }
  /// Lets go of all. To be called where the step has given new numbers.
  void clear();
  /// The same where more than half of what there is room for is used.
  void clear_where_full() {
    if (places_.size() > most_places / 2) clear();
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Sequences of words, each once, by number.
  class Sequences {
   public:
    Sequences() : numbers_(0, Hash{this}, Same{this}) {}
    Sequences(const Sequences&) = delete;
    Sequences& operator=(const Sequences&) = delete;
    std::uint32_t number(std::span<const std::uint64_t> words);
    [[nodiscard]] std::span<const std::uint64_t> operator[](std::uint32_t number) const;
    void clear();

   private:
    struct Hash {
      const Sequences* all;
      std::size_t operator()(std::uint32_t number) const noexcept;
    };
    struct Same {
      const Sequences* all;
      bool operator()(std::uint32_t a, std::uint32_t b) const noexcept;
    };
    std::vector<std::uint64_t> words_;
    std::vector<std::size_t> ends_;
    std::unordered_set<std::uint32_t, Hash, Same> numbers_;  ///< looked up, never iterated
  };
  struct Node {
    std::uint32_t marked;  ///< a sequence of locations
    std::uint32_t rest;    ///< of `rests_`; none: it has ended
    std::uint32_t edges = none;
    std::size_t first = 0;
    std::uint64_t pass = 0;
  };
  /// Parts to come: the next one, and what follows.
  struct Rest {
    std::uint32_t part, behind, level;
  };

  [[nodiscard]] std::uint32_t level(Place place) const {
    return places_[place].rest == none ? none : rests_[places_[place].rest].level;
  }
  Place place(std::span<const std::uint64_t> marked, std::uint32_t rest);
  std::uint32_t part(const std::vector<MarkingOutcome>& outcomes);
  void expand(Place place);

  MarkingStep& step_;
  Sequences markings_, part_words_, keys_;  ///< keys: of places, as `places_`; of rests, in `rest_keys_`
  Sequences rest_keys_;
  std::vector<std::vector<MarkingOutcome>> parts_;
  std::vector<Rest> rests_;
  std::vector<Node> places_;
  std::vector<Edge> edges_;
  std::map<Command, std::vector<Place>> begins_;  ///< by marking; none where it was not asked for
  std::uint64_t pass_ = 0;
};

}  // namespace rmpl::automata
