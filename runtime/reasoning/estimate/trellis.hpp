// A trellis: what states may follow each other, and the k most likely ways through all of them.
//
// Forward, the probability of the best way to each state (Viterbi; Forney 1973); backward, the k best sequences in
// order, by that as the exact remainder (Nilsson & Goldberger 2001, in the form of Soong & Huang).
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
  /// A step from a place in the last layer.
  struct Arrival {
    Number target;
    std::uint32_t from;
    double probability;
  };
  struct Path {
    double probability = 0;
    std::vector<Number> states;
  };

  /// No layer has more states.
  static constexpr std::size_t most = std::size_t{1} << 14;

  /// Begins anew with a belief.
  void begin(const std::vector<std::pair<Number, double>>& belief);
  /// The states at the last time, by place.
  [[nodiscard]] const std::vector<Number>& last() const { return layers_.back().states; }
  /// Works out the layer that follows; false where there is none. Throws TooManyStates.
  bool extend(std::vector<Arrival> arrivals);
  /// Takes what was worked out last; or lets every state stay as it was.
  void advance();
  void stand();
  /// The k most likely ways, best first, normalised over all; and some that are as good as the last of them as far as
  /// floating point can tell.
  [[nodiscard]] std::vector<Path> best(std::size_t k) const;

 private:
  struct Edge {
    std::uint32_t from;
    double probability;
  };
  struct Layer {
    std::vector<Number> states;
    std::vector<std::vector<Edge>> into;
    std::vector<double> sum;   ///< of all ways there, normalised
    std::vector<double> best;  ///< of the best way there, in the same unit
  };

  std::vector<Layer> layers_;
  Layer next_;
};

}  // namespace rmpl::runtime
