// A trellis: what states may follow each other, and the k most likely ways through all of them.
//
// Forward, the probability of the best way to each state (Viterbi; Forney 1973); backward, the k best sequences in
// order, by that as the exact remainder (Nilsson & Goldberger 2001, in the form of Soong & Huang). Between two layers
// there may be intermediate results, each of which a way passes once at most; where a step is a product of parts, there
// are far fewer edges with them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace rmpl::runtime {

class Trellis {
 public:
  using Number = std::uint32_t;  ///< of a state, given by the caller
  /// From a place in the last layer, or from an intermediate result behind these: the first has the number of states of
  /// the last layer.
  struct Edge {
    std::uint32_t from;
    double probability;
  };
  /// A step to a state.
  struct Arrival {
    Number target;
    std::uint32_t from;
    double probability;
  };
  struct Path {
    double probability = 0;
    std::vector<Number> states;
  };

  /// No layer has more states, and all of them together no more edges.
  static constexpr std::size_t most = std::size_t{1} << 16;
  static constexpr std::size_t most_edges = std::size_t{1} << 26;

  /// Begins anew with a belief.
  void begin(const std::vector<std::pair<Number, double>>& belief);
  /// The states at the last time, by place.
  [[nodiscard]] const std::vector<Number>& last() const { return layers_.back().states; }
  /// How many layers there are, and the states of one with the probability of all ways there, given all before.
  [[nodiscard]] std::size_t size() const { return layers_.size(); }
  [[nodiscard]] std::vector<std::pair<Number, double>> forward(std::size_t layer) const;
  /// Works out the layer that follows; false where there is none. `between`: what leads to each intermediate result,
  /// none of which comes before one that leads to it. Throws TooManyStates.
  bool extend(std::vector<Arrival> arrivals, const std::vector<std::vector<Edge>>& between = {});
  /// Takes what was worked out last; or lets every state stay as it was.
  void advance();
  void stand();
  /// The k most likely ways, best first, normalised over all; and some that are as good as the last of them as far as
  /// floating point can tell.
  [[nodiscard]] std::vector<Path> best(std::size_t k) const;

 private:
  struct Layer {
    std::vector<Number> states;
    /// By intermediate result, and behind these by state: where its edges end in `edges`, the sum of all ways there,
    /// normalised over the states, and the best one, in the same unit.
    std::vector<std::size_t> ends;
    std::vector<double> sum, best;
    std::vector<Edge> edges;

    [[nodiscard]] std::size_t between() const { return sum.size() - states.size(); }
  };
  void close(const Layer& last);

  std::vector<Layer> layers_;
  Layer next_;
  std::size_t edges_ = 0;
};

}  // namespace rmpl::runtime
