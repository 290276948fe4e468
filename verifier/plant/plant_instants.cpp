// What may happen at an instant in a plant.
// SPDX-License-Identifier: MIT
#include "verifier/plant/plant_instants.hpp"

#include <algorithm>

#include "verifier/behaviour/folds.hpp"

namespace rmpl::verifier {

PlantInstants::PlantInstants(Situations& situations, SituationId root, const Situation& here, std::size_t others,
                             const Zone& zone, Folds* folds, bool idle)
    : situations_(situations),
      root_(root),
      here_(here),
      others_(others),
      clocks_(here.live, others),
      zone_(zone),
      folds_(folds != nullptr && !folds->in(here.modes).empty() ? folds : nullptr),
      idle_(idle) {}

bool PlantInstants::asks(std::uint64_t node) {
  if (folds_ == nullptr || asked_ || SituationId(node) == root_) return asked_.has_value();
  asked_ = folds_->asked_of(situations_.modes(SituationId(node)), here_.modes, others_, zone_);
  return asked_.has_value();
}

const std::vector<ZoneBox>& PlantInstants::waits(std::uint64_t node) {
  const auto [at, fresh] = waits_.try_emplace(node);
  if (!fresh || asks(node)) return at->second;
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
  const auto moves = situations_.moves(root_, {}, 0);
  for (const JointStep& move : *moves) {
    if (move.faults > 0 || (idle_ && !Situations::is_idle(move))) continue;
    if (auto box = clocks_.translated(move.bounds, move.hold ? 0 : 1, 1)) result.push_back(std::move(*box));
  }
}

Late PlantInstants::late(const Situation& there, bool always) const {
  Late result;
  for (std::size_t i = 0; i < there.live.size(); ++i) {
    const auto clock = clocks_.clock_of(there.live[i]);
    const Units reading = !clock ? 0 : always ? zone_.lower(*clock) : zone_.upper(*clock);
    if (there.stays_until[i] >= 0 && reading >= there.stays_until[i]) result.push_back(there.live[i]);
  }
  return result;
}

const Instant* PlantInstants::step(std::uint64_t node, std::size_t number) {
  if (!situations_.time().is_dense() || asked_) return nullptr;
  auto& [from, moves, looked_at, found] = steps_[node];
  if (!from) {
    from = situations_[SituationId(node)];
    moves = situations_.moves(SituationId(node), late(*from, false), 0, late(*from, true));
  }
  // A step that is possible at no reading of the zone is none.
  const auto misses = [&](const ZoneBound& bound) { return !zone_.meets(bound.clock, bound.range); };
  // Untimed exits take a cycle that begins now.
  const bool at_bound = SituationId(node) == root_ && !from->waits.empty();
  for (; found.size() <= number && looked_at < moves->size(); ++looked_at) {
    const JointStep& move = (*moves)[looked_at];
    if (move.faults > 0 || move.hold || (idle_ && !Situations::is_idle(move))) continue;
    auto bounds = clocks_.lasting(move.bounds, at_bound);
    if (!bounds || std::any_of(bounds->begin(), bounds->end(), misses)) continue;
    const auto there = situations_[move.target];
    Instant taken{move.target.value, static_cast<std::uint32_t>(looked_at), std::move(*bounds),
                  clocks_.restarted(from->modes, there->modes, move.restarted), false};
    if (there->modes != from->modes) {
      found.push_back(std::move(taken));
    } else {
      clocks_.add_restarts(taken, move.restarted, [&all = found](Instant&& one) { all.push_back(std::move(one)); });
    }
  }
  return number < found.size() ? &found[number] : nullptr;
}

}  // namespace rmpl::verifier
