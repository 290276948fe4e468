// Rows of numbers in boxes within boxes.
// SPDX-License-Identifier: MIT
#include "verifier/search/bounding_forest.hpp"

#include <algorithm>
#include <numeric>

namespace rmpl::verifier {
namespace {

constexpr std::size_t leaf = 16;

}  // namespace

/// Builds one tree.
class BoundingForest::Builder {
 public:
  Builder(std::vector<std::uint32_t> items, std::size_t width, Row row) : width_(width) {
    rows_.reserve(items.size() * width);
    std::vector<Units> one(width);
    for (const std::uint32_t item : items) {
      if (!row(item, one)) continue;
      items_.push_back(item);
      rows_.insert(rows_.end(), one.begin(), one.end());
    }
    order_.resize(items_.size());
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
  }

  Tree build() {
    if (!items_.empty()) divide(0, order_.size());
    for (const std::uint32_t i : order_) tree_.items.push_back(items_[i]);
    return std::move(tree_);
  }

 private:
  [[nodiscard]] Units entry(std::uint32_t i, std::size_t e) const { return rows_[i * width_ + e]; }

  void divide(std::size_t begin, std::size_t end) {
    const std::size_t branch = tree_.branches.size();
    tree_.branches.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), 0});
    const std::size_t corners = tree_.corners.size();
    tree_.corners.resize(corners + 2 * width_);
    Units* greatest = &tree_.corners[corners];
    Units* least = greatest + width_;
    std::copy_n(&rows_[order_[begin] * width_], width_, greatest);
    std::copy_n(greatest, width_, least);
    for (std::size_t i = begin + 1; i < end; ++i) {
      for (std::size_t e = 0; e < width_; ++e) {
        greatest[e] = std::max(greatest[e], entry(order_[i], e));
        least[e] = std::min(least[e], entry(order_[i], e));
      }
    }
    if (end - begin <= leaf) return;
    std::size_t widest = 0;
    // As unsigned numbers, so that the distance to an entry without a bound is no overflow.
    std::uint64_t spread = 0;
    for (std::size_t e = 0; e < width_; ++e) {
      const std::uint64_t own = static_cast<std::uint64_t>(greatest[e]) - static_cast<std::uint64_t>(least[e]);
      if (own <= spread) continue;
      spread = own;
      widest = e;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const auto first = order_.begin();
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(middle),
                     first + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t a, std::uint32_t b) {
                       return entry(a, widest) != entry(b, widest) ? entry(a, widest) < entry(b, widest) : a < b;
                     });
    divide(begin, middle);
    tree_.branches[branch].second = static_cast<std::uint32_t>(tree_.branches.size());
    divide(middle, end);
  }

  std::size_t width_;
  std::vector<std::uint32_t> items_;
  std::vector<Units> rows_;
  std::vector<std::uint32_t> order_;
  Tree tree_;
};

void BoundingForest::add(std::uint32_t item, Row row) {
  waiting_.push_back(item);
  if (waiting_.size() < leaf) return;
  std::vector<std::uint32_t> items = std::move(waiting_);
  waiting_.clear();
  std::size_t size = 0;
  for (; size < trees_.size() && !trees_[size].items.empty(); ++size) {
    items.insert(items.end(), trees_[size].items.begin(), trees_[size].items.end());
    trees_[size] = {};
  }
  if (size == trees_.size()) trees_.emplace_back();
  trees_[size] = Builder(std::move(items), width_, row).build();
}

bool BoundingForest::above(May may, Show show) const { return search(true, may, show); }
bool BoundingForest::below(May may, Show show) const { return search(false, may, show); }

bool BoundingForest::search(bool greatest, May may, Show show) const {
  if (std::any_of(waiting_.begin(), waiting_.end(), show)) return true;
  std::vector<std::uint32_t> open;
  // The last ones first: most of what comes is like what came last.
  for (const Tree& tree : trees_) {
    if (!tree.branches.empty()) open.push_back(0);
    while (!open.empty()) {
      const std::uint32_t b = open.back();
      open.pop_back();
      if (!may(&tree.corners[(2 * b + (greatest ? 0 : 1)) * width_])) continue;
      const Branch& branch = tree.branches[b];
      if (branch.second != 0) {
        open.push_back(b + 1);
        open.push_back(branch.second);
      } else if (std::any_of(tree.items.begin() + branch.begin, tree.items.begin() + branch.end, show)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace rmpl::verifier
