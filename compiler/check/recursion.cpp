// Recursion: strongly connected definitions, and the calls that break the rules.
// SPDX-License-Identifier: MIT
#include "compiler/check/recursion.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <string>

#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using grammar::Code;

namespace {

constexpr std::size_t unvisited = std::numeric_limits<std::size_t>::max();

/// Tarjan's strongly connected components, with an explicit stack: a chain of calls can be as long as the text.
class Components {
 public:
  explicit Components(const Definitions& definitions)
      : definitions_(definitions),
        number_(definitions.all.size(), unvisited),
        low_(definitions.all.size(), 0),
        on_stack_(definitions.all.size(), false) {
    result_.group.resize(definitions.all.size(), 0);
  }

  Recursion run() {
    for (std::size_t d = 0; d < definitions_.all.size(); ++d) {
      if (number_[d] == unvisited) visit(d);
    }
    return std::move(result_);
  }

 private:
  struct Frame {
    std::size_t definition;
    std::size_t next_call;
  };

  void enter(std::size_t d) {
    number_[d] = low_[d] = count_++;
    stack_.push_back(d);
    on_stack_[d] = true;
    frames_.push_back({d, 0});
  }

  void visit(std::size_t root) {
    enter(root);
    while (!frames_.empty()) {
      const std::size_t d = frames_.back().definition;
      const auto& calls = definitions_.all[d].calls;
      if (frames_.back().next_call < calls.size()) {
        const std::size_t callee = calls[frames_.back().next_call++].callee;
        if (number_[callee] == unvisited) {
          enter(callee);
        } else if (on_stack_[callee]) {
          low_[d] = std::min(low_[d], number_[callee]);
        }
        continue;
      }
      frames_.pop_back();
      if (!frames_.empty()) low_[frames_.back().definition] = std::min(low_[frames_.back().definition], low_[d]);
      if (low_[d] == number_[d]) close(d);
    }
  }

  void close(std::size_t root) {
    auto& members = result_.members.emplace_back();
    std::size_t member = unvisited;
    while (member != root) {
      member = stack_.back();
      stack_.pop_back();
      on_stack_[member] = false;
      result_.group[member] = result_.members.size() - 1;
      members.push_back(member);
    }
    std::sort(members.begin(), members.end());
    const auto& calls = definitions_.all[root].calls;
    result_.recursive.push_back(members.size() > 1 || std::any_of(calls.begin(), calls.end(),
                                                                  [&](const CallSite& s) { return s.callee == root; }));
  }

  const Definitions& definitions_;
  Recursion result_;
  std::vector<std::size_t> number_, low_;
  std::vector<bool> on_stack_;
  std::vector<std::size_t> stack_;
  std::vector<Frame> frames_;
  std::size_t count_ = 0;
};

/// Finds the shortest ways through a set of definitions, for naming cycles.
class Reporter {
 public:
  Reporter(const Definitions& definitions, Recursion& recursion, grammar::Diagnostics& diagnostics)
      : definitions_(definitions), recursion_(recursion), diagnostics_(diagnostics) {}

  void run() {
    for (std::size_t d = 0; d < definitions_.all.size(); ++d) {
      if (!recursion_.recursive[recursion_.group[d]]) continue;
      for (const CallSite& site : definitions_.all[d].calls) {
        if (recursion_.group[site.callee] != recursion_.group[d]) continue;
        if (!site.not_last.empty()) report(d, site);
      }
    }
    report_unguarded();
  }

 private:
  using Path = std::vector<std::pair<std::size_t, const CallSite*>>;

  void report(std::size_t caller, const CallSite& site) {
    recursion_.cut.insert(site.call);
    const bool patient = diagnostics_.error_count() < 50;  // each cycle costs a search
    auto& error = diagnostics_.error(
        Code::non_tail_recursion, site.call->definition.span,
        "the recursive call of " + backquoted(site.call->definition.text) + " is not the last thing that " +
            backquoted(definitions_.all[caller].definition->name.text) + " does: " + site.not_last);
    if (!patient) return;
    add_cycle(error, caller, search(site.callee, caller));
  }

  /// Looks, depth first, for calls with nothing before them that lead back to a definition on the way; each call is
  /// followed once.
  void report_unguarded() {
    enum class Seen : char { no, open, done };
    std::vector<Seen> seen(definitions_.all.size(), Seen::no);
    for (std::size_t first = 0; first < definitions_.all.size(); ++first) {
      if (seen[first] != Seen::no) continue;
      std::vector<std::pair<std::size_t, std::size_t>> walk{{first, 0}};  // definitions, and their calls followed
      Path path;                                                          // the calls between them
      seen[first] = Seen::open;
      while (!walk.empty()) {
        auto& [d, next] = walk.back();
        if (next == definitions_.all[d].calls.size()) {
          seen[d] = Seen::done;
          walk.pop_back();
          if (!path.empty()) path.pop_back();
          continue;
        }
        const CallSite& site = definitions_.all[d].calls[next++];
        if (!is_unguarded(d, site) || seen[site.callee] == Seen::done) continue;
        path.emplace_back(d, &site);
        if (seen[site.callee] == Seen::no) {
          seen[site.callee] = Seen::open;
          walk.emplace_back(site.callee, 0);
          continue;
        }
        const auto start =
            std::find_if(path.begin(), path.end(), [&](const auto& step) { return step.first == site.callee; });
        report_unguarded(Path(start, path.end()));
        path.pop_back();
      }
    }
  }

  /// Whether nothing happens before a recursive call.
  [[nodiscard]] bool is_unguarded(std::size_t caller, const CallSite& site) const {
    const std::size_t group = recursion_.group[caller];
    return recursion_.recursive[group] && recursion_.group[site.callee] == group && site.immediate &&
           site.not_last.empty();
  }

  void report_unguarded(const Path& cycle) {
    recursion_.cut.insert(cycle.back().second->call);
    std::string way;
    for (const auto& [definition, site] : cycle) way += name(definition) + " -> ";
    const std::size_t first = cycle.front().first;
    auto& error =
        diagnostics_.error(Code::unguarded_recursion, cycle.front().second->call->definition.span,
                           "unguarded recursion: nothing happens between one call and the next: " + way + name(first));
    for (std::size_t i = 1; i < cycle.size(); ++i) {
      error.notes.push_back({cycle[i].second->call->definition.span,
                             name(cycle[i].first) + " calls " + name(cycle[i].second->callee) + " here"});
    }
    error.suggestion = "let something happen first, as in `next " +
                       definitions_.all[cycle.front().second->callee].definition->name.text + "()`";
  }

  /// The calls that lead from one definition to another within their set, fewest first (breadth first).
  Path search(std::size_t from, std::size_t to) {
    if (from == to) return {};
    std::vector<std::pair<std::size_t, const CallSite*>> came(definitions_.all.size(), {unvisited, nullptr});
    std::deque<std::size_t> queue{from};
    while (!queue.empty() && came[to].first == unvisited) {
      const std::size_t d = queue.front();
      queue.pop_front();
      for (const CallSite& site : definitions_.all[d].calls) {
        if (recursion_.group[site.callee] != recursion_.group[from] || came[site.callee].first != unvisited) continue;
        came[site.callee] = {d, &site};
        queue.push_back(site.callee);
      }
    }
    Path path;
    for (std::size_t d = to; d != from; d = came[d].first) path.emplace_back(came[d]);
    std::reverse(path.begin(), path.end());
    return path;
  }

  void add_cycle(grammar::Diagnostic& error, std::size_t caller, const Path& way) {
    std::string cycle = name(caller);
    for (const auto& [definition, site] : way) cycle += " -> " + name(definition);
    error.message += " (the cycle: " + cycle + " -> " + name(caller) + ")";
    for (const auto& [definition, site] : way) {
      error.notes.push_back({site->call->definition.span, name(definition) + " calls " + name(site->callee) + " here"});
    }
  }

  [[nodiscard]] std::string name(std::size_t definition) const {
    return backquoted(definitions_.all[definition].definition->name.text);
  }

  const Definitions& definitions_;
  Recursion& recursion_;
  grammar::Diagnostics& diagnostics_;
};

}  // namespace

Recursion check_recursion(const Definitions& definitions, grammar::Diagnostics& diagnostics) {
  Recursion recursion = Components(definitions).run();
  Reporter(definitions, recursion, diagnostics).run();
  return recursion;
}

}  // namespace rmpl::compiler
