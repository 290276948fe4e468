// Successors worked out by other threads.
// SPDX-License-Identifier: MIT
#include "verifier/search/lookahead.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "verifier/search/search.hpp"

namespace rmpl::verifier {
namespace {

/// Numbers n with steps to 2n + 1 and 2n + 2 below a bound. A copy numbers its states in the order in which it meets
/// them, as real ones do.
class Tree : public CopyableSystem {
 public:
  explicit Tree(std::uint32_t bound, std::uint32_t fails_at = UINT32_MAX) : bound_(bound), fails_at_(fails_at) {}

  void initial(const Visit& visit) override { visit({number({0}), 0, Zone(0)}, {}); }
  void successors(const SymbolicState& state, const Visit& visit) override {
    const std::uint32_t here = key(state.discrete)[0];
    if (here == fails_at_) throw std::runtime_error("no further");
    for (std::uint32_t move = 0; move < 2; ++move) {
      const std::uint32_t next = 2 * here + 1 + move;
      if (next < bound_) visit({number({next}), 0, Zone(0)}, {move, 0, false});
    }
  }
  [[nodiscard]] bool accepts(const SymbolicState& state) const override { return key(state.discrete)[0] + 1 == bound_; }
  [[nodiscard]] CopyableSystem* copyable() override { return this; }
  [[nodiscard]] std::unique_ptr<CopyableSystem> copy(const Limits& /*limits*/) const override {
    return std::make_unique<Tree>(bound_, fails_at_);
  }
  [[nodiscard]] Key key(std::uint64_t discrete) const override { return {met_[discrete]}; }
  [[nodiscard]] std::uint64_t number(const Key& key) override {
    const auto at = std::find(met_.begin(), met_.end(), key[0]);
    if (at == met_.end()) met_.push_back(key[0]);
    return static_cast<std::uint64_t>(std::find(met_.begin(), met_.end(), key[0]) - met_.begin());
  }

 private:
  std::uint32_t bound_, fails_at_;
  std::vector<std::uint32_t> met_;
};

/// All states in the order in which breadth-first search meets them.
std::vector<std::uint32_t> explored(Tree& tree, unsigned threads) {
  const Limits limits;
  Meter meter(limits);
  std::vector<std::uint32_t> order;
  std::deque<SymbolicState> queue;
  const auto visit = [&](SymbolicState&& state, const Label&) {
    order.push_back(tree.key(state.discrete)[0]);
    queue.push_back(std::move(state));
  };
  tree.initial(visit);
  Lookahead lookahead(tree, threads, meter);
  for (std::uint32_t node = 0; !queue.empty(); ++node) {
    if (lookahead.runs_dry()) {
      for (std::uint32_t i = 0; i < queue.size() && i < lookahead.window(); ++i) {
        if (!lookahead.knows(node + i)) lookahead.announce(node + i, queue[i]);
      }
      lookahead.begin();
    }
    const SymbolicState state = std::move(queue.front());
    queue.pop_front();
    if (order[node] % 7 == 3) {
      lookahead.forget(node);
    } else {
      lookahead.successors(node, state, visit);
    }
  }
  return order;
}

TEST(Lookahead, KeepsTheOrderWhateverTheThreads) {
  Tree alone(3000);
  const auto expected = explored(alone, 1);
  EXPECT_GT(expected.size(), 500u);
  for (const unsigned threads : {2u, 3u, 5u}) {
    Tree tree(3000);
    EXPECT_EQ(explored(tree, threads), expected) << threads << " threads";
  }
}

TEST(Lookahead, PassesOnWhatATwinThrows) {
  Tree whole(3000);
  const auto order = explored(whole, 1);
  const auto late = std::find_if(order.begin() + 300, order.end(), [](std::uint32_t n) { return n % 7 != 3; });
  for (const unsigned threads : {1u, 2u, 4u}) {
    Tree tree(3000, *late);
    EXPECT_THROW(explored(tree, threads), std::runtime_error);
  }
}

TEST(Lookahead, FindsTheSamePath) {
  const Limits limits;
  std::vector<std::uint32_t> moves[2];
  for (const unsigned threads : {1u, 3u}) {
    Tree tree(2000);
    Meter meter(limits);
    const auto path = find_path(tree, SearchOrder::fewest_steps, threads, meter);
    ASSERT_TRUE(path);
    for (const PathState& state : *path) moves[threads / 2].push_back(state.label.move);
  }
  EXPECT_EQ(moves[0], moves[1]);
}

}  // namespace
}  // namespace rmpl::verifier
