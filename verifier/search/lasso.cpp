// Runs without end, as strongly connected components of the symbolic graph.
// SPDX-License-Identifier: MIT
#include "verifier/search/lasso.hpp"

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
using automata::Modes;

namespace {

using Index = std::uint32_t;
constexpr Index none = UINT32_MAX;

struct Edge {
  Index source;
  Index target;
  Label label;
  bool time;
  Index step;  ///< a position in `Graph::exits`, or `none`
  Index wait;  ///< another one
  std::vector<automata::ComponentId> restarted;
};

struct Vertex {
  SymbolicState state;
  Index parent;
  Label label;  ///< from the parent
  Index modes;  ///< a position in `Graph::modes`
  bool counts;
  std::vector<Index> edges;  ///< out of it
};

/// The positions of different values, in the order in which they came up.
template <class Value>
class Table {
 public:
  Index number(const Value& value) {
    const auto [at, fresh] = numbers_.try_emplace(value, static_cast<Index>(values_.size()));
    if (fresh) values_.push_back(&at->first);
    return at->second;
  }
  const Value& operator[](Index at) const { return *values_[at]; }

 private:
  std::map<Value, Index> numbers_;
  std::vector<const Value*> values_;
};

/// All that can be reached, breadth first.
class Graph {
 public:
  Graph(Runs& runs, Meter& meter) : runs_(runs), meter_(meter) {
    TransitionSystem& system = runs.system();
    system.initial([&](SymbolicState&& state, const Label& label) { add(std::move(state), none, label); });
    for (Index v = 0; v < vertices.size(); ++v) {
      meter.poll();
      meter.at(vertices.size() - v);
      const SymbolicState state = vertices[v].state;
      meter.used_faults(system.fault_count(state.faults));
      last_ = nullptr;
      system.successors(state, [&](SymbolicState&& next, const Label& label) {
        Runs::Passage passage = runs.passage(state, next, label);
        const Index target = add(std::move(next), v, label);
        vertices[v].edges.push_back(static_cast<Index>(edges.size()));
        edges.push_back(
            {v, target, label, passage.time, number(passage.step), number(passage.wait), std::move(passage.restarted)});
      });
    }
  }

  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  Table<Exits> exits;
  Table<Modes> modes;

 private:
  /// Steps out of one state mostly have the same.
  Index number(const Exits* some) {
    if (some == nullptr) return none;
    if (some != last_) last_number_ = exits.number(*some);
    last_ = some;
    return last_number_;
  }

  Index add(SymbolicState&& state, Index parent, const Label& label) {
    std::vector<Index>& known = by_hash_[hash_of(state)];
    const auto equal = [&](Index k) {
      const SymbolicState& other = vertices[k].state;
      return other.discrete == state.discrete && other.faults == state.faults && other.zone == state.zone;
    };
    if (const auto at = std::find_if(known.begin(), known.end(), equal); at != known.end()) return *at;
    meter_.count_state();
    known.push_back(static_cast<Index>(vertices.size()));
    const Index place = modes.number(runs_.modes(state.discrete));
    const bool counts = runs_.counts(state);
    vertices.push_back({std::move(state), parent, label, place, counts, {}});
    return known.back();
  }

  Runs& runs_;
  Meter& meter_;
  std::unordered_map<std::uint64_t, std::vector<Index>> by_hash_;  ///< looked up, never iterated
  const Exits* last_ = nullptr;                                    ///< of the state that is explored
  Index last_number_ = none;
};

/// Edges, ascending: of those that are in one loop or several.
using Vertices = std::vector<Index>;

/// The number of the component of each vertex in the graph of these edges; `none` for what no edge begins or ends in
/// (R. Tarjan, Depth-First Search and Linear Graph Algorithms, 1972), without recursion.
std::vector<Index> components_of(const Graph& graph, const Vertices& part, Index& count) {
  constexpr Index inside = none - 1;
  std::vector<Index> component(graph.vertices.size(), none);
  std::vector<bool> taken(graph.edges.size(), false);
  std::vector<Index> roots;
  for (const Index e : part) {
    taken[e] = true;
    for (const Index v : {graph.edges[e].source, graph.edges[e].target}) {
      if (component[v] == none) roots.push_back(v);
      component[v] = inside;
    }
  }
  std::sort(roots.begin(), roots.end());
  std::vector<Index> order(graph.vertices.size(), none);
  std::vector<Index> low(graph.vertices.size(), none);
  std::vector<Index> open;
  std::vector<std::pair<Index, std::size_t>> stack;  // a vertex, and the next of its edges
  Index visited = 0;
  count = 0;
  for (const Index root : roots) {
    if (order[root] != none) continue;
    stack.emplace_back(root, 0);
    while (!stack.empty()) {
      auto& [v, next] = stack.back();
      if (next == 0) {
        order[v] = low[v] = visited++;
        open.push_back(v);
      }
      if (next < graph.vertices[v].edges.size()) {
        const Index edge = graph.vertices[v].edges[next++];
        const Index target = graph.edges[edge].target;
        if (!taken[edge] || component[target] != inside) continue;
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
  explicit Lassos(const Graph& graph) : graph_(graph) {}

  std::optional<Lasso> find() {
    Vertices all;
    for (Index e = 0; e < graph_.edges.size(); ++e) {
      if (graph_.vertices[graph_.edges[e].source].counts && graph_.vertices[graph_.edges[e].target].counts) {
        all.push_back(e);
      }
    }
    parts_.push_back(std::move(all));
    // A part that holds no loop that can last may hold smaller ones: they are looked at in turn.
    while (!parts_.empty()) {
      const Vertices part = std::move(parts_.front());
      parts_.pop_front();
      if (auto found = find_in(part)) return found;
    }
    return std::nullopt;
  }

 private:
  /// What some edge of a loop has to be.
  using Duty = std::function<bool(const Edge& edge)>;

  std::optional<Lasso> find_in(const Vertices& part) {
    Index count = 0;
    const std::vector<Index> component = components_of(graph_, part, count);
    std::vector<Vertices> loops(count);
    for (const Index e : part) {
      const Index c = component[graph_.edges[e].source];
      if (c == component[graph_.edges[e].target]) loops[c].push_back(e);
    }
    // Vertices are in order of steps, and edges in that of their sources: the first loop that will do is reached
    // soonest.
    std::vector<bool> looked(count, false);
    for (const Index e : part) {
      const Index c = component[graph_.edges[e].source];
      if (looked[c] || loops[c].empty()) continue;
      looked[c] = true;
      const auto duties = duties_of(loops[c]);
      if (duties) return lasso(loops[c], *duties);
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_met(const Duty& duty, const Vertices& loop) const {
    return std::any_of(loop.begin(), loop.end(), [&](Index e) { return duty(graph_.edges[e]); });
  }

  /// What must be met in a loop; nothing where no loop that takes all of these edges can last. What may then still hold
  /// one is added to the parts.
  std::optional<std::vector<Duty>> duties_of(const Vertices& loop) {
    std::vector<Duty> duties = {[](const Edge& edge) { return edge.time; }};
    if (!is_met(duties.front(), loop)) return std::nullopt;
    const std::size_t components = modes_at(graph_.edges[loop.front()].source).size();
    for (std::size_t c = 0; c < components; ++c) {
      const std::vector<ModeId> open = open_exits(loop, c);
      if (open.empty()) continue;
      duties.emplace_back([this, c, open](const Edge& edge) {
        const auto& anew = edge.restarted;
        return modes_at(edge.source)[c] != modes_at(edge.target)[c] ||
               std::find(anew.begin(), anew.end(), automata::ComponentId(c)) != anew.end() || is_patient(edge, c, open);
      });
      if (is_met(duties.back(), loop)) continue;
      split(loop, c);
      return std::nullopt;
    }
    return duties;
  }

  [[nodiscard]] const Modes& modes_at(Index v) const { return graph_.modes[graph_.vertices[v].modes]; }

  /// What is enabled, and then open, on an edge: in its step, and while time passes before it.
  template <class Visit>
  void for_each_exits(const Edge& edge, const Visit& visit) const {
    if (edge.step != none) visit(graph_.exits[edge.step]);
    if (edge.wait != none) visit(graph_.exits[edge.wait]);
  }

  /// Whether somewhere on the edge none of those exits is enabled.
  [[nodiscard]] bool is_patient(const Edge& edge, std::size_t component, const std::vector<ModeId>& open) const {
    bool result = false;
    for_each_exits(edge, [&](const Exits& exits) { result = result || !common(exits.enabled[component], open); });
    return result;
  }

  /// The exits of a component that can be taken somewhere along a loop that goes everywhere.
  [[nodiscard]] std::vector<ModeId> open_exits(const Vertices& loop, std::size_t component) const {
    std::set<ModeId> open;
    for (const Index e : loop) {
      for_each_exits(graph_.edges[e], [&](const Exits& exits) {
        open.insert(exits.open[component].begin(), exits.open[component].end());
      });
    }
    return {open.begin(), open.end()};
  }

  static bool common(const std::vector<ModeId>& a, const std::vector<ModeId>& b) {
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  }

  /// The component's exits are enabled everywhere, and can be taken somewhere. A smaller loop lasts only where on some
  /// edge of it those exits alone are enabled that can be taken nowhere on it.
  void split(const Vertices& loop, std::size_t component) {
    std::set<std::vector<ModeId>> different;
    for (const Index e : loop) {
      for_each_exits(graph_.edges[e], [&](const Exits& exits) { different.insert(exits.enabled[component]); });
    }
    for (const auto& enabled : different) {
      Vertices part;
      bool holds_one = false;
      for (const Index e : loop) {
        bool shut = true;
        bool such = false;
        for_each_exits(graph_.edges[e], [&](const Exits& exits) {
          shut = shut && !common(exits.open[component], enabled);
          such = such || exits.enabled[component] == enabled;
        });
        if (!shut) continue;
        part.push_back(e);
        holds_one = holds_one || such;
      }
      if (holds_one) parts_.push_back(std::move(part));
    }
  }

  [[nodiscard]] Lasso lasso(const Vertices& loop, const std::vector<Duty>& duties) const {
    std::vector<bool> inside(graph_.edges.size(), false);
    for (const Index e : loop) inside[e] = true;
    const Index start = graph_.edges[loop.front()].source;
    Lasso result;
    for (Index v = start; v != none; v = graph_.vertices[v].parent) {
      result.path.push_back({graph_.vertices[v].state.discrete, graph_.vertices[v].label});
    }
    std::reverse(result.path.begin(), result.path.end());
    result.repeats_from = result.path.size() - 1;
    Index at = start;
    std::vector<bool> done(duties.size(), false);
    const auto walk = [&](const Duty& wanted) {
      for (const Index e : way(at, wanted, inside)) {
        const Edge& edge = graph_.edges[e];
        result.path.push_back({graph_.vertices[edge.target].state.discrete, edge.label});
        for (std::size_t d = 0; d < duties.size(); ++d) done[d] = done[d] || duties[d](edge);
        at = edge.target;
      }
    };
    for (std::size_t d = 0; d < duties.size(); ++d) {
      if (!done[d]) walk(duties[d]);
    }
    if (at != start) walk([start](const Edge& edge) { return edge.target == start; });
    return result;
  }

  /// The edges of a shortest way inside the loop whose last edge is wanted.
  [[nodiscard]] std::vector<Index> way(Index from, const Duty& wanted, const std::vector<bool>& inside) const {
    std::unordered_map<Index, Index> reached;  // by which edge
    std::deque<Index> queue{from};
    while (!queue.empty()) {
      const Index v = queue.front();
      queue.pop_front();
      for (const Index e : graph_.vertices[v].edges) {
        const Edge& edge = graph_.edges[e];
        if (!inside[e]) continue;
        if (wanted(edge)) {
          std::vector<Index> result{e};
          for (Index at = v; at != from; at = graph_.edges[result.back()].source) result.push_back(reached.at(at));
          std::reverse(result.begin(), result.end());
          return result;
        }
        if (edge.target != from && reached.try_emplace(edge.target, e).second) queue.push_back(edge.target);
      }
    }
    throw base::InternalError("a loop has no edge that it was found to have");
  }

  const Graph& graph_;
  std::deque<Vertices> parts_;
};

}  // namespace

std::optional<Lasso> find_lasso(Runs& runs, Meter& meter) {
  const Graph graph(runs, meter);
  return Lassos(graph).find();
}

}  // namespace rmpl::verifier
