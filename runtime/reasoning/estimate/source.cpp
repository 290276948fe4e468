// Sums over the clocks of a source.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/source.hpp"

#include <cmath>
#include <vector>

namespace rmpl::runtime {

double Source::following() const {
  double sum = 0;
  for (std::size_t e = 0; e < clocks.size(); ++e) {
    if (weight_of(e) > 0) sum += clocks[e].probability;
  }
  return sum;
}

double Source::greatest_worth() const {
  if (std::isinf(slack)) return slack;
  const double most = extensions->mass() * slack;
  if (varied.empty() || !extensions->informed()) return weight * most;
  const auto promise = [&](std::size_t component, const std::vector<double>& priors) {
    double sum = 0;
    for (std::size_t m = 0; m < priors.size(); ++m) {
      if (priors[m] > 0) sum += priors[m] * extensions->gain(component, automata::ModeId(m));
    }
    return sum;
  };
  std::vector<double> best;
  for (const std::size_t c : varied) best.push_back(promise(c, extensions->moves(c).priors()));
  double mass = 0;
  for (std::size_t e = 0; e < clocks.size(); ++e) {
    double own = weight_of(e) * most;
    for (std::size_t v = 0; v < varied.size(); ++v) {
      own *= promise(varied[v], moves[e * varied.size() + v]->priors()) / best[v];
    }
    mass += own;
  }
  return mass;
}

}  // namespace rmpl::runtime
