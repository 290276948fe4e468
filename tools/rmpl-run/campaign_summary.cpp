// Counting, and the tables that come of it.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/campaign_summary.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>

#include "automata/assignment_text.hpp"
#include "runtime/executive/campaign/interval.hpp"
#include "tools/rmpl-run/campaign_plots.hpp"

namespace rmpl::tools {
namespace {

using automata::Ticks;
using runtime::CampaignRun;
using runtime::Injected;
using Row = std::vector<std::string>;

constexpr Ticks soon = Ticks::of_seconds(10);
constexpr std::size_t most_told = 500;  // failing runs, on the page

/// With two decimals, or as many as keep what is not all, or not none, from looking so.
std::string percent(double share) {
  constexpr int most_decimals = 12;
  std::array<char, 32> text{};
  for (int decimals = 2; decimals <= most_decimals; ++decimals) {
    std::snprintf(text.data(), text.size(), "%.*f %%", decimals, 100 * share);
    const double told = std::strtod(text.data(), nullptr);
    if ((told > 0 || share == 0) && (told < 100 || share == 1)) break;
  }
  return text.data();
}

/// `95 of 100: 95.00 % (88.72 % to 98.36 %)`.
std::string share(std::uint64_t count, std::uint64_t trials) {
  std::string text = std::to_string(count) + " of " + std::to_string(trials);
  if (trials == 0) return text;
  const runtime::Interval interval = runtime::clopper_pearson(count, trials);
  return text + ": " + percent(static_cast<double>(count) / static_cast<double>(trials)) + " (" +
         percent(interval.low) + " to " + percent(interval.high) + ")";
}

std::string median(std::vector<Ticks> times) {
  if (times.empty()) return "";
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return (middle->count < 0 ? "-" : "") + automata::format_seconds({std::abs(middle->count)}) + " s";
}

Row row_of(const std::string& name, const CampaignTally& tally) {
  return {name,
          share(tally.met, tally.runs),
          std::to_string(tally.injected),
          std::to_string(tally.shown),
          share(tally.named, tally.shown),
          median(tally.latencies)};
}

Row fault_head(const char* of) {
  return {of,
          "expectations met, of runs with it",
          "injected",
          "with a symptom",
          "named within 10 s of it",
          "median latency"};
}

std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      line += row[c] + std::string(widths[c] - row[c].size() + 2, ' ');
    }
    line.resize(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string table(const std::string& caption, const std::vector<Row>& rows, bool head) {
  std::string text = "<div tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(caption) + "\"><table><caption>" +
                     escaped(caption) + "</caption>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    text += "<tr>";
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const bool column = head && r == 0;
      const std::string tag = column || c == 0 ? "th" : "td";
      text.append("<").append(tag);
      if (column || c == 0) text += column ? " scope=\"col\"" : " scope=\"row\"";
      text.append(">").append(escaped(rows[r][c])).append("</").append(tag).append(">");
    }
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

}  // namespace

void CampaignTally::add_run(const CampaignRun& run) {
  ++runs;
  met += run.verdict == CampaignRun::Verdict::met ? 1 : 0;
  undecided += run.verdict == CampaignRun::Verdict::undecided ? 1 : 0;
  impossible += run.verdict == CampaignRun::Verdict::impossible ? 1 : 0;
  finished += run.ended ? 1 : 0;
  cycles += run.cycles;
  right += run.right;
  by_chance += run.by_chance;
}

void CampaignTally::add_fault(const Injected& fault) {
  ++drawn;
  if (!fault.forced) return;
  ++injected;
  if (!fault.symptom) return;
  ++shown;
  if (!fault.named) return;
  const Ticks latency = *fault.named - *fault.symptom;
  latencies.push_back(latency);
  named += latency <= soon ? 1 : 0;
}

void CampaignSummary::add(const CampaignRun& run) {
  all_.add_run(run);
  const bool told = run.verdict == CampaignRun::Verdict::failed || run.verdict == CampaignRun::Verdict::undecided;
  if (told && failed_.size() < most_told) failed_.push_back(run);
  std::set<const CampaignTally*> counted;
  for (const Injected& injected : run.injected) {
    const std::size_t component = injected.fault.component.index();
    const std::pair fault{component, injected.fault.mode.index()};
    all_.add_fault(injected);
    for (CampaignTally* tally : {&components_[component], &faults_[fault]}) {
      tally->add_fault(injected);
      // A run without the fault says nothing of it, and one with two of a component counts once.
      if (injected.forced && counted.insert(tally).second) tally->add_run(run);
    }
  }
}

std::string CampaignSummary::name_of(std::pair<std::size_t, std::size_t> fault) const {
  return to_text(plant_.components[fault.first], automata::ModeId(fault.second));
}

std::vector<Row> CampaignSummary::totals() const {
  std::vector<Row> rows{
      {"expectations met", share(all_.met, all_.runs)},
      {"program ended", share(all_.finished, all_.runs)},
      {"estimate is the truth",
       std::to_string(all_.right) + " of " + std::to_string(all_.cycles) + " cycles" +
           (all_.cycles == 0 ? ""
                             : ": " + percent(static_cast<double>(all_.right) / static_cast<double>(all_.cycles)))},
      {"faults by chance", std::to_string(all_.by_chance)}};
  if (all_.impossible > 0) rows.push_back({"impossible for the model", std::to_string(all_.impossible)});
  if (faults_.empty()) return rows;
  rows.push_back({"faults injected", std::to_string(all_.injected)});
  if (all_.drawn > all_.injected) rows.push_back({"without an occasion", std::to_string(all_.drawn - all_.injected)});
  rows.push_back({"with a symptom", std::to_string(all_.shown)});
  rows.push_back({"named within 10 s of it", share(all_.named, all_.shown)});
  return rows;
}

std::vector<Row> CampaignSummary::by_component() const {
  std::vector<Row> rows{fault_head("component")};
  for (const auto& [component, tally] : components_) rows.push_back(row_of(plant_.components[component].name, tally));
  return rows;
}

std::vector<Row> CampaignSummary::by_fault() const {
  std::vector<Row> rows{fault_head("fault")};
  for (const auto& [fault, tally] : faults_) rows.push_back(row_of(name_of(fault), tally));
  return rows;
}

std::vector<Row> CampaignSummary::failures() const {
  std::vector<Row> rows{{"run", "verdict", "program ended", "faults, each with its time", "symptom", "named"}};
  const auto at = [](const std::optional<Ticks>& time) {
    return time ? automata::format_seconds(*time) + " s" : "never";
  };
  for (const CampaignRun& run : failed_) {
    Row row{std::to_string(run.run), std::string(runtime::name_of(run.verdict)), at(run.ended), "", "", ""};
    for (const Injected& injected : run.injected) {
      const char* const separator = row[3].empty() ? "" : "; ";
      const std::pair fault{injected.fault.component.index(), injected.fault.mode.index()};
      row[3] += separator + name_of(fault) + (injected.forced ? " at " + at(injected.forced) : ", without an occasion");
      row[4] += separator + at(injected.symptom);
      row[5] += separator + at(injected.named);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string CampaignSummary::text(const std::string& heading, base::Painter painter) const {
  std::string text = painter.strong(heading) + "\n" + aligned(totals());
  if (faults_.empty()) return text;
  return text + "\n" + painter.strong("by component") + "\n" + aligned(by_component()) + "\n" +
         painter.strong("by fault") + "\n" + aligned(by_fault());
}

std::string CampaignSummary::page(const std::string& heading) const {
  std::string text = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<meta name="color-scheme" content="light dark"><title>)" +
                     escaped(heading) + R"(</title>
<style>
:root { color-scheme: light; --paper: #fff; --ink: #1f2328; --quiet: #59636e; --edge: #d8dee4; --shade: #f6f8fa;
  --good: #2da44e; --bad: #cf222e; --open: #bf8700 }
@media (prefers-color-scheme: dark) {
  :root { color-scheme: dark; --paper: #0f1318; --ink: #e6edf3; --quiet: #9198a1; --edge: #30363d; --shade: #161b22;
    --good: #3fb950; --bad: #f85149; --open: #d29922 }
}
body { font: 15px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 75em; padding: 0 1em;
  background: var(--paper); color: var(--ink) }
h1 { font-size: 1.4em; overflow-wrap: anywhere }
h2 { font-size: 1.1em; margin-top: 2em }
table { border-collapse: collapse; margin: 2em 0; font-variant-numeric: tabular-nums }
caption { text-align: left; font-weight: 600; padding-bottom: .4em }
th, td { text-align: left; font-weight: normal; padding: .25em 1.2em .25em 0; border-bottom: 1px solid var(--edge) }
td, th[scope=row] { white-space: nowrap }
th[scope=col] { color: var(--quiet) }
div { overflow-x: auto }
tr:hover > * { background: var(--shade) }
p { color: var(--quiet) }
svg { max-width: 100%; height: auto; font: 13px system-ui, sans-serif; fill: var(--ink) }
.met, .bar { fill: var(--good) } .failed { fill: var(--bad) } .undecided { fill: var(--open) } .impossible { fill: var(--edge) }
.axis { stroke: var(--edge) }
</style></head><body><main>
<h1>)" + escaped(heading) +
                     "</h1>\n";
  const std::uint64_t wrong = failed();
  text += outcome_plot({all_.met, wrong - all_.undecided, all_.undecided, all_.impossible});
  text += table("All runs", totals(), false);
  if (!all_.latencies.empty()) text += "<h2>Latencies of diagnosis</h2>\n" + latency_plot(all_.latencies);
  if (!faults_.empty()) text += table("By component", by_component(), true) + table("By fault", by_fault(), true);
  if (!failed_.empty()) {
    text += "<h2>Failing runs</h2>\n" + failure_plot(failed_, plant_);
    text += table(wrong > failed_.size()
                      ? "The first " + std::to_string(failed_.size()) + " of " + std::to_string(wrong) + " failing runs"
                      : "Failing runs",
                  failures(), true);
    text += "<p>The same command with <code>--replay RUN --report run.html</code> flies one of them again.</p>\n";
  }
  return text +
         "<p>Intervals are of Clopper and Pearson, for 95 %. A symptom is the first reading that the flight without "
         "the "
         "fault could not have had; the latency is the time from it until the estimate has the fault.</p>\n"
         "</main></body></html>\n";
}

}  // namespace rmpl::tools
