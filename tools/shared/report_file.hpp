// The option --report: a page of flights, with drawings that Graphviz lays out meanwhile.
// SPDX-License-Identifier: MIT
#pragma once

#include <future>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "runtime/report/page.hpp"

namespace rmpl::tools {

class ReportFile {
 public:
  /// What flies, or is run through: a plant, with a program or with none.
  struct Subject {
    const automata::Plant* plant;
    const automata::Program* program;
  };

  /// Begins to draw each subject once. They outlive this. Throws base::InputError where the file cannot be written.
  ReportFile(std::string path, const std::vector<Subject>& subjects);

  /// Writes the page; the file appears as a whole. Each flight is of one of the subjects; there is at least one.
  void write(std::string title, std::vector<runtime::Flight> flights);

 private:
  struct Drawn {
    Subject subject;
    std::future<runtime::Drawings> drawings;
  };
  base::OutputFile file_;
  std::vector<Drawn> drawn_;
};

}  // namespace rmpl::tools
