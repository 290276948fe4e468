// Each view is made of the same data.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/views.hpp"

#include "base/output_file.hpp"
#include "runtime/report/exports.hpp"
#include "tools/shared/report_file.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

void add_views(Command& command, ViewPaths& paths) {
  command.add_option("--report", paths.report, "write a page to look at the flight in a browser, all in one file")
      .option_text("OUT.html");
  command.add_option("--vcd", paths.vcd, "write a value change dump, for wave viewers").option_text("OUT.vcd");
  command.add_option("--csv", paths.csv, "write all changes as a table").option_text("OUT.csv");
  command.add_option("--mcap", paths.mcap, "write MCAP, for robotics tools").option_text("OUT.mcap");
}

Views::Views(const ViewPaths& paths, const automata::Plant& plant, const automata::Program& program)
    : paths_(paths), plant_(plant), program_(program) {
  // All at once, so that two of one name are told.
  std::optional<base::OutputFile> report, vcd, csv, mcap;
  if (!paths.report.empty()) report.emplace(paths.report);
  if (!paths.vcd.empty()) vcd.emplace(paths.vcd);
  if (!paths.csv.empty()) csv.emplace(paths.csv);
  if (!paths.mcap.empty()) mcap.emplace(paths.mcap);
}

void Views::write(const runtime::Flight& flight, bool quiet) {
  if (!paths_.vcd.empty()) base::write_file(paths_.vcd, runtime::to_vcd(flight));
  if (!paths_.csv.empty()) base::write_file(paths_.csv, runtime::to_csv(flight));
  if (!paths_.mcap.empty()) base::write_file(paths_.mcap, runtime::to_mcap(flight));
  if (paths_.report.empty()) return;
  if (!drawings_) {
    drawings_ = drawings_made({&plant_, &program_});
    if (!quiet && !drawings_->missing.empty()) tell("warning: the report lacks a drawing: " + drawings_->missing);
  }
  base::write_file(paths_.report, runtime::to_html({flight.name, {{&plant_, &program_, *drawings_}}, {flight}}));
}

}  // namespace rmpl::tools
