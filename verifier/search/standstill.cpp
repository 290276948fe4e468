// Timelocks: searches the steps of one instant for a state in which time can pass.
// SPDX-License-Identifier: MIT
#include "verifier/search/standstill.hpp"

#include <algorithm>
#include <map>

namespace rmpl::verifier {
namespace {

enum class Truth { no, unknown, yes };

class Finder {
 public:
  Finder(std::uint64_t root, Instants& instants) : root_(root), instants_(instants) {}

  std::optional<Standstill> find(const Zone& zone) {
    undecided_.reset();
    if (passes(zone, root_)) return std::nullopt;
    if (undecided_) return halves(zone, *undecided_);
    const bool stopped = explore(zone);
    if (!stopped) return std::nullopt;
    if (undecided_) return halves(zone, *undecided_);
    if (taken_.at(root_).empty()) return Standstill{zone, {}, 0};
    const bool dead_end = std::any_of(taken_.begin(), taken_.end(), [](const auto& t) { return t.second.empty(); });
    if (dead_end) return std::nullopt;
    return round(zone);
  }

 private:
  /// The zone on either side of a bound, and within.
  std::optional<Standstill> halves(const Zone& zone, const ZoneBound bound) {
    const auto& [lower, upper] = bound.range;
    std::vector<Interval> parts = {bound.range};
    if (lower > 0) parts.push_back({0, lower - 1});
    if (upper != unbounded) parts.push_back({upper + 1, unbounded});
    for (const Interval& part : parts) {
      Zone smaller = zone;
      if (!smaller.constrain(bound.clock, part)) continue;
      if (auto found = find(smaller)) return found;
    }
    return std::nullopt;
  }

  /// Whether all readings are within the bounds, or none; the first bound that tells some apart is kept.
  Truth decide(const Zone& zone, const ZoneBox& box) {
    Truth result = Truth::yes;
    const ZoneBound* open = nullptr;
    for (const ZoneBound& b : box) {
      if (!zone.meets(b.clock, b.range)) return Truth::no;
      const Units least = zone.lower(b.clock);
      const Units most = zone.upper(b.clock);
      if (least >= b.range.lower && (b.range.upper == unbounded || most <= b.range.upper)) continue;
      result = Truth::unknown;
      if (open == nullptr) open = &b;
    }
    if (open != nullptr && !undecided_) undecided_ = *open;
    return result;
  }

  bool passes(const Zone& zone, std::uint64_t node) {
    for (const ZoneBox& box : instants_.waits(node)) {
      if (decide(zone, box) == Truth::yes) return true;
    }
    return false;
  }

  /// All that steps lead to which can be taken whatever the readings; false where time passes there, or where it leads
  /// on. That is mostly seen a step away, and else at the end of a few steps: depth first, looking one step ahead.
  bool explore(const Zone& zone) {
    taken_.clear();
    std::vector<std::uint64_t> open{root_};
    taken_[root_];
    while (!open.empty()) {
      const std::uint64_t node = open.back();
      open.pop_back();
      for (std::size_t i = 0; const Instant* step = instants_.step(node, i); ++i) {
        if (decide(zone, step->bounds) != Truth::yes) continue;
        if (step->leads_on || starts_anew(zone, *step)) return false;
        if (taken_.try_emplace(step->target).second) {
          if (passes(zone, step->target)) return false;
          open.push_back(step->target);
        }
        taken_[node].push_back(step);
      }
      // What is open is told apart before going on, as all there is further on may be open for the same reason.
      if (undecided_) return true;
    }
    return true;
  }

  bool starts_anew(const Zone& zone, const Instant& step) {
    for (const std::size_t clock : step.restarts) {
      if (decide(zone, {{clock, {1, unbounded}}}) == Truth::yes) return true;
    }
    return false;
  }

  Standstill round(const Zone& zone) const {
    Standstill result{zone, {}, 0};
    std::map<std::uint64_t, std::size_t> met;
    for (std::uint64_t at = root_; met.try_emplace(at, result.round.size()).second;) {
      result.round.push_back(*taken_.at(at).front());
      at = result.round.back().target;
      if (const auto before = met.find(at); before != met.end()) result.repeats_from = before->second;
    }
    return result;
  }

  std::uint64_t root_;
  Instants& instants_;
  std::optional<ZoneBound> undecided_;
  std::map<std::uint64_t, std::vector<const Instant*>> taken_;  ///< per node the steps out of it
};

}  // namespace

std::optional<Standstill> find_standstill(const Zone& zone, std::uint64_t node, Instants& instants) {
  return Finder(node, instants).find(zone);
}

}  // namespace rmpl::verifier
