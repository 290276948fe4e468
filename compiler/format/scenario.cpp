// Scenarios: settings in columns, then events and expectations line by line.
// SPDX-License-Identifier: MIT
#include "base/overloaded.hpp"
#include "compiler/format/syntax.hpp"

namespace rmpl::compiler {
namespace {

class ItemWriter {
 public:
  explicit ItemWriter(Document& document) : document_(document) {}

  void operator()(const grammar::ProgramPart& item) const { setting(item); }
  void operator()(const grammar::PlantPart& item) const { setting(item); }
  void operator()(const grammar::CyclePart& item) const { setting(item); }
  void operator()(const grammar::SeedPart& item) const { setting(item); }
  /// The one word that is longer than `program`: it stands in the table, and gives it no column.
  void operator()(const grammar::DurationPart& item) const {
    document_.open_statement(Table::settings);
    end(item);
  }

  void operator()(const grammar::TruthPart& item) const {
    document_.open_statement();
    document_.take();
    write_list(document_, item.modes);
    end(item);
  }

  void operator()(const grammar::RequirementPart& item) const {
    document_.open_statement();
    document_.take();
    write_list(document_, item.tags);
    end(item);
  }

  void operator()(const grammar::FaultEvent& item) const {
    document_.open_statement();
    document_.take_to(item.at.span.end);
    document_.line();
    end(item);
  }

  void operator()(const grammar::ObserveEvent& item) const {
    document_.open_statement();
    document_.take_to(item.at.span.end);
    document_.line();
    lasting(item, item.reading);
  }

  void operator()(const grammar::CommandEvent& item) const {
    document_.open_statement();
    document_.take_to(item.at.span.end);
    document_.line();
    lasting(item, item.command);
  }

  void operator()(const grammar::ChannelEvent& item) const {
    document_.open_statement();
    document_.take_to(item.at.span.end);
    document_.line();
    end(item);
  }

  void operator()(const grammar::RuleText& item) const {
    document_.open_statement();
    document_.take_to(item.trigger.span.begin);
    write(document_, item.trigger);
    if (item.delay) {
      document_.line();
      document_.take_to(std::visit([](const auto& delay) { return delay.span.end; }, *item.delay));
    }
    document_.line();
    lasting(item, item.reading);
  }

  void operator()(const grammar::ExpectText& item) const {
    document_.open_statement();
    if (item.condition) {
      document_.take_to(item.condition->span.begin);
      write(document_, *item.condition);
    } else {
      document_.take();
      while (document_.next() != ";" && document_.next() != "within" && document_.next() != "requirement") {
        document_.take();
      }
    }
    while (document_.next() != ";") bound(item);
    end(item);
  }

 private:
  template <class Item>
  void setting(const Item& item) const {
    document_.open_statement(Table::settings);
    document_.take_keyword();
    end(item);
  }

  template <class Item>
  void end(const Item& item) const {
    document_.take_to(item.span.end);
    document_.close_statement();
  }

  /// `observe x = v for 3 s;`
  template <class Item>
  void lasting(const Item& item, const grammar::AssignmentText& what) const {
    document_.take_to(what.span.end);
    if (item.duration) document_.line();
    end(item);
  }

  /// `within 3 s`, `after c` or `requirement "R"`, which comes next.
  void bound(const grammar::ExpectText& item) const {
    document_.line();
    const bool within = document_.next() == "within", after = document_.next() == "after";
    document_.take();
    if (within) {
      document_.take_to(item.within->span.end);
    } else if (after) {
      write(document_, *item.after);
    } else {
      write_list(document_, item.requirement->tags);
    }
  }

  Document& document_;
};

}  // namespace

void write(Document& document, const grammar::ScenarioFile& file) {
  write_file(document, file.scenarios, [&](const grammar::ScenarioDefinition& scenario) {
    document.open_statement();
    document.take_to(scenario.name.span.end);
    write_block(document, scenario.items,
                [&](const grammar::ScenarioItem& item) { std::visit(ItemWriter(document), item); });
    document.close_statement();
  });
}

}  // namespace rmpl::compiler
