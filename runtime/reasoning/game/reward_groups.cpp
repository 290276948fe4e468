// Rewards, group by group: what is pursued beside what the goal needs (semantics 5).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "runtime/reasoning/game/sorted_sets.hpp"
#include "runtime/reasoning/game/strategist.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;

/// Whether some modes that the component can come to are worth more than others.
bool Strategist::has_rewards(ComponentId c, ModeId from) const {
  const auto& modes = step_.plant()[c].modes;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (graph_.leads(c, from, ModeId(m)) && modes[m].reward != modes[from.index()].reward) return true;
  }
  return false;
}

/// With what decides their steps, and with the parts of the goal; without the components that are taken.
Strategist::Group Strategist::reward_group(std::vector<ComponentId> components, std::vector<std::size_t> parts,
                                           const std::vector<ComponentId>& taken) {
  for (const std::size_t p : parts) components = joined(components, relevant_[p]);
  components = graph_.upstream(components);
  std::sort(components.begin(), components.end());
  std::erase_if(components, [&](ComponentId c) { return std::binary_search(taken.begin(), taken.end(), c); });
  return {.parts = std::move(parts), .components = std::move(components)};
}

/// Whether the group is small enough and has something to pursue that leaves the components alone that are taken, and
/// that rests on none of them. Where it touches what parts of the goal rest on, it keeps these.
bool Strategist::pursue(Group& group, const Modes& modes, const std::vector<ComponentId>& taken) {
  for (;;) {
    if (!is_small(group, modes)) return false;
    PlayedGame& played = game_of(group, modes);
    if (played.game->too_large() || meet(played.arena->context(), taken)) return false;
    if (!played.rewards) played.rewards = std::make_shared<GameRewards>(*played.game);
    const std::uint32_t start = *played.game->find(modes);
    const auto pursued = played.rewards->from(start);
    if (!pursued) return false;
    group.reward = PursuedReward{played.game, played.rewards, start, *pursued};
    const std::vector<ComponentId> more = follow(group, modes);
    if (meet(more, taken)) return false;
    std::vector<std::size_t> parts = group.parts;
    for (std::size_t p = 0; p < goal_.parts(); ++p) {
      if (meet(group.touched, relevant_[p]) && !meet(taken, relevant_[p])) insert(parts, p);
    }
    if (more.empty() && parts == group.parts) return true;
    group = reward_group(joined(group.components, more), std::move(parts), taken);
  }
}

std::vector<PursuedReward> Strategist::rewards(const Modes& modes, const Answer& answer, ControlAction& action) {
  if (holds_ || !answer.later.empty()) return {};
  std::vector<ComponentId> taken;
  std::vector<std::size_t> used;  // controls of the goal's groups, which these need for themselves
  const bool keeps = std::all_of(answer.groups.begin(), answer.groups.end(), [](const SolvedGame& g) {
    return g.decision().purpose == GameDecision::Purpose::keep;
  });
  for (const SolvedGame& group : answer.groups) {
    const std::uint32_t edge = group.decision().edge;
    const bool rests = edge == GameDecision::no_edge || edge == group.game->nodes()[group.start].first;
    // Ages that are known are not given up for a reward.
    const bool known = group.game->memory() == Game::Memory::ages && !group.game->is_fresh(group.start);
    if (keeps && rests && !known) continue;
    taken = joined(taken, group.part);
    used = joined(used, group.commanded);
  }
  std::vector<Group> groups;
  for (const ComponentId c : graph_.components()) {
    if (!has_rewards(c, modes[c.index()]) || std::binary_search(taken.begin(), taken.end(), c)) continue;
    const bool known = std::any_of(groups.begin(), groups.end(), [&](const Group& g) {
      return std::binary_search(g.components.begin(), g.components.end(), c);
    });
    if (known) continue;
    Group group = reward_group({c}, {}, taken);
    if (!pursue(group, modes, taken) || meet(group.commanded, used)) continue;
    // Groups that have to do with each other are one; where that one has no strategy, the earlier one goes first.
    for (std::size_t other = 0; other < groups.size();) {
      if (!touches(group, groups[other]) && !touches(groups[other], group) && !meet(group.parts, groups[other].parts)) {
        ++other;
        continue;
      }
      Group together = reward_group(joined(group.components, groups[other].components),
                                    joined(group.parts, groups[other].parts), taken);
      if (!pursue(together, modes, taken) || meet(together.commanded, used)) {
        group.reward.reset();
        break;
      }
      group = std::move(together);
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(other));
      other = 0;
    }
    if (group.reward) groups.push_back(std::move(group));
  }
  std::vector<PursuedReward> result;
  ControlAction with = action;
  for (Group& group : groups) {
    const PursuedReward& reward = *group.reward;
    const Game::Edge& edge = reward.game->edges()[reward.pursued.edge];
    const Arena& arena = reward.game->arena();
    const ControlAction& sent = arena.action(edge.action);
    const ControlAction& rest = arena.action(reward.game->edges()[reward.game->nodes()[reward.start].first].action);
    for (const std::size_t i : arena.controls()) {
      if (sent[i] != rest[i]) with[i] = sent[i];
    }
    result.push_back(*std::move(group.reward));
  }
  if (result.empty() || !step_.consistent(modes, with)) return {};
  action = std::move(with);
  return result;
}

}  // namespace rmpl::runtime
