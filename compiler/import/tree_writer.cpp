// A fault tree as a plant.
//
// Gates without a memory are attributes, which the constraints define. What has one is a component: a basic event, a
// priority gate, a spare gate. A gate moves at the instant at which its inputs let it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "base/error.hpp"
#include "compiler/import/fault_tree.hpp"

namespace rmpl::compiler {
namespace {

using NodeKind = TreeNode::Kind;

/// The shortest that reads back the same.
std::string number(double value) {
  char text[40];
  const auto [end, failure] = std::to_chars(text, text + sizeof text, value);
  return failure == std::errc() ? std::string(text, end) : "0";
}

/// More combinations than this are counted one input after the other.
constexpr std::size_t most_combinations = 64;

std::size_t combinations(std::size_t n, std::size_t k) {
  std::size_t result = 1;
  for (std::size_t i = 1; i <= std::min(k, n - k); ++i) {
    result = result * (n - i + 1) / i;
    if (result > most_combinations) return result;
  }
  return result;
}

class TreeWriter {
 public:
  explicit TreeWriter(const FaultTree& tree) : tree_(tree) {
    take_names();
    const std::size_t count = tree.nodes.size();
    triggers_.resize(count);
    users_.resize(count);
    holds_back_.resize(count);
    parents_.resize(count);
    active_.resize(count);
    for (TreeNodeId n = 0; n < count; ++n) {
      const TreeNode& node = tree.nodes[n];
      if (node.kind == NodeKind::negation || node.kind == NodeKind::exclusive) coherent_ = false;
      for (std::size_t i = 0; i < node.inputs.size(); ++i) {
        const TreeNodeId input = node.inputs[i];
        if (node.kind == NodeKind::fdep && i > 0) triggers_[input].push_back(n);
        if (node.kind == NodeKind::spare) users_[input].emplace_back(n, i + 1);
        if (node.kind != NodeKind::spare && node.kind != NodeKind::fdep &&
            (node.kind != NodeKind::seq || i == 0 || is_read(n))) {
          parents_[input].push_back(n);
        }
        if (node.kind == NodeKind::seq && i > 0) {
          for (std::size_t before = 0; before < i; ++before) holds_back_[input].push_back(node.inputs[before]);
        }
      }
    }
  }

  std::string run() {
    for (TreeNodeId n = 0; n < tree_.nodes.size(); ++n) write(n);
    std::size_t basic = 0;
    for (const TreeNode& node : tree_.nodes) basic += node.kind == NodeKind::basic ? 1 : 0;
    std::string text = "// A fault tree: " + std::to_string(basic) + " basic events, " +
                       std::to_string(tree_.nodes.size() - basic) + " gates.\n";
    if (tree_.top) text += "// Its top event is: " + fails(*tree_.top) + "\n";
    text += "\ndomain State = { ok, failed };\n";
    if (uses_answers_) text += "domain Answer = { no, yes };\n";
    for (const auto& [body, name] : types_) text += "\ncomponent " + name + " {\n" + body + "}\n";
    return text + "\nplant FaultTree {\n" + instances_ + attributes_ + constraints_ + "}\n";
  }

 private:
  void take_names() {
    std::map<std::string, std::string> origin;
    for (const TreeNode& node : tree_.nodes) {
      const auto made = identifier_of(node.name);
      if (!made) {
        throw base::InputError("'" + node.name + "' cannot be made a name: " + std::string(names_that_can_be_said));
      }
      if (const auto [at, fresh] = origin.emplace(*made, node.name); !fresh) {
        throw base::InputError("'" + at->second + "' and '" + node.name + "' would both be named '" + *made + "'");
      }
      names_.push_back(*made);
    }
    for (const std::string& name : names_) taken_.insert(name);
  }

  /// A name that no node has.
  std::string fresh(const std::string& name) {
    std::string result = name;
    while (!taken_.insert(result).second) result += "_";
    return result;
  }

  [[nodiscard]] std::string fails(TreeNodeId n) const {
    const TreeNode& node = tree_.nodes[n];
    if (node.kind == NodeKind::house) return node.failed ? "true" : "false";
    if (node.kind == NodeKind::basic && !triggers_[n].empty()) {
      return "(" + names_[n] + " = failed | " + names_[n] + " = disabled)";
    }
    return names_[n] + " = failed";
  }

  [[nodiscard]] std::string joined(const std::vector<TreeNodeId>& nodes, const char* separator) const {
    std::string text;
    for (const TreeNodeId n : nodes) text += (text.empty() ? "" : separator) + fails(n);
    return text;
  }

  /// The instance, of the type with that body.
  void instance(TreeNodeId n, const std::string& prefix, const std::string& body) {
    const auto [at, fresh_type] = types_.try_emplace(body, "");
    if (fresh_type) at->second = prefix + std::to_string(types_.size());
    instances_ += "  " + names_[n] + " : " + at->second + ";\n";
  }
  void define(const std::string& attribute, const std::string& when) {
    constraints_ += "  " + attribute + " <-> (" + when + ");\n";
  }

  void write(TreeNodeId n) {
    switch (tree_.nodes[n].kind) {
      case NodeKind::basic:
        return event(n);
      case NodeKind::house:
        return;
      case NodeKind::fdep:
        return dependency(n);
      case NodeKind::conjunction:
      case NodeKind::seq:
        return gate(n, joined(tree_.nodes[n].inputs, " & "));
      case NodeKind::disjunction:
        return gate(n, joined(tree_.nodes[n].inputs, " | "));
      case NodeKind::negation:
        return gate(n, "!(" + fails(tree_.nodes[n].inputs.front()) + ")");
      case NodeKind::exclusive:
        return gate(n, parity(tree_.nodes[n].inputs, 0, tree_.nodes[n].inputs.size()));
      case NodeKind::vote:
        return gate(n, vote(n));
      case NodeKind::pand:
        return pand(n);
      case NodeKind::por:
        return por(n);
      case NodeKind::spare:
        return spare(n);
    }
  }

  void gate(TreeNodeId n, const std::string& when) {
    attributes_ += "  internal " + names_[n] + " : State;\n";
    define(names_[n] + " = failed", when);
  }

  [[nodiscard]] std::string parity(const std::vector<TreeNodeId>& inputs, std::size_t first, std::size_t end) const {
    if (end - first == 1) return fails(inputs[first]);
    const std::size_t middle = first + (end - first) / 2;
    return "!((" + parity(inputs, first, middle) + ") <-> (" + parity(inputs, middle, end) + "))";
  }

  /// All combinations where there are few; else whether so many of the inputs from one on have failed, by whether this
  /// one has.
  std::string vote(TreeNodeId n) {
    const TreeNode& node = tree_.nodes[n];
    if (combinations(node.inputs.size(), node.at_least) <= most_combinations) {
      std::string text;
      std::vector<TreeNodeId> chosen;
      choose(node, 0, chosen, text);
      return text;
    }
    std::map<std::pair<std::size_t, std::size_t>, std::string> known;
    return count(n, 0, node.at_least, known);
  }

  void choose(const TreeNode& node, std::size_t from, std::vector<TreeNodeId>& chosen, std::string& text) const {
    if (chosen.size() == node.at_least) {
      text += (text.empty() ? "" : " | ") + joined(chosen, " & ");
      return;
    }
    for (std::size_t i = from; i < node.inputs.size(); ++i) {
      chosen.push_back(node.inputs[i]);
      choose(node, i + 1, chosen, text);
      chosen.pop_back();
    }
  }

  std::string count(TreeNodeId n, std::size_t from, std::size_t at_least,
                    std::map<std::pair<std::size_t, std::size_t>, std::string>& known) {
    const TreeNode& node = tree_.nodes[n];
    const std::size_t left = node.inputs.size() - from;
    if (at_least == 0) return "true";
    if (at_least > left) return "false";
    if (const auto at = known.find({from, at_least}); at != known.end()) return at->second;
    const std::string with = count(n, from + 1, at_least - 1, known);
    const std::string without = count(n, from + 1, at_least, known);
    const std::string name = fresh(names_[n] + "." + std::to_string(at_least) + ".from" + std::to_string(from + 1));
    attributes_ += "  internal " + name + " : State;\n";
    define(name + " = failed", "(" + fails(node.inputs[from]) + " & " + with + ") | " + without);
    return known[{from, at_least}] = name + " = failed";
  }

  void event(TreeNodeId n) {
    const TreeNode& node = tree_.nodes[n];
    std::vector<std::string> inputs;
    const bool spare = active(n) != "true" && !node.probability;
    const bool held = !holds_back_[n].empty();
    const bool triggered = !triggers_[n].empty();
    if (held && node.probability) {
      throw base::InputError("'" + node.name + "' fails from the start, and cannot be held back by a seq gate");
    }
    if (spare) inputs.emplace_back("active");
    if (held) inputs.emplace_back("allowed");
    if (triggered) inputs.emplace_back("trigger");
    std::string body;
    for (const std::string& input : inputs) body += (body.empty() ? "  input " : ", ") + input;
    if (!inputs.empty()) {
      body += " : Answer;\n";
      uses_answers_ = true;
    }
    const std::string disabled = triggered ? "  mode disabled;\n" : "";
    if (node.probability) {
      body += drawn(*node.probability, disabled);
    } else {
      const std::string allowed = held ? "allowed = yes" : "";
      body += "  initial ok;\n  mode ok;\n" + disabled + "  fault failed;\n";
      if (spare) {
        body += risk(both("active = yes", allowed), node.rate);
        body += risk(both("active = no", allowed), node.rate * node.dormancy);
      } else {
        body += risk(allowed, node.rate);
      }
    }
    if (triggered) body += "  ok -> disabled when trigger = yes;\n";
    instance(n, "Event", body);
    if (spare) define(names_[n] + ".active = yes", active(n));
    if (held) define(names_[n] + ".allowed = yes", joined(holds_back_[n], " & "));
    if (triggered) define(names_[n] + ".trigger = yes", triggered_by_any(n));
  }

  /// What has failed from the start: where gates are monotone, drawn in the first step, as a fault that happens.
  [[nodiscard]] std::string drawn(double probability, const std::string& disabled) const {
    if (probability == 0) return "  initial ok;\n  mode ok;\n" + disabled + "  fault failed;\n";
    if (!coherent_) {
      return "  initial ok " + number(1 - probability) + ", failed " + number(probability) + ";\n  mode ok;\n" +
             disabled + "  fault failed;\n";
    }
    return "  initial untried;\n  mode untried;\n  mode ok;\n" + disabled +
           "  fault failed;\n  untried -> ok;\n  untried -> failed with " + number(probability) + ";\n";
  }

  static std::string both(const std::string& a, const std::string& b) { return b.empty() ? a : a + " & " + b; }
  static std::string risk(const std::string& when, double rate) {
    if (rate == 0) return "";
    return "  ok -> failed" + (when.empty() ? "" : " when " + when) + " with rate " + number(rate) + " /s;\n";
  }

  /// Whether a gate reads the node.
  [[nodiscard]] bool is_read(TreeNodeId n) const {
    return n == tree_.top || std::any_of(tree_.nodes.begin(), tree_.nodes.end(), [n](const TreeNode& node) {
             return node.kind != NodeKind::fdep &&
                    std::find(node.inputs.begin(), node.inputs.end(), n) != node.inputs.end();
           });
  }

  /// When the node is in service: the top event is, and what a node in service reads, of spares the one in use. What
  /// only triggers others stands by for ever.
  const std::string& active(TreeNodeId n) {
    std::string& known = active_[n];
    if (!known.empty()) return known;
    const bool is_root = n == tree_.top || (parents_[n].empty() && users_[n].empty());
    std::string text = is_root ? "true" : "false";
    const auto add = [&text](const std::string& more) {
      if (text == "true" || more == "false") return;
      text = text == "false" || more == "true" ? more : text + " | " + more;
    };
    for (const TreeNodeId parent : parents_[n]) add(active(parent));
    for (const auto& [gate, place] : users_[n]) {
      const std::string uses = names_[gate] + " = using" + std::to_string(place);
      const std::string& above = active(gate);
      add(above == "true" ? uses : above == "false" ? above : "(" + uses + " & (" + above + "))");
    }
    return known = text;
  }

  /// What takes the event with it: at once, or as it was drawn.
  [[nodiscard]] std::string triggered_by_any(TreeNodeId n) const {
    std::string text;
    for (const TreeNodeId fdep : triggers_[n]) {
      const bool drawn = tree_.nodes[fdep].probability.has_value();
      text +=
          (text.empty() ? "" : " | ") + (drawn ? names_[fdep] + " = fired" : fails(tree_.nodes[fdep].inputs.front()));
    }
    return text;
  }

  /// One that is not sure is drawn as its trigger fails.
  void dependency(TreeNodeId n) {
    const TreeNode& node = tree_.nodes[n];
    if (!node.probability) return;
    const std::string body =
        pins("i", 1, "State") +
        "  initial waiting;\n  mode waiting;\n  mode fired;\n  mode spared;\n  waiting -> { fired with " +
        number(*node.probability) + ", spared with " + number(1 - *node.probability) + " } when i1 = failed;\n";
    instance(n, "Dependency", body);
    define(names_[n] + ".i1 = failed", fails(node.inputs.front()));
  }

  static std::string pins(const char* name, std::size_t count, const char* domain) {
    std::string text;
    for (std::size_t i = 1; i <= count; ++i) text += (i == 1 ? "  input " : ", ") + (name + std::to_string(i));
    return text + " : " + domain + ";\n";
  }
  void connect(TreeNodeId n) {
    const std::vector<TreeNodeId>& inputs = tree_.nodes[n].inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      define(names_[n] + ".i" + std::to_string(i + 1) + " = failed", fails(inputs[i]));
    }
  }

  /// Mode `first3`: the first three have failed in order.
  void pand(TreeNodeId n) {
    const TreeNode& node = tree_.nodes[n];
    const std::size_t count = node.inputs.size();
    const auto mode = [&](std::size_t k) { return k == count ? std::string("failed") : "first" + std::to_string(k); };
    const auto pin = [](std::size_t i, const char* state) { return "i" + std::to_string(i) + " = " + state; };
    std::string body = pins("i", count, "State") + "  initial first0;\n";
    for (std::size_t k = 0; k <= count; ++k) body += "  mode " + mode(k) + ";\n";
    body += "  mode safe;\n";
    for (std::size_t k = 0; k < count; ++k) {
      std::string wrong;
      for (std::size_t i = k + 1; i < count; ++i) {
        wrong += (wrong.empty() ? "" : " | ") + ("(" + pin(i, "ok") + " & " + pin(i + 1, "failed") + ")");
      }
      for (std::size_t j = k + 1; j <= count; ++j) {
        std::string when = pin(j, "failed");
        for (std::size_t i = k + 1; i < j; ++i) when += " & " + pin(i, "failed");
        for (std::size_t i = j + 1; i <= count; ++i) when += " & " + pin(i, "ok");
        body += "  " + mode(k) + " -> " + (j > k + 1 && !node.together ? "safe" : mode(j)) + " when " + when + ";\n";
      }
      if (!wrong.empty()) body += "  " + mode(k) + " -> safe when " + wrong + ";\n";
    }
    instance(n, "Pand", body);
    connect(n);
  }

  void por(TreeNodeId n) {
    const TreeNode& node = tree_.nodes[n];
    const std::size_t count = node.inputs.size();
    std::string others;
    for (std::size_t i = 2; i <= count; ++i) others += (i == 2 ? "" : " | ") + ("i" + std::to_string(i) + " = failed");
    std::string body = pins("i", count, "State") + "  initial watch;\n  mode watch;\n  mode failed;\n  mode safe;\n";
    const std::string alone = others.empty() || node.together ? "" : " & !(" + others + ")";
    body += "  watch -> failed when i1 = failed" + alone + ";\n";
    if (!others.empty()) {
      const std::string late = node.together ? "i1 = ok & (" + others + ")" : others;
      body += "  watch -> safe when " + late + ";\n";
    }
    instance(n, "Por", body);
    connect(n);
  }

  /// Takes the first unit that works and that no other gate uses. Of gates that need one unit at one moment the first
  /// in the file takes it: the others wait for an instant.
  void spare(TreeNodeId n) {
    const TreeNode& node = tree_.nodes[n];
    const std::size_t count = node.inputs.size();
    const auto pin = [](const char* name, std::size_t i) { return name + std::to_string(i); };
    std::string body = pins("i", count, "State") + pins("taken", count, "Answer") + pins("claimed", count, "Answer");
    uses_answers_ = true;
    body += "  initial using1;\n";
    for (std::size_t k = 1; k <= count; ++k) body += "  mode " + pin("using", k) + ";\n";
    body += "  mode failed;\n";
    for (std::size_t k = 1; k <= count; ++k) {
      std::string none = pin("i", k) + " = failed";
      std::string before;
      for (std::size_t j = 1; j <= count; ++j) {
        if (j == k) continue;
        const std::string free = pin("i", j) + " = ok & " + pin("taken", j) + " = no";
        body += "  " + pin("using", k) + " -> " + pin("using", j) + " when " + pin("i", k) + " = failed & " + free +
                " & " + pin("claimed", j) + " = no" + before + ";\n";
        before += " & !(" + free + " & " + pin("claimed", j) + " = no)";
        none += " & !(" + free + ")";
      }
      body += "  " + pin("using", k) + " -> failed when " + none + ";\n";
    }
    instance(n, "Spare", body);
    connect(n);
    for (std::size_t i = 0; i < count; ++i) {
      std::string taken, claimed;
      for (const auto& [gate, place] : users_[node.inputs[i]]) {
        if (gate == n) continue;
        taken += (taken.empty() ? "" : " | ") + names_[gate] + " = using" + std::to_string(place);
        if (gate < n) claimed += (claimed.empty() ? "" : " | ") + in_need(gate);
      }
      define(names_[n] + ".taken" + std::to_string(i + 1) + " = yes", taken.empty() ? "false" : taken);
      define(names_[n] + ".claimed" + std::to_string(i + 1) + " = yes", claimed.empty() ? "false" : claimed);
    }
  }

  /// The unit that a spare gate uses has failed.
  [[nodiscard]] std::string in_need(TreeNodeId gate) const {
    std::string text;
    const std::vector<TreeNodeId>& inputs = tree_.nodes[gate].inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      text += (text.empty() ? "" : " | ") +
              ("(" + names_[gate] + " = using" + std::to_string(i + 1) + " & " + fails(inputs[i]) + ")");
    }
    return text;
  }

  const FaultTree& tree_;
  std::vector<std::string> names_;
  std::set<std::string> taken_;
  bool coherent_ = true;
  std::vector<std::vector<TreeNodeId>> triggers_;  ///< by node: the dependencies that take it along
  std::vector<std::vector<TreeNodeId>> parents_;   ///< by node: the gates that read it, but for spare gates
  std::vector<std::string> active_;                ///< by node; empty: not asked yet
  std::vector<std::vector<std::pair<TreeNodeId, std::size_t>>> users_;  ///< by node: spare gates, and which unit it is
  std::vector<std::vector<TreeNodeId>> holds_back_;                     ///< by node: what has to fail before it
  std::map<std::string, std::string> types_;                            ///< by body
  std::string instances_, attributes_, constraints_;
  bool uses_answers_ = false;
};

}  // namespace

std::string to_tcca(const FaultTree& tree) { return TreeWriter(tree).run(); }

}  // namespace rmpl::compiler
