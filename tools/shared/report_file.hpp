// The option --report: a page of flights, with drawings that Graphviz lays out meanwhile.
// SPDX-License-Identifier: MIT
#pragma once

#include <future>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "runtime/report/page.hpp"

namespace rmpl::tools {

/// What flies, or is run through: a plant, with a program or with none.
struct ReportSubject {
  const automata::Plant* plant;
  const automata::Program* program;
};

/// Its pictures, laid out by Graphviz.
runtime::Drawings drawings_made(const ReportSubject& subject);

class ReportFile {
 public:
  using Subject = ReportSubject;

  /// Begins to draw each subject once. They outlive this. Throws base::InputError where the file cannot be written.
  ReportFile(const std::string& path, const std::vector<Subject>& subjects);

  /// Writes the page; the file appears as a whole. Each flight is of one of the subjects. Where there is none, the page
  /// of an earlier run is removed. A drawing that there cannot be is told on standard error, unless `quiet`, and on the
  /// page.
  void write(std::string title, std::vector<runtime::Flight> flights, bool quiet);

 private:
  struct Drawn {
    Subject subject;
    std::future<runtime::Drawings> drawings;
  };
  std::string path_;
  base::OutputFile file_;
  std::vector<Drawn> drawn_;
};

}  // namespace rmpl::tools
