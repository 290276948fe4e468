// Shares of possible outcomes, backward over the stages of a step.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking/marking_shares.hpp"

#include <cstddef>
#include <span>

namespace rmpl::runtime {

using automata::MarkingStages;

std::vector<double> possible_shares(MarkingStages& stages, automata::MarkingStep& step,
                                    const std::vector<MarkingStages::Place>& begins) {
  struct Visited {
    MarkingStages::Place place;
    std::size_t first;
  };
  std::vector<Visited> order;
  std::vector<MarkingStages::Edge> edges;
  stages.for_each_reached(begins, [&](MarkingStages::Place place, std::span<const MarkingStages::Edge> own) {
    order.push_back({place, edges.size()});
    edges.insert(edges.end(), own.begin(), own.end());
  });
  std::vector<double> share(stages.size(), 0.0);
  std::size_t end = edges.size();
  for (std::size_t i = order.size(); i-- > 0; end = order[i].first) {
    const MarkingStages::Place place = order[i].place;
    double& own = share[place];
    if (stages.ended(place)) own = step.possible(stages.marking(place)) ? 1 : 0;
    for (std::size_t e = order[i].first; e < end; ++e) own += edges[e].probability * share[edges[e].to];
  }
  std::vector<double> result;
  result.reserve(begins.size());
  for (const MarkingStages::Place place : begins) result.push_back(share[place]);
  return result;
}

}  // namespace rmpl::runtime
