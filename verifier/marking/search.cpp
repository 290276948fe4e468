// A layer of nodes a step; parts of a step are multiplied out one way at a time, so that limits hold there too.
// SPDX-License-Identifier: MIT
#include "verifier/marking/search.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "base/product.hpp"

namespace rmpl::verifier {

using automata::Marking;
using automata::MarkingMoves;
using automata::MarkingOutcome;
using automata::MarkingStep;

namespace {

class Search {
 public:
  using Number = MarkingStep::Number;

  Search(MarkingStep& step, const std::vector<automata::Command>& free, const MarkingTarget& target, Meter& meter)
      : step_(step), free_(free), target_(target), meter_(meter) {
    const auto& controls = step.program().controls;
    for (const automata::Command& command : free) {
      std::uint64_t& off = off_idle_.emplace_back(0);
      for (std::size_t c = 0; c < command.size(); ++c) off += command[c] != controls[c].idle ? 1 : 0;
    }
  }

  MarkingFound run() {
    const MarkingMoves starts = step_.rules().initial();
    each_way(starts, target_.improbable, [&](Number marking, unsigned improbable) {
      add(marking, {marking, none, 0, improbable, 0});
      return false;
    });
    result_.startless = next_.empty() && !begins(starts);
    for (std::uint64_t steps = 0; !next_.empty(); ++steps) {
      take_over(steps);
      if (steps >= target_.first) {
        if (const auto found = accepted()) {
          tell(*found);
          break;
        }
      }
      if (target_.last && steps >= *target_.last) break;
      for (std::size_t n = 0; n < layer_.size(); ++n) {
        meter_.at_steps(steps, layer_.size() - n + next_.size());
        expand(layer_[n]);
      }
    }
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  struct Node {
    Number marking;
    std::uint32_t parent;
    std::uint32_t command;
    unsigned improbable;
    std::uint64_t commanded;  ///< values off idle until then

    [[nodiscard]] bool better(const Node& other) const {
      return improbable != other.improbable ? improbable < other.improbable : commanded < other.commanded;
    }
  };

  /// The consistent markings that some moves lead to with no more than so many improbable draws, up to one of which
  /// `visit` returns true. Whether there was one.
  template <class Visit>
  bool each_way(const MarkingMoves& moves, std::optional<unsigned> most, const Visit& visit) {
    std::vector<const MarkingOutcome*> taken;
    unsigned improbable = 0;
    const auto take = [&](std::size_t part, std::size_t way) {
      const MarkingOutcome& outcome = moves.parts[part][way];
      if (most && improbable + outcome.improbable > *most) {
        result_.cut = true;
        return false;
      }
      improbable += outcome.improbable;
      taken.push_back(&outcome);
      return true;
    };
    const auto put_back = [&](std::size_t, std::size_t) {
      improbable -= taken.back()->improbable;
      taken.pop_back();
    };
    return base::multiply_out(moves.parts, take, put_back, [&] {
      meter_.poll();
      const Number number = step_.number(united(moves, taken));
      return step_.possible(number) && visit(number, improbable);
    });
  }

  bool begins(const MarkingMoves& starts) {
    return each_way(starts, std::nullopt, [](Number, unsigned) { return true; });
  }

  void expand(std::uint32_t parent) {
    const Node node = nodes_[parent];
    const auto left = target_.improbable ? std::optional(*target_.improbable - node.improbable) : std::nullopt;
    bool goes_on = false;
    for (std::size_t c = 0; c < free_.size(); ++c) {
      step_.command(free_[c]);
      meter_.poll();
      if (!step_.permits(node.marking)) continue;
      each_way(step_.moves(node.marking), left, [&](Number marking, unsigned improbable) {
        goes_on = true;
        add(marking, {marking, parent, static_cast<std::uint32_t>(c), node.improbable + improbable,
                      node.commanded + off_idle_[c]});
        return false;
      });
    }
    if (!goes_on && !has_future(node.marking)) result_.stuck = true;
  }

  /// Whether any draws at all lead to a next marking.
  bool has_future(Number marking) {
    if (!target_.improbable) return false;  // all were tried
    return std::any_of(free_.begin(), free_.end(), [&](const automata::Command& command) {
      step_.command(command);
      return step_.permits(marking) && begins(step_.moves(marking));
    });
  }

  /// Into the next layer, where each marking stands once, with the fewest improbable draws, then the fewest commands:
  /// so a run holds no command that it does not need.
  void add(Number marking, const Node& node) {
    const auto known = least_.find(marking);
    if (known != least_.end() && (!target_.improbable || known->second <= node.improbable)) return;
    const auto [there, fresh] = in_next_.try_emplace(marking, static_cast<std::uint32_t>(nodes_.size()));
    if (fresh) {
      meter_.count_state();
      next_.push_back(there->second);
      nodes_.push_back(node);
    } else if (node.better(nodes_[there->second])) {
      nodes_[there->second] = node;
    }
  }

  void take_over(std::uint64_t steps) {
    layer_ = std::exchange(next_, {});
    in_next_.clear();
    if (steps < target_.first) return;  // what is left out before is not seen when it counts
    for (const std::uint32_t n : layer_) least_[nodes_[n].marking] = nodes_[n].improbable;
  }

  std::optional<std::uint32_t> accepted() {
    std::optional<std::uint32_t> best;
    for (const std::uint32_t n : layer_) {
      if (best && !nodes_[n].better(nodes_[*best])) continue;
      const auto [known, fresh] = accepts_.try_emplace(nodes_[n].marking, false);
      if (fresh) known->second = target_.accepts(step_[nodes_[n].marking]);
      if (known->second) best = n;
    }
    return best;
  }

  void tell(std::uint32_t node) {
    result_.improbable = nodes_[node].improbable;
    for (; node != none; node = nodes_[node].parent) {
      result_.path.push_back({step_[nodes_[node].marking], nodes_[node].command});
    }
    std::reverse(result_.path.begin(), result_.path.end());
  }

  MarkingStep& step_;
  const std::vector<automata::Command>& free_;
  const MarkingTarget& target_;
  Meter& meter_;
  MarkingFound result_;
  std::vector<std::uint64_t> off_idle_;  ///< by free command: how many of its values are
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> layer_, next_;
  // Looked up, never iterated.
  std::unordered_map<Number, std::uint32_t> in_next_;
  std::unordered_map<Number, unsigned> least_;  ///< improbable draws with which it was looked at, from `first` on
  std::unordered_map<Number, bool> accepts_;
};

}  // namespace

MarkingFound find_marking(MarkingStep& step, const std::vector<automata::Command>& free, const MarkingTarget& target,
                          Meter& meter) {
  return Search(step, free, target, meter).run();
}

}  // namespace rmpl::verifier
