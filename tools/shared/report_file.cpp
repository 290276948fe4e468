// Drawings and data, put together.
// SPDX-License-Identifier: MIT
#include "tools/shared/report_file.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "compiler/diagram/plant_diagram.hpp"
#include "compiler/diagram/program_diagram.hpp"
#include "tools/shared/graphviz.hpp"
#include "tools/shared/stale_file.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

/// Each drawing by itself: one that fails takes no other with it.
runtime::Drawings drawings_made(const ReportSubject& subject) {
  constexpr std::string_view way_out = "install the package 'graphviz' and write the report again to see drawings";
  runtime::Drawings result;
  const auto picture = [&](const std::string& graph) {
    try {
      return svg_of(graph, way_out);
    } catch (const base::InputError& error) {
      result.missing = error.what();
      return std::string();
    }
  };
  if (subject.program != nullptr) result.program = picture(compiler::program_diagram(*subject.program, std::nullopt));
  result.plant = picture(compiler::plant_diagram(*subject.plant, {}, std::nullopt, compiler::Badges::room));
  return result;
}

namespace {

std::future<runtime::Drawings> drawings_of(const ReportFile::Subject& subject) {
  try {
    return std::async(std::launch::async, drawings_made, subject);
  } catch (const std::system_error&) {
    return std::async(std::launch::deferred, drawings_made, subject);  // the system gives no more threads
  }
}

}  // namespace

ReportFile::ReportFile(const std::string& path, const std::vector<Subject>& subjects) : path_(path), file_(path) {
  for (const Subject& subject : subjects) {
    const bool known = std::any_of(drawn_.begin(), drawn_.end(), [&](const Drawn& drawn) {
      return drawn.subject.plant == subject.plant && drawn.subject.program == subject.program;
    });
    if (!known) drawn_.push_back({subject, drawings_of(subject)});
  }
}

void ReportFile::write(std::string title, std::vector<runtime::Flight> flights, bool quiet) {
  runtime::Report report{std::move(title), {}, std::move(flights)};
  for (Drawn& drawn : drawn_) {
    const bool flown = std::any_of(report.flights.begin(), report.flights.end(), [&](const runtime::Flight& flight) {
      return flight.plant == drawn.subject.plant && flight.program == drawn.subject.program;
    });
    if (flown) report.models.push_back({drawn.subject.plant, drawn.subject.program, drawn.drawings.get()});
  }
  std::set<std::string_view> told;
  for (const runtime::Model& model : report.models) {
    const std::string& missing = model.drawings.missing;
    if (!quiet && !missing.empty() && told.insert(missing).second)
      tell("warning: the report lacks a drawing: " + missing);
  }
  if (report.flights.empty()) return remove_stale(path_);  // interrupted before the first
  file_.write(runtime::to_html(report));
  file_.keep();
}

}  // namespace rmpl::tools
