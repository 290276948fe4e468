// The Galileo format: `toplevel "T";`, `"T" and "A" "B";`, `"A" lambda=0.1 dorm=0.3;`, comments as in C++.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

#include "compiler/check/vocabulary.hpp"
#include "compiler/import/fault_tree.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Code;
using grammar::Span;
using NodeKind = TreeNode::Kind;

struct Word {
  std::string text;
  bool quoted = false;
  Span place;
};

class GalileoReader {
 public:
  GalileoReader(const grammar::SourceFile& file, std::uint32_t index, grammar::Diagnostics& diagnostics)
      : text_(file.text()), index_(index), errors_(diagnostics) {}

  std::optional<FaultTree> run() {
    for (std::vector<Word> words = statement(); !errors_.too_many(); words = statement()) {
      if (words.empty()) {
        if (at_ >= text_.size()) break;
        continue;
      }
      read(words);
    }
    for (const auto& [node, words] : inputs_) {
      for (const Word& word : words) connect(node, word);
      const auto expected = expected_.find(node);
      if (expected == expected_.end() || expected->second == std::to_string(words.size())) continue;
      errors_.report(Code::netlist_gate, tree_.nodes[node].place,
                     backquoted(tree_.nodes[node].name) + " has " + std::to_string(words.size()) +
                         " inputs, expected " + expected->second);
    }
    if (!errors_.any() && tree_.nodes.empty()) {
      errors_.report(Code::netlist_syntax, {index_, 0, 0}, "a fault tree without a node");
    }
    if (!errors_.any() && !top_) {
      errors_.report(Code::netlist_syntax, {index_, 0, 0}, "no `toplevel` says which node the tree is about");
    }
    if (top_) {
      if (const auto at = names_.find(top_->text); at != names_.end()) {
        tree_.top = at->second;
      } else {
        errors_.report(Code::netlist_driver, top_->place, "nothing defines " + backquoted(top_->text));
      }
    }
    // A dependency that a gate names as an input is none: it never fails.
    for (TreeNode& node : tree_.nodes) {
      std::erase_if(node.inputs, [this](TreeNodeId input) { return tree_.nodes[input].kind == NodeKind::fdep; });
    }
    if (errors_.any() || !check_tree(tree_, errors_)) return std::nullopt;
    return std::move(tree_);
  }

 private:
  [[nodiscard]] Span span(std::size_t begin, std::size_t end) const {
    return {index_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }

  void skip_space() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else if (text_.substr(at_, 2) == "//") {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_.substr(at_, 2) == "/*") {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) {
          errors_.report(Code::netlist_syntax, span(at_, at_ + 2), "the comment has no end");
          at_ = text_.size();
        } else {
          at_ = end + 2;
        }
      } else {
        return;
      }
    }
  }

  /// The words up to the next semicolon.
  std::vector<Word> statement() {
    std::vector<Word> words;
    for (skip_space(); at_ < text_.size(); skip_space()) {
      const std::size_t begin = at_;
      if (text_[at_] == ';') {
        ++at_;
        return words;
      }
      if (text_[at_] == '"') {
        const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
        if (end == std::string_view::npos || text_[end] != '"') {
          errors_.report(Code::netlist_syntax, span(begin, begin + 1), "the quotation has no end");
          at_ = std::min(end, text_.size());
          continue;
        }
        words.push_back({std::string(text_.substr(begin + 1, end - begin - 1)), true, span(begin, end + 1)});
        at_ = end + 1;
        continue;
      }
      at_ = std::min(text_.find_first_of(" \t\r\n;\"", at_), text_.size());
      words.push_back({std::string(text_.substr(begin, at_ - begin)), false, span(begin, at_)});
    }
    if (!words.empty()) {
      errors_.report(Code::netlist_syntax, words.back().place, "expected `;` behind " + backquoted(words.back().text));
    }
    return {};
  }

  void read(const std::vector<Word>& words) {
    if (!words[0].quoted && words[0].text == "toplevel") {
      if (words.size() != 2 || top_) {
        errors_.report(Code::netlist_syntax, words[0].place,
                       top_ ? "`toplevel` stands here for the second time" : "expected one name behind `toplevel`");
        return;
      }
      top_ = words[1];
      return;
    }
    if (!words[0].quoted && words[0].text == "param") {
      errors_.report(Code::netlist_gate, words[0].place, "a parameter without a value is not imported");
      return;
    }
    if (words.size() < 2) {
      errors_.report(Code::netlist_syntax, words[0].place,
                     "expected a gate with its inputs, or `lambda=…` or `prob=…`, behind " + backquoted(words[0].text));
      return;
    }
    if (const auto [at, fresh] = names_.try_emplace(words[0].text, tree_.nodes.size()); !fresh) {
      if (auto* error =
              errors_.report(Code::netlist_driver, words[0].place, backquoted(words[0].text) + " is defined twice")) {
        error->notes.push_back({tree_.nodes[at->second].place, "the other one is here"});
      }
      return;
    }
    TreeNode node;
    node.name = words[0].text;
    node.place = words[0].place;
    if (!words[1].quoted && words[1].text.find('=') != std::string::npos && !words[1].text.starts_with("pdep")) {
      read_event(words, node);
    } else if (read_gate(words[1], node)) {
      inputs_.emplace_back(tree_.nodes.size(), std::vector<Word>(words.begin() + 2, words.end()));
    }
    tree_.nodes.push_back(std::move(node));
  }

  /// `and`, `2of3` and the like.
  bool read_gate(const Word& word, TreeNode& node) {
    static const std::map<std::string, NodeKind> kinds = {
        {"and", NodeKind::conjunction}, {"or", NodeKind::disjunction}, {"pand", NodeKind::pand},
        {"pand-inc", NodeKind::pand},   {"pand-ex", NodeKind::pand},   {"por", NodeKind::por},
        {"por-inc", NodeKind::por},     {"por-ex", NodeKind::por},     {"spare", NodeKind::spare},
        {"wsp", NodeKind::spare},       {"csp", NodeKind::spare},      {"hsp", NodeKind::spare},
        {"fdep", NodeKind::fdep},       {"seq", NodeKind::seq},        {"not", NodeKind::negation},
        {"xor", NodeKind::exclusive}};
    if (const auto at = kinds.find(word.text); at != kinds.end()) {
      node.kind = at->second;
      node.together = node.kind == NodeKind::por ? word.text == "por-inc" : word.text != "pand-ex";
      if (word.text == "csp") cold_.push_back(tree_.nodes.size());
      return true;
    }
    if (word.text.starts_with("pdep=")) {
      double probability = 0;
      const char* const text = word.text.data();
      const auto [end, failure] = std::from_chars(text + 5, text + word.text.size(), probability);
      node.kind = NodeKind::fdep;
      node.probability = probability;
      if (failure == std::errc() && end == text + word.text.size() && probability >= 0 && probability <= 1) return true;
      errors_.report(Code::probability_out_of_range, word.place,
                     backquoted(word.text) + ": expected a number from 0 to 1");
      return false;
    }
    const std::size_t of = word.text.find("of");
    const bool vot = word.text.starts_with("vot");
    const std::string number = vot ? word.text.substr(3) : word.text.substr(0, of);
    const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), node.at_least);
    if ((vot || of != std::string::npos) && failure == std::errc() && end == number.data() + number.size()) {
      node.kind = NodeKind::vote;
      if (!vot) expected_.emplace(tree_.nodes.size(), word.text.substr(of + 2));
      return true;
    }
    errors_.report(Code::netlist_gate, word.place,
                   "unknown gate " + backquoted(word.text) +
                       ", expected and, or, 2of3, vot2, pand, por, csp, wsp, hsp, fdep, pdep=0.5, seq");
    return false;
  }

  void read_event(const std::vector<Word>& words, TreeNode& node) {
    std::optional<double> rate, dormancy;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string& text = words[i].text;
      const std::size_t equals = text.find('=');
      const std::string key = text.substr(0, std::min(equals, text.size()));
      const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
      double number = 0;
      const auto [end, failure] = std::from_chars(value.data(), value.data() + value.size(), number);
      const bool good = failure == std::errc() && end == value.data() + value.size() && std::isfinite(number);
      if (key == "repl" && good && number == 1) continue;
      if ((key == "cov" || key == "res") && good && number == 0) continue;
      if (key != "lambda" && key != "prob" && key != "dorm") {
        errors_.report(Code::netlist_gate, words[i].place,
                       backquoted(key) + " of a basic event is not imported, expected lambda, prob, dorm");
      } else if (!good) {
        errors_.report(Code::netlist_syntax, words[i].place, "expected a number in " + backquoted(text));
      } else if (number < 0 || (key != "lambda" && number > 1)) {
        errors_.report(
            key == "lambda" ? Code::negative_rate : Code::probability_out_of_range, words[i].place,
            backquoted(text) + (key == "lambda" ? ": expected a rate from 0" : ": expected a number from 0 to 1"));
        (key == "lambda" ? rate : key == "dorm" ? dormancy : node.probability) = 0;
      } else {
        (key == "lambda" ? rate : key == "dorm" ? dormancy : node.probability) = number;
      }
    }
    if (rate && node.probability) {
      errors_.report(Code::netlist_gate, words[0].place,
                     backquoted(node.name) + " has a rate and a probability, expected one of them");
    }
    if (!rate && !node.probability) {
      errors_.report(Code::netlist_gate, words[0].place,
                     backquoted(node.name) + " has no rate and no probability, expected lambda=… or prob=…");
    }
    node.rate = rate.value_or(0);
    node.dormancy = dormancy.value_or(1);
    if (!dormancy) without_dormancy_.push_back(tree_.nodes.size());
  }

  void connect(TreeNodeId node, const Word& word) {
    const auto at = names_.find(word.text);
    if (at == names_.end()) {
      errors_.report(
          Code::netlist_driver, word.place,
          backquoted(tree_.nodes[node].name) + " reads " + backquoted(word.text) + ", which nothing defines");
      return;
    }
    TreeNode& own = tree_.nodes[node];
    // A cold spare without a dormancy of its own does not fail before it is used.
    const bool cold = std::find(cold_.begin(), cold_.end(), node) != cold_.end() && !own.inputs.empty();
    if (cold && std::find(without_dormancy_.begin(), without_dormancy_.end(), at->second) != without_dormancy_.end()) {
      tree_.nodes[at->second].dormancy = 0;
    }
    own.inputs.push_back(at->second);
  }

  std::string_view text_;
  std::uint32_t index_;
  NetlistErrors errors_;
  std::size_t at_ = 0;
  FaultTree tree_;
  std::optional<Word> top_;
  std::map<std::string, TreeNodeId> names_;
  std::vector<std::pair<TreeNodeId, std::vector<Word>>> inputs_;
  std::map<TreeNodeId, std::string> expected_;  ///< of `2of3`: how many inputs it is to have
  std::vector<TreeNodeId> cold_;                ///< `csp`
  std::vector<TreeNodeId> without_dormancy_;
};

}  // namespace

std::optional<FaultTree> read_galileo(const grammar::Sources& sources, std::uint32_t file,
                                      grammar::Diagnostics& diagnostics) {
  return GalileoReader(sources[file], file, diagnostics).run();
}

}  // namespace rmpl::compiler
