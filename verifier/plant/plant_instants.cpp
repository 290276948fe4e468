// What may happen at an instant in a plant.
// SPDX-License-Identifier: MIT
#include "verifier/plant/plant_instants.hpp"

#include <algorithm>

namespace rmpl::verifier {

PlantInstants::PlantInstants(Situations& situations, SituationId root, const Situation& here, std::size_t others,
                             const Zone& zone)
    : situations_(situations), root_(root), clocks_(here.live, others), zone_(zone) {}

const std::vector<ZoneBox>& PlantInstants::waits(std::uint64_t node) {
  const auto [at, fresh] = waits_.try_emplace(node);
  if (!fresh) return at->second;
  const auto there = situations_[SituationId(node)];
  for (const Box& box : there->waits) {
    // At its end a wait passes no more time.
    if (auto wait = clocks_.translated(box, 0, 1)) at->second.push_back(std::move(*wait));
  }
  // What would come where a fault is certain, only the budget leaves out.
  for (ZoneBox& faulty : certain_faults(there->faulty, clocks_, situations_.time())) {
    at->second.push_back(std::move(faulty));
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

const Instant* PlantInstants::step(std::uint64_t node, std::size_t number) {
  if (!situations_.time().is_dense()) return nullptr;
  auto& [from, moves, looked_at, found] = steps_[node];
  if (!from) {
    from = situations_[SituationId(node)];
    moves = situations_.moves(SituationId(node), late(*from));
  }
  // A step that is possible at no reading of the zone is none.
  const auto misses = [&](const ZoneBound& bound) {
    return zone_.upper(bound.clock) < bound.range.lower || zone_.lower(bound.clock) > bound.range.upper;
  };
  for (; found.size() <= number && looked_at < moves->size(); ++looked_at) {
    const JointStep& move = (*moves)[looked_at];
    if (move.faults > 0 || move.hold) continue;
    auto bounds = clocks_.translated(move.bounds, 0, 0);
    if (!bounds || std::any_of(bounds->begin(), bounds->end(), misses)) continue;
    found.push_back({move.target.value, static_cast<std::uint32_t>(looked_at), std::move(*bounds),
                     clocks_.restarted(from->modes, situations_[move.target]->modes), false});
  }
  return number < found.size() ? &found[number] : nullptr;
}

}  // namespace rmpl::verifier
