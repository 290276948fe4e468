// What Livingstone2 reads on board, a model compiled to numbers (`.l2`, L211), back into the form of XMPL.
//
// Sections follow each other, each a word on a line and then its lines, which number enumerations, variables,
// propositions and clauses from 0. Only a file with its names (`dbg_enums` and so on) can be read: without them a
// component is nothing but a number.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

#include "base/function_ref.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/import/xmpl.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Code;
using grammar::Span;

constexpr unsigned most_rank = 300;  ///< 10^-300 is a probability still

class L2Reader {
 public:
  L2Reader(const grammar::SourceFile& file, std::uint32_t index, XmplModel& model, grammar::Diagnostics& diagnostics)
      : rest_(file.text()), index_(index), model_(model), diagnostics_(diagnostics) {}

  bool run() {
    if (!next_line() || line_.front().text != "L211") return fail({}, "expected `L211`, a compiled Livingstone2 model");
    while (next_line()) {
      const Word section = line_.front();
      if (!read(section)) return false;
    }
    assemble();
    return !diagnostics_.has_errors();
  }

 private:
  struct Word {
    std::string_view text;
    Span place;
  };
  struct Variable {
    std::size_t type;
    std::string name;
    Span place;
  };
  struct Clause {
    std::string component;
    XmplClause clause;
  };
  struct Transition {
    std::size_t variable;
    XmplTransition transition;
  };

  bool fail(Span place, const std::string& what) {
    if (place == Span{}) place = {index_, at_, at_};
    diagnostics_.error(Code::netlist_syntax, place, what);
    return false;
  }

  /// Takes the next line, be it blank; false at the end.
  bool take_line() {
    line_.clear();
    if (rest_.empty()) return false;
    constexpr std::string_view blanks = " \t\r";
    const std::string_view line = rest_.substr(0, rest_.find('\n'));
    for (std::size_t begin = 0; (begin = line.find_first_not_of(blanks, begin)) != std::string_view::npos;) {
      const std::size_t end = std::min(line.size(), line.find_first_of(blanks, begin));
      const Span place{index_, at_ + static_cast<std::uint32_t>(begin), at_ + static_cast<std::uint32_t>(end)};
      line_.push_back({line.substr(begin, end - begin), place});
      begin = end;
    }
    const std::size_t length = std::min(rest_.size(), line.size() + 1);
    rest_.remove_prefix(length);
    at_ += static_cast<std::uint32_t>(length);
    return true;
  }
  bool next_line() {
    while (take_line()) {
      if (!line_.empty()) return true;
    }
    return false;
  }

  /// The number that a word is, below `bound`.
  bool number(std::size_t word, std::size_t bound, std::size_t& value) {
    if (word >= line_.size()) return fail({}, "expected a number at the end of this line");
    const std::string_view text = line_[word].text;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value >= bound) {
      return fail(line_[word].place,
                  "expected a number below " + std::to_string(bound) + ", found " + backquoted(std::string(text)));
    }
    return true;
  }
  /// A line with nothing but how many lines come.
  bool count(std::size_t& value) {
    if (!next_line()) return fail({}, "expected how many lines come");
    return number(0, std::string_view::npos, value);
  }
  /// A line with how many lines come, and these.
  bool lines(base::FunctionRef<bool()> read_one) {
    std::size_t left = 0;
    if (!count(left)) return false;
    for (; left > 0; --left) {
      if (!read_one()) return false;
    }
    return true;
  }
  bool next_of(std::size_t words) {
    if (!next_line()) return fail({}, "the file ends within a section");
    if (line_.size() < words) return fail(line_.front().place, "expected " + std::to_string(words) + " words or more");
    return true;
  }

  bool read(const Word& section) {
    if (section.text == "dbg_enums") return read_enumerations();
    if (section.text == "dbg_variables") return read_variables();
    if (section.text == "propositions" || section.text == "p") return read_propositions();
    if (section.text == "dbg_clauses") return read_clauses();
    if (section.text == "dbg_transitions") return read_transitions();
    if (section.text == "background" || section.text == "b") return read_background();
    if (section.text == "initial" || section.text == "i") return read_initial();
    if (section.text == "modes" || section.text == "m") return read_list(modes_);
    if (section.text == "commands" || section.text == "cm") return read_list(commands_);
    if (section.text == "observed" || section.text == "o") return read_list(observed_);
    for (const std::string_view nameless : {"enums", "e", "variables", "v", "clauses", "cl", "transitions", "t"}) {
      if (section.text != nameless) continue;
      return fail(section.place, "a section without names: expected the file with its names, as in `dbg_variables`");
    }
    return fail(section.place, "there is no section " + backquoted(std::string(section.text)));
  }

  bool read_enumerations() {
    return lines([this] {
      std::size_t members = 0;
      if (!next_of(2) || !number(0, std::string_view::npos, members)) return false;
      if (line_.size() != members + 2) return fail(line_.front().place, "expected as many members as it says");
      auto& [name, values] = enumerations_.emplace_back(std::string(line_[1].text), std::vector<std::string>{});
      for (std::size_t i = 2; i < line_.size(); ++i) values.emplace_back(line_[i].text);
      model_.types[name] = values;
      return true;
    });
  }

  bool read_variables() {
    return lines([this] {
      std::size_t type = 0;
      if (!next_of(2) || !number(0, enumerations_.size(), type)) return false;
      variables_.push_back({type, std::string(line_[1].text), line_[1].place});
      return true;
    });
  }

  bool variable(std::size_t word, std::size_t& value) { return number(word, variables_.size(), value); }
  bool member(std::size_t word, std::size_t of, std::string& value) {
    const auto& members = enumerations_[variables_[of].type].second;
    std::size_t position = 0;
    if (!number(word, members.size(), position)) return false;
    value = members[position];
    return true;
  }

  bool read_propositions() {
    if (!next_of(4)) return false;
    std::size_t counts[4];
    for (std::size_t i = 0; i < 4; ++i) {
      if (!number(i, std::string_view::npos, counts[i])) return false;
    }
    for (std::size_t kind = 0; kind < 4; ++kind) {
      for (; counts[kind] > 0; --counts[kind]) {
        std::size_t left = 0, right = 0;
        XmplTerm term;
        if (!next_of(2) || !variable(0, left)) return false;
        if (!(kind < 2 ? member(1, left, term.right) : variable(1, right))) return false;
        term.negated = kind == 1 || kind == 3;
        term.left = variables_[left].name;
        if (kind >= 2) term.right = variables_[right].name;
        propositions_.push_back(std::move(term));
      }
    }
    return true;
  }

  bool read_clauses() {
    return lines([this] {
      if (!next_of(1)) return false;
      Clause& made = clauses_.emplace_back(Clause{std::string(line_.front().text), {{}, line_.front().place}});
      for (std::size_t i = 1; i < line_.size(); ++i) {
        std::size_t proposition = 0;
        if (!number(i, propositions_.size(), proposition)) return false;
        made.clause.terms.push_back(propositions_[proposition]);
      }
      return true;
    });
  }

  bool read_background() {
    return lines([this] {
      std::size_t clause = 0;
      if (!next_of(1) || !number(0, clauses_.size(), clause)) return false;
      background_.push_back(clause);
      return true;
    });
  }

  bool read_transitions() {
    std::size_t counts[2];
    if (!count(counts[0]) || !count(counts[1])) return false;
    for (const bool failure : {false, true}) {
      for (std::size_t& left = counts[failure ? 1 : 0]; left > 0; --left) {
        if (!next_of(failure ? 5 : 4)) return false;
        Transition& made = transitions_.emplace_back();
        made.transition.place = line_.front().place;
        if (!variable(1, made.variable)) return false;
        made.transition.from = "*";
        if (line_[2].text != "*" && !member(2, made.variable, made.transition.from)) return false;
        if (!member(3, made.variable, made.transition.to)) return false;
        std::size_t word = 4;
        if (failure) {
          std::size_t rank = 0;
          if (!number(word++, most_rank + 1, rank)) return false;
          made.transition.probability = std::pow(10.0, -static_cast<double>(rank));
        }
        for (; word < line_.size(); ++word) {
          std::size_t clause = 0;
          if (!number(word, clauses_.size(), clause)) return false;
          made.transition.clauses.push_back(clauses_[clause].clause);
        }
      }
    }
    return true;
  }

  bool read_list(std::vector<std::size_t>& list) {
    take_line();
    for (std::size_t i = 0; i < line_.size(); ++i) {
      std::size_t listed = 0;
      if (!variable(i, listed)) return false;
      list.push_back(listed);
    }
    return true;
  }

  bool read_initial() {
    return lines([this] {
      std::size_t of = 0;
      std::string value;
      if (!next_of(2) || !variable(0, of) || !member(1, of, value)) return false;
      model_.initial.emplace_back(variables_[of].name + "=" + value, line_.front().place);
      return true;
    });
  }

  static std::string above(const std::string& name) {
    const std::size_t point = name.rfind('.');
    return point == std::string::npos ? std::string() : name.substr(0, point);
  }

  /// The component of a name, made where it is not there yet.
  XmplComponent& component(const std::string& name, Span place) {
    const auto [known, fresh] = places_.try_emplace(name, model_.components.size());
    if (fresh) {
      XmplComponent& made = model_.components.emplace_back();
      made.name = name;
      made.place = place;
    }
    return model_.components[known->second];
  }

  /// What a variable or a clause below this name belongs to: the nearest that has a mode, or else a module.
  [[nodiscard]] std::string owner_of(const std::string& name) const {
    for (std::string at = name; !at.empty(); at = above(at)) {
      if (moded_.contains(at)) return at;
    }
    return name;
  }

  void assemble() {
    for (const std::size_t mode : modes_) {
      const Variable& state = variables_[mode];
      const std::string name = above(state.name);
      if (name.empty()) {
        fail(state.place, backquoted(state.name) + " is the mode of no component: expected `component.mode`");
        return;
      }
      XmplComponent& made = component(name, state.place);
      if (!made.state.empty()) {
        diagnostics_.error(Code::netlist_gate, state.place,
                           "a component with several state variables has no counterpart: a mode is one");
        return;
      }
      made.state = state.name.substr(name.size() + 1);
      std::string type = enumerations_[state.type].first;
      if (type.find('.') != std::string::npos) type = above(type);  // `valve.ModeType`
      made.type = type;
      moded_.insert(name);
    }
    for (const Variable& variable : variables_) {
      const std::string parent = above(variable.name);
      if (parent.empty()) {
        fail(variable.place, backquoted(variable.name) + " belongs to no component: expected `component.variable`");
        return;
      }
      const std::string owner = owner_of(parent);
      component(owner, variable.place)
          .attributes.push_back(
              {variable.name.substr(owner.size() + 1), enumerations_[variable.type].first, variable.place});
    }
    for (const std::size_t clause : background_) {
      const Clause& said = clauses_[clause];
      component(owner_of(said.component), said.clause.place).clauses.push_back(said.clause);
    }
    for (Transition& transition : transitions_) {
      component(above(variables_[transition.variable].name), transition.transition.place)
          .transitions.push_back(std::move(transition.transition));
    }
    for (const std::size_t of : observed_) model_.observed.emplace_back(variables_[of].name, variables_[of].place);
    for (const std::size_t of : commands_) model_.commanded.emplace_back(variables_[of].name, variables_[of].place);
  }

  std::string_view rest_;
  std::uint32_t at_ = 0;  ///< where it begins
  std::uint32_t index_;
  XmplModel& model_;
  grammar::Diagnostics& diagnostics_;
  std::vector<Word> line_;
  std::vector<std::pair<std::string, std::vector<std::string>>> enumerations_;
  std::vector<Variable> variables_;
  std::vector<XmplTerm> propositions_;
  std::vector<Clause> clauses_;
  std::vector<Transition> transitions_;
  std::vector<std::size_t> background_, modes_, commands_, observed_;
  std::map<std::string, std::size_t> places_;  ///< of components, by name
  std::set<std::string> moded_;                ///< components with a mode
};

}  // namespace

bool read_l2(const grammar::Sources& sources, std::uint32_t file, XmplModel& model, grammar::Diagnostics& diagnostics) {
  return L2Reader(sources[file], file, model, diagnostics).run();
}

}  // namespace rmpl::compiler
