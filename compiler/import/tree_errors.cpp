// What is wrong with a fault tree, whatever format it came in.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "compiler/check/vocabulary.hpp"
#include "compiler/import/fault_tree.hpp"

namespace rmpl::compiler {

using grammar::Code;
using NodeKind = TreeNode::Kind;

namespace {

/// Why the gate cannot have its inputs; empty where it can.
std::string wrong_inputs(const FaultTree& tree, const TreeNode& node) {
  const std::size_t count = node.inputs.size();
  const auto basic = [&](std::size_t from) {
    return std::all_of(node.inputs.begin() + static_cast<std::ptrdiff_t>(std::min(from, count)), node.inputs.end(),
                       [&](TreeNodeId input) { return tree.nodes[input].kind == NodeKind::basic; });
  };
  switch (node.kind) {
    case NodeKind::basic:
    case NodeKind::house:
      return "";
    case NodeKind::negation:
      return count == 1 ? "" : "has " + std::to_string(count) + " inputs, expected one";
    case NodeKind::conjunction:
    case NodeKind::disjunction:
    case NodeKind::exclusive:
    case NodeKind::pand:
    case NodeKind::por:
      return count > 0 ? "" : "has no inputs";
    case NodeKind::vote:
      if (node.at_least == 0 || node.at_least > count) {
        return "is to have " + std::to_string(node.at_least) + " of " + std::to_string(count) +
               " inputs failed, expected a number from 1 to that of the inputs";
      }
      return "";
    case NodeKind::spare:
      return count > 0 ? "" : "has no inputs";
    case NodeKind::fdep:
      if (count < 2) return "has " + std::to_string(count) + " inputs, expected a trigger and what depends on it";
      return basic(1) ? "" : "takes a gate with it: only basic events can depend on a trigger";
    case NodeKind::seq:
      if (count == 0) return "has no inputs";
      return basic(1) ? "" : "holds back a gate: only basic events can be held back";
  }
  return "";
}

/// Loops are found by a walk that goes into each node once; it takes no stack.
class LoopFinder {
 public:
  LoopFinder(const FaultTree& tree, NetlistErrors& errors)
      : tree_(tree), errors_(errors), seen_(tree.nodes.size(), 0) {}

  void run() {
    for (TreeNodeId root = 0; root < tree_.nodes.size(); ++root) {
      if (seen_[root] == 0) walk(root);
    }
  }

 private:
  void walk(TreeNodeId root) {
    std::vector<std::pair<TreeNodeId, std::size_t>> path{{root, 0}};
    seen_[root] = 1;
    while (!path.empty()) {
      auto& [node, next] = path.back();
      const TreeNode& own = tree_.nodes[node];
      // What depends on a trigger is no input of it.
      const std::size_t inputs =
          own.kind == NodeKind::fdep ? std::min<std::size_t>(1, own.inputs.size()) : own.inputs.size();
      if (next == inputs) {
        seen_[node] = 2;
        path.pop_back();
        continue;
      }
      const TreeNodeId to = own.inputs[next++];
      if (seen_[to] == 1) {
        report(path, to);
        seen_[to] = 2;
      } else if (seen_[to] == 0) {
        seen_[to] = 1;
        path.emplace_back(to, 0);
      }
    }
  }

  void report(const std::vector<std::pair<TreeNodeId, std::size_t>>& path, TreeNodeId first) {
    std::string text = "a loop: " + backquoted(tree_.nodes[first].name);
    const auto begin = std::find_if(path.begin(), path.end(), [&](const auto& one) { return one.first == first; });
    for (auto at = begin + 1; at != path.end(); ++at)
      text += " reads " + backquoted(tree_.nodes[at->first].name) + ", which";
    errors_.report(Code::netlist_loop, tree_.nodes[first].place,
                   text + " reads " + (begin + 1 == path.end() ? "itself" : backquoted(tree_.nodes[first].name)));
  }

  const FaultTree& tree_;
  NetlistErrors& errors_;
  std::vector<char> seen_;  ///< 0: not yet, 1: on the path, 2: done
};

/// What a spare gate holds in reserve is in service where the gate is, and uses it. With a unit stands all that gates
/// without memory join it with: its module (S. Junges, D. Guck, J.-P. Katoen, M. Stoelinga: Uncovering dynamic fault
/// trees, 2016). A gate in the module of its own unit would have to be in service for that, and nothing would begin.
class ServiceFinder {
 public:
  ServiceFinder(const FaultTree& tree, NetlistErrors& errors)
      : tree_(tree), errors_(errors), module_(tree.nodes.size()), in_service_(tree.nodes.size(), true) {}

  void run() {
    join_modules();
    for (const TreeNode& gate : tree_.nodes) {
      if (gate.kind != NodeKind::spare) continue;
      for (const TreeNodeId unit : gate.inputs) in_service_[of(unit)] = false;
    }
    if (tree_.top) in_service_[of(*tree_.top)] = true;
    std::vector<bool> begun(tree_.nodes.size(), false);
    for (bool changed = true; changed;) {
      changed = false;
      for (TreeNodeId n = 0; n < tree_.nodes.size(); ++n) {
        if (tree_.nodes[n].kind != NodeKind::spare || begun[n] || !may_be_in_service(n)) continue;
        begun[n] = changed = true;
        for (const TreeNodeId unit : tree_.nodes[n].inputs) in_service_[of(unit)] = true;
      }
    }
    for (TreeNodeId n = 0; n < tree_.nodes.size(); ++n) {
      if (tree_.nodes[n].kind == NodeKind::spare && !begun[n]) report(n);
    }
  }

 private:
  [[nodiscard]] bool joins(const TreeNode& node) const {
    return node.kind != NodeKind::spare && node.kind != NodeKind::fdep && node.kind != NodeKind::seq;
  }

  void join_modules() {
    std::iota(module_.begin(), module_.end(), TreeNodeId{0});
    readers_.resize(tree_.nodes.size());
    for (TreeNodeId n = 0; n < tree_.nodes.size(); ++n) {
      const TreeNode& gate = tree_.nodes[n];
      for (const TreeNodeId input : gate.inputs) {
        if (gate.kind != NodeKind::fdep) readers_[input].push_back(n);
        // A spare gate belongs to the modules of those who read it, and joins none of them.
        if (joins(gate) && tree_.nodes[input].kind != NodeKind::spare) module_[of(input)] = of(n);
      }
    }
  }

  TreeNodeId of(TreeNodeId n) {
    while (module_[n] != n) n = module_[n] = module_[module_[n]];
    return n;
  }

  /// What no gate reads is in service.
  bool may_be_in_service(TreeNodeId gate) {
    if (gate == tree_.top || readers_[gate].empty()) return in_service_[of(gate)] || gate == tree_.top;
    return std::any_of(readers_[gate].begin(), readers_[gate].end(), [&](TreeNodeId reader) {
      return joins(tree_.nodes[reader]) ? bool(in_service_[of(reader)]) : bool(in_service_[of(gate)]);
    });
  }

  void report(TreeNodeId gate) {
    const TreeNode& node = tree_.nodes[gate];
    errors_.report(Code::netlist_gate, node.place,
                   "the gate " + backquoted(node.name) +
                       " would never be in service: " + backquoted(tree_.nodes[readers_[gate].front()].name) +
                       ", which reads it, is held in reserve with a unit of a spare gate that would have to be in "
                       "service first");
  }

  const FaultTree& tree_;
  NetlistErrors& errors_;
  std::vector<TreeNodeId> module_;                ///< by node: towards the node that stands for its module
  std::vector<std::vector<TreeNodeId>> readers_;  ///< by node: gates
  std::vector<bool> in_service_;                  ///< by module: it may be some day
};

}  // namespace

bool check_tree(const FaultTree& tree, NetlistErrors& errors) {
  for (const TreeNode& node : tree.nodes) {
    if (const std::string why = wrong_inputs(tree, node); !why.empty()) {
      errors.report(Code::netlist_gate, node.place, "the gate " + backquoted(node.name) + " " + why);
    }
  }
  LoopFinder(tree, errors).run();
  if (!errors.any()) ServiceFinder(tree, errors).run();
  return !errors.any();
}

}  // namespace rmpl::compiler
