// Runs without end, as strongly connected components of the symbolic graph.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/lasso.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::ModeId;

namespace {

using Index = std::uint32_t;
constexpr Index none = UINT32_MAX;

struct Edge {
  Index target;
  Label label;
};

struct Vertex {
  SymbolicState state;
  Index parent;
  Label label;  ///< from the parent
  std::vector<Edge> edges;
  Index exits;  ///< a position in `Graph::exits`
};

/// All that can be reached, breadth first.
class Graph {
 public:
  Graph(ProgramSystem& system, Loop& loop, Meter& meter) {
    system.initial([&](SymbolicState&& state, const Label& label) { add(std::move(state), none, label, meter); });
    for (Index v = 0; v < vertices.size(); ++v) {
      meter.poll();
      meter.at(vertices.size() - v);
      const SymbolicState state = vertices[v].state;
      vertices[v].exits = number(loop.turn(ProgramSystem::loop_state(state.discrete))->exits);
      system.successors(state, [&](SymbolicState&& next, const Label& label) {
        const Index target = add(std::move(next), v, label, meter);
        vertices[v].edges.push_back({target, label});
      });
    }
  }

  std::vector<Vertex> vertices;
  std::vector<const Exits*> exits;  ///< all that occur

 private:
  Index number(const Exits& one) {
    const auto [at, fresh] = numbers_.try_emplace(one, static_cast<Index>(exits.size()));
    if (fresh) exits.push_back(&at->first);
    return at->second;
  }

  Index add(SymbolicState&& state, Index parent, const Label& label, Meter& meter) {
    std::vector<Index>& known = by_discrete_[state.discrete];
    const auto equal = [&](Index k) {
      return vertices[k].state.faults == state.faults && vertices[k].state.zone == state.zone;
    };
    if (const auto at = std::find_if(known.begin(), known.end(), equal); at != known.end()) return *at;
    meter.count_state();
    known.push_back(static_cast<Index>(vertices.size()));
    vertices.push_back({std::move(state), parent, label, {}, 0});
    return known.back();
  }

  std::unordered_map<std::uint64_t, std::vector<Index>> by_discrete_;  ///< looked up, never iterated
  std::map<Exits, Index> numbers_;
};

/// Vertices, ascending.
using Part = std::vector<Index>;

/// The number of the component of each vertex, in the graph that the part leaves of the whole; `none` outside of it
/// (R. Tarjan, Depth-First Search and Linear Graph Algorithms, 1972), without recursion.
std::vector<Index> components_of(const std::vector<Vertex>& vertices, const Part& part, Index& count) {
  constexpr Index inside = none - 1;
  std::vector<Index> component(vertices.size(), none);
  for (const Index v : part) component[v] = inside;
  std::vector<Index> order(vertices.size(), none);
  std::vector<Index> low(vertices.size(), none);
  std::vector<Index> open;
  std::vector<std::pair<Index, std::size_t>> stack;  // a vertex, and the next of its edges
  Index visited = 0;
  count = 0;
  for (const Index root : part) {
    if (order[root] != none) continue;
    stack.emplace_back(root, 0);
    while (!stack.empty()) {
      auto& [v, next] = stack.back();
      if (next == 0) {
        order[v] = low[v] = visited++;
        open.push_back(v);
      }
      if (next < vertices[v].edges.size()) {
        const Index target = vertices[v].edges[next++].target;
        if (component[target] != inside) continue;
        if (order[target] == none) {
          stack.emplace_back(target, 0);
        } else {
          low[v] = std::min(low[v], order[target]);
        }
        continue;
      }
      if (low[v] == order[v]) {
        for (Index member = none; member != v;) {
          member = open.back();
          open.pop_back();
          component[member] = count;
        }
        ++count;
      }
      const Index done = v;
      stack.pop_back();
      if (!stack.empty()) low[stack.back().first] = std::min(low[stack.back().first], low[done]);
    }
  }
  return component;
}

class Lassos {
 public:
  Lassos(Graph& graph, Loop& loop, bool after_fault)
      : vertices_(graph.vertices), exits_(graph.exits), loop_(loop), after_fault_(after_fault) {}

  std::optional<Lasso> find() {
    Part all(vertices_.size());
    std::iota(all.begin(), all.end(), Index{0});
    parts_.push_back(std::move(all));
    // A part that holds no loop that can last may hold smaller ones: they are looked at in turn.
    while (!parts_.empty()) {
      const Part part = std::move(parts_.front());
      parts_.pop_front();
      if (auto found = find_in(part)) return found;
    }
    return std::nullopt;
  }

 private:
  /// An edge that a loop has to take, or one of its ends.
  using Duty = std::function<bool(Index source, const Edge& edge)>;

  std::optional<Lasso> find_in(const Part& part) {
    Index count = 0;
    component_ = components_of(vertices_, part, count);
    std::vector<Part> members(count);
    for (const Index v : part) members[component_[v]].push_back(v);
    // Vertices are in order of steps: the first one whose component will do is reached soonest.
    std::vector<bool> looked(count, false);
    for (const Index v : part) {
      const Index c = component_[v];
      if (looked[c]) continue;
      looked[c] = true;
      if (const auto duties = duties_of(members[c])) return lasso(v, *duties);
    }
    return std::nullopt;
  }

  [[nodiscard]] const LoopState& state(Index v) const {
    return loop_[ProgramSystem::loop_state(vertices_[v].state.discrete)];
  }

  [[nodiscard]] bool is_met(const Duty& duty, const Part& members) const {
    return std::any_of(members.begin(), members.end(), [&](Index v) {
      return std::any_of(vertices_[v].edges.begin(), vertices_[v].edges.end(),
                         [&](const Edge& edge) { return component_[edge.target] == component_[v] && duty(v, edge); });
    });
  }

  /// What a loop in the component must not leave out; nothing where no loop that goes everywhere in it can last. What
  /// may then still hold one is added to the parts.
  std::optional<std::vector<Duty>> duties_of(const Part& members) {
    if (after_fault_ && vertices_[members.front()].state.faults == 0) return std::nullopt;
    const bool dense = loop_.time().is_dense();
    std::vector<Duty> duties = {[this, dense](Index, const Edge& edge) {
      return !dense || ProgramSystem::progressed(vertices_[edge.target].state.discrete);
    }};
    if (!is_met(duties.front(), members)) return std::nullopt;
    for (std::size_t c = 0; c < loop_.plant().components.size(); ++c) {
      const std::vector<ModeId> open = open_exits(members, c);
      if (open.empty()) continue;
      duties.emplace_back([this, c, open](Index source, const Edge& edge) {
        return !common(enabled(source, c), open) || state(source).modes[c] != state(edge.target).modes[c];
      });
      if (is_met(duties.back(), members)) continue;
      split(members, c);
      return std::nullopt;
    }
    return duties;
  }

  [[nodiscard]] const std::vector<ModeId>& enabled(Index v, std::size_t component) const {
    return exits_[vertices_[v].exits]->enabled[component];
  }

  /// The exits of a component that can be taken somewhere along a loop that goes everywhere.
  [[nodiscard]] std::vector<ModeId> open_exits(const Part& members, std::size_t component) const {
    std::set<ModeId> open;
    for (const Index v : members) {
      const auto& here = exits_[vertices_[v].exits]->open[component];
      open.insert(here.begin(), here.end());
    }
    return {open.begin(), open.end()};
  }

  static bool common(const std::vector<ModeId>& a, const std::vector<ModeId>& b) {
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  }

  /// The component's exits are enabled everywhere, and can be taken somewhere. A smaller loop lasts only where it
  /// comes by some vertex whose exits can be taken nowhere on it.
  void split(const Part& members, std::size_t component) {
    std::set<std::vector<ModeId>> different;
    for (const Index v : members) different.insert(enabled(v, component));
    for (const auto& exits : different) {
      Part part;
      for (const Index v : members) {
        if (!common(exits_[vertices_[v].exits]->open[component], exits)) part.push_back(v);
      }
      const bool holds_one =
          std::any_of(part.begin(), part.end(), [&](Index v) { return enabled(v, component) == exits; });
      if (holds_one) parts_.push_back(std::move(part));
    }
  }

  [[nodiscard]] Lasso lasso(Index start, const std::vector<Duty>& duties) const {
    Lasso result;
    for (Index v = start; v != none; v = vertices_[v].parent) {
      result.path.push_back({vertices_[v].state.discrete, vertices_[v].label});
    }
    std::reverse(result.path.begin(), result.path.end());
    result.repeats_from = result.path.size() - 1;
    Index at = start;
    std::vector<bool> done(duties.size(), false);
    const auto walk = [&](const Duty& wanted) {
      for (const auto& [source, edge] : way(at, wanted)) {
        result.path.push_back({vertices_[edge.target].state.discrete, edge.label});
        for (std::size_t d = 0; d < duties.size(); ++d) done[d] = done[d] || duties[d](source, edge);
        at = edge.target;
      }
    };
    for (std::size_t d = 0; d < duties.size(); ++d) {
      if (!done[d]) walk(duties[d]);
    }
    if (at != start) walk([start](Index, const Edge& edge) { return edge.target == start; });
    return result;
  }

  /// The edges of a shortest way inside the component whose last edge is wanted.
  [[nodiscard]] std::vector<std::pair<Index, Edge>> way(Index from, const Duty& wanted) const {
    std::unordered_map<Index, std::pair<Index, Edge>> reached;
    std::deque<Index> queue{from};
    while (!queue.empty()) {
      const Index v = queue.front();
      queue.pop_front();
      for (const Edge& edge : vertices_[v].edges) {
        if (component_[edge.target] != component_[v]) continue;
        if (wanted(v, edge)) {
          std::vector<std::pair<Index, Edge>> result{{v, edge}};
          for (Index at = v; at != from; at = result.back().first) result.push_back(reached.at(at));
          std::reverse(result.begin(), result.end());
          return result;
        }
        if (edge.target != from && reached.try_emplace(edge.target, v, edge).second) queue.push_back(edge.target);
      }
    }
    throw base::InternalError("a component has no edge that it was found to have");
  }

  const std::vector<Vertex>& vertices_;
  const std::vector<const Exits*>& exits_;
  Loop& loop_;
  bool after_fault_;
  std::deque<Part> parts_;
  std::vector<Index> component_;
};

}  // namespace

std::optional<Lasso> find_lasso(ProgramSystem& system, Loop& loop, bool after_fault, Meter& meter) {
  Graph graph(system, loop, meter);
  return Lassos(graph, loop, after_fault).find();
}

}  // namespace rmpl::verifier
