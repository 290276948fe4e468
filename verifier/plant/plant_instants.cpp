// What may happen at an instant in a plant.
// SPDX-License-Identifier: MIT
#include "verifier/plant/plant_instants.hpp"

#include <optional>

namespace rmpl::verifier {

PlantInstants::PlantInstants(Situations& situations, SituationId root, const Situation& here, std::size_t others,
                             const Zone& zone)
    : situations_(situations), root_(root), here_(here), clocks_(here.live, others), zone_(zone) {}

const std::vector<ZoneBox>& PlantInstants::waits(std::uint64_t node) {
  const auto [at, fresh] = waits_.try_emplace(node);
  if (!fresh) return at->second;
  std::optional<Situation> other;
  const Situation& there = SituationId(node) == root_ ? here_ : other.emplace(situations_[SituationId(node)]);
  for (const Box& box : there.waits) {
    // At its end a wait passes no more time.
    if (auto wait = clocks_.translated(box, 0, 1)) at->second.push_back(std::move(*wait));
  }
  // What would come where a fault is certain, only the budget leaves out.
  for (const ClockBound& bound : there.faulty) {
    const Units period = situations_.time().is_dense() ? 0 : 1;
    if (auto faulty = clocks_.translated({bound}, period, period)) at->second.push_back(std::move(*faulty));
  }
  if (!situations_.time().is_dense() && SituationId(node) == root_) add_periods(at->second);
  return at->second;
}

/// Where a period may end in a step, or in another wait under some command.
void PlantInstants::add_periods(std::vector<ZoneBox>& result) {
  const auto moves = situations_.moves(root_, {});
  for (const JointStep& move : *moves) {
    if (move.faults > 0) continue;
    if (auto box = clocks_.translated(move.bounds, move.hold ? 0 : 1, 1)) result.push_back(std::move(*box));
  }
}

Late PlantInstants::late(const Situation& there) const {
  Late result;
  for (std::size_t i = 0; i < there.live.size(); ++i) {
    const auto clock = clocks_.clock_of(there.live[i]);
    const Units reading = clock ? zone_.upper(*clock) : 0;
    if (there.stays_until[i] >= 0 && reading > there.stays_until[i]) result.push_back(there.live[i]);
  }
  return result;
}

const std::vector<Instant>& PlantInstants::steps(std::uint64_t node) {
  const auto [at, fresh] = steps_.try_emplace(node);
  if (!fresh || !situations_.time().is_dense()) return at->second;
  const Situation there = situations_[SituationId(node)];
  const auto moves = situations_.moves(SituationId(node), late(there));
  for (std::size_t m = 0; m < moves->size(); ++m) {
    const JointStep& move = (*moves)[m];
    if (move.faults > 0 || move.hold) continue;
    auto bounds = clocks_.translated(move.bounds, 0, 0);
    if (!bounds) continue;
    at->second.push_back({situations_.number(move.target).value, static_cast<std::uint32_t>(m), std::move(*bounds),
                          clocks_.restarted(there.modes, move.target), false});
  }
  return at->second;
}

}  // namespace rmpl::verifier
