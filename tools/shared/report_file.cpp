// Drawings and data, put together.
// SPDX-License-Identifier: MIT
#include "tools/shared/report_file.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "compiler/diagram/plant_diagram.hpp"
#include "compiler/diagram/program_diagram.hpp"
#include "tools/shared/graphviz.hpp"

namespace rmpl::tools {
namespace {

runtime::Drawings draw(const ReportFile::Subject& subject) {
  constexpr std::string_view way_out = "install the package 'graphviz' and make the report again to see drawings";
  try {
    runtime::Drawings result;
    if (subject.program != nullptr)
      result.program = svg_of(compiler::program_diagram(*subject.program, std::nullopt), way_out);
    result.plant = svg_of(compiler::plant_diagram(*subject.plant, {}, std::nullopt, compiler::Badges::room), way_out);
    return result;
  } catch (const base::InputError& error) {
    return {{}, {}, error.what()};
  }
}

std::future<runtime::Drawings> drawings_of(const ReportFile::Subject& subject) {
  try {
    return std::async(std::launch::async, draw, subject);
  } catch (const std::system_error&) {
    return std::async(std::launch::deferred, draw, subject);  // the system gives no more threads
  }
}

}  // namespace

ReportFile::ReportFile(std::string path, const std::vector<Subject>& subjects) : file_(std::move(path)) {
  for (const Subject& subject : subjects) {
    const bool known = std::any_of(drawn_.begin(), drawn_.end(), [&](const Drawn& drawn) {
      return drawn.subject.plant == subject.plant && drawn.subject.program == subject.program;
    });
    if (!known) drawn_.push_back({subject, drawings_of(subject)});
  }
}

void ReportFile::write(std::string title, std::vector<runtime::Flight> flights) {
  runtime::Report report{std::move(title), {}, std::move(flights)};
  for (Drawn& drawn : drawn_) {
    const bool flown = std::any_of(report.flights.begin(), report.flights.end(), [&](const runtime::Flight& flight) {
      return flight.plant == drawn.subject.plant && flight.program == drawn.subject.program;
    });
    if (flown) report.models.push_back({drawn.subject.plant, drawn.subject.program, drawn.drawings.get()});
  }
  if (report.flights.empty()) return;  // interrupted before the first: what was there before stays
  file_.write(runtime::to_html(report));
  file_.keep();
}

}  // namespace rmpl::tools
