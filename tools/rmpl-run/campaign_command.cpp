// rmpl-run campaign: many flights with injected faults, by all threads, processes and machines that are given.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "automata/json/document.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "runtime/executive/campaign/flight.hpp"
#include "runtime/executive/campaign/table.hpp"
#include "runtime/executive/scenario/report.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/report/recorder.hpp"
#include "tools/rmpl-run/campaign_crew.hpp"
#include "tools/rmpl-run/campaign_store.hpp"
#include "tools/rmpl-run/campaign_summary.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/scenario_monitors.hpp"
#include "tools/rmpl-run/views.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/progress.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

using runtime::CampaignRun;

constexpr unsigned most_jobs = 256;
constexpr std::uint64_t most_runs = 1'000'000'000;

/// How many runs may fail: a number of them, or a share of all.
struct AtMost {
  double count = 0;
  bool percent = false;
  std::string text = "0";  ///< as it was given

  [[nodiscard]] bool permits(std::uint64_t failed, std::uint64_t runs) const {
    return static_cast<double>(failed) <= (percent ? count * static_cast<double>(runs) / 100 : count);
  }
};

AtMost at_most(const std::string& text) {
  AtMost result{0, text.ends_with('%'), text};
  const char* const end = text.data() + text.size() - (result.percent ? 1 : 0);
  const auto parsed = std::from_chars(text.data(), end, result.count, std::chars_format::fixed);
  const bool whole = result.percent || std::floor(result.count) == result.count;
  const double most = result.percent ? 100 : static_cast<double>(most_runs);
  if (text.empty() || parsed.ec != std::errc{} || parsed.ptr != end || std::signbit(result.count) || !whole ||
      result.count > most) {
    throw BadValue("expected a number of runs, or a share of them such as 5%, not '" + text + "'");
  }
  return result;
}

struct CampaignOptions {
  std::string file;
  std::string only;
  std::vector<std::string> monitors;  ///< files; empty: those of the project
  std::uint64_t runs = 0;
  std::uint64_t faults = 0;
  bool enumerate = false;
  bool unmodelled = false;
  std::vector<std::string> at;
  std::uint64_t seed = 1;
  unsigned jobs = std::clamp(std::thread::hardware_concurrency(), 1U, most_jobs);
  std::string database;
  AtMost at_most;
  std::string csv;
  std::string report;
  std::optional<std::uint64_t> replay;  ///< the number of a run
};

constexpr const char* campaign_footer =
    R"(Every run is the scenario with a seed of its own and --faults faults, each as soon as the model allows
it from a random time of the flight on. What comes of a run depends on the scenario, --seed and its
number alone. The same command goes on where one was ended, and shares the work with others that run at
the same time: in two terminals, or under mpirun, over machines that share the folder.
docs/campaigns.md explains the tables.

exit code: 0 every run met what is expected, or no more failed than --at-most permits; 1 more failed;
2 an input is wrong; 3 interrupted: what the runs so far came to is told

examples:
  rmpl-run campaign landing.scn --runs 1000 --faults 1 --db landing.sqlite --report landing.html
  rmpl-run campaign landing.scn --runs 1000 --faults 1 --db landing.sqlite --at-most 5%
  rmpl-run campaign landing.scn --faults 1 --replay 17 --report run17.html
  rmpl-run campaign landing.scn --enumerate --at 10s --at 4.5h --db each.sqlite --csv each.csv
  mpirun --enable-recovery -n 8 rmpl-run campaign landing.scn --runs 10000 --jobs 1 --db landing.sqlite)";

const automata::Scenario& selected(const automata::Document& document, const CampaignOptions& options) {
  std::vector<std::string_view> names;
  for (const automata::Scenario& scenario : document.scenarios) names.emplace_back(scenario.name);
  const auto found = std::find(names.begin(), names.end(), options.only);
  const bool given = !options.only.empty();
  if (!given && names.size() == 1) return document.scenarios.front();
  if (names.empty())
    throw base::InputError(options.file + ": the file has no scenario; a campaign flies a scenario of a .scn file");
  if (!given) {
    throw base::InputError(options.file + ": expected one scenario, found " + std::to_string(names.size()) +
                           "; choose one with --only");
  }
  if (found == names.end()) {
    throw base::InputError(options.file + ": no scenario is called '" + options.only + "'" +
                           suggestion_or_list(options.only, names));
  }
  return document.scenarios[static_cast<std::size_t>(found - names.begin())];
}

/// Without the places where things stand: a file that is called by another path is the same file.
void forget_places(automata::Json& json) {
  if (json.is_object()) json.erase("origin");
  for (automata::Json& inner : json) {
    if (inner.is_structured()) forget_places(inner);
  }
}

/// A hash (FNV-1a) of the models as they were compiled, so that results of one are never taken for those of another.
std::string digest(const automata::Document& document, const automata::Scenario& scenario) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (automata::Json json :
       {automata::to_json(document.plants[scenario.plant]), automata::to_json(document.programs[scenario.program]),
        automata::to_json(scenario, document)}) {
    forget_places(json);
    for (const char c : json.dump()) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  return std::to_string(hash);
}

/// The same of the files of monitors, as they are written.
std::string digest_of(const std::vector<std::string>& files) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const std::string& file : files) {
    for (const char c : base::read_file(file)) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  return std::to_string(hash);
}

Campaign prepare(const automata::Document& document, const CampaignOptions& options) {
  const automata::Scenario& scenario = selected(document, options);
  runtime::expect_faults(document, scenario, options.enumerate ? 1 : options.faults);
  Campaign campaign{document, scenario, {}, options.runs, {}, {}};
  const automata::Plant& plant = campaign.plant();
  campaign.plan.seed = options.seed;
  campaign.plan.faults = options.faults;
  campaign.plan.unmodelled = options.unmodelled;
  std::string times;
  for (const std::string& text : options.at) {
    campaign.plan.times.push_back(duration(text));
    if (campaign.plan.times.back() > scenario.duration) {
      throw base::InputError("--at " + text + ": a flight of '" + scenario.name + "' is over after " +
                             automata::format_seconds(scenario.duration) + " s");
    }
    times += (times.empty() ? "" : ", ") + automata::format_seconds(campaign.plan.times.back());
  }
  const std::uint64_t each = runtime::faults_of(plant).size() * campaign.plan.times.size();
  if (options.enumerate) campaign.runs = each * std::max<std::uint64_t>(options.runs, 1);
  campaign.flight.graph = runtime::reconfiguration_graph(plant);
  campaign.flight.interrupted = interrupted;
  campaign.identity = {{"version", RMPL_VERSION},
                       {"scenario", scenario.name},
                       {"seed", std::to_string(options.seed)},
                       {"faults", (options.enumerate ? "each at " + times + " s" : std::to_string(options.faults)) +
                                      (options.unmodelled ? ", unmodelled" : "")},
                       {"models", digest(document, scenario)}};
  if (!options.monitors.empty()) campaign.identity["monitors"] = digest_of(options.monitors);
  return campaign;
}

/// Of the processes that mpirun started, the first tells and writes what came of it.
bool is_first_rank() {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  return rank == nullptr || std::string_view(rank) == "0";
}

void check(const CampaignOptions& options) {
  if (options.replay && (!options.csv.empty() || !options.database.empty()))
    throw base::InputError("--replay flies one run, so it cannot be combined with --db or --csv");
  if (!options.replay && options.database.empty())
    throw base::InputError("--db: expected the name of a file for the results, or :memory:");
  if (options.enumerate && options.at.empty()) throw base::InputError("--enumerate: expected times, with --at");
  if (!options.enumerate && !options.at.empty()) throw base::InputError("--at: goes only with --enumerate");
  if (options.enumerate && options.faults > 0) throw base::InputError("--faults: does not go with --enumerate");
  if (!options.enumerate && options.runs == 0 && !options.replay)
    throw base::InputError("expected --runs or --enumerate");
}

/// Tells and writes what the runs came to that are there.
ExitStatus publish(const Campaign& campaign, const CampaignOptions& options, const Common& common) {
  CampaignStore store(options.database, campaign.plant(), campaign.identity);
  CampaignSummary summary(campaign.plant());
  std::string csv = runtime::csv_head();
  store.read(campaign.runs, [&](const CampaignRun& run) {
    summary.add(run);
    if (!options.csv.empty()) csv += runtime::csv_line(run, campaign.plant());
  });
  const bool all = summary.runs() == campaign.runs;
  const std::string runs = std::to_string(campaign.runs) + " runs";
  const std::string heading = campaign.scenario.name + ": " +
                              (all ? runs : std::to_string(summary.runs()) + " of " + runs) +
                              ", faults: " + campaign.identity.at("faults") + ", seed " + campaign.identity.at("seed");
  if (!options.csv.empty()) base::write_file(options.csv, csv);
  if (!options.report.empty()) base::write_file(options.report, summary.page(heading));
  print(summary.text(heading, output_painter(common.color)));
  const bool permitted = options.at_most.permits(summary.failed(), campaign.runs);
  if (!permitted && !common.quiet) {
    tell(std::to_string(summary.failed()) + (summary.failed() == 1 ? " run" : " runs") + " failed, at most " +
         options.at_most.text + " may");
  }
  if (!all) {
    tell("interrupted after " + std::to_string(summary.runs()) + " of " + runs +
         (options.database == in_memory ? "" : "; run the same command again to continue"));
    return ExitStatus::undecided;
  }
  return permitted ? ExitStatus::done : ExitStatus::violated;
}

/// One run again, told as the flight that it is.
ExitStatus replay(const Campaign& campaign, const CampaignOptions& options, const Common& common) {
  if (options.enumerate && *options.replay >= campaign.runs) {
    throw base::InputError("--replay: expected a run below " + std::to_string(campaign.runs) +
                           "; runs are numbered from 0");
  }
  const automata::Scenario& scenario = campaign.scenario;
  const automata::Program& program = campaign.document.programs[scenario.program];
  std::optional<Views> views;
  if (!options.report.empty()) views.emplace(ViewPaths{options.report, {}, {}, {}}, campaign.plant(), program);
  const base::Painter painter = output_painter(common.color);
  const std::uint64_t seed = runtime::seed_of_run(campaign.plan, *options.replay);
  runtime::Story story(campaign.plant(), program, runtime::MomentColumn(scenario.duration, scenario.cycle), painter, {},
                       [](const std::string& line) { print(line + "\n"); });
  runtime::Recorder recorder(campaign.document, scenario);
  std::vector<runtime::CycleObserver*> observers{&recorder};
  if (!common.quiet) observers.push_back(&story);
  if (!common.quiet) print(runtime::heading(campaign.document, scenario, seed, painter) + "\n");
  runtime::ScenarioResult result;
  const auto run = runtime::fly_run(campaign.document, scenario, campaign.plan, *options.replay, campaign.flight,
                                    observers, &result);
  if (!run) return ExitStatus::undecided;
  if (run->verdict == CampaignRun::Verdict::impossible) {
    throw base::InputError("--replay " + std::to_string(*options.replay) + ": the model makes this run impossible");
  }
  print((common.quiet ? "" : "\n") + runtime::summary(scenario, result, painter));
  if (views) {
    runtime::Flight flight = recorder.finish(result);
    flight.name += ", run " + std::to_string(*options.replay);
    views->write(flight, common.quiet);
  }
  switch (run->verdict) {
    case CampaignRun::Verdict::met:
      return ExitStatus::done;
    case CampaignRun::Verdict::failed:
      return ExitStatus::violated;
    default:
      return ExitStatus::undecided;
  }
}

ExitStatus run(CampaignOptions options, const Common& common, const Settings& settings) {
  check(options);
  options.monitors = ScenarioMonitors(options.monitors, settings.manifest).of(options.file);
  const compiler::Compilation compilation = load(with_monitors(options.file, options.monitors), common, to_be_flown());
  Campaign campaign = prepare(compilation.document(), options);
  const bool first = is_first_rank();
  campaign.plan.cycles = runtime::cycles_without_faults(campaign.document, campaign.scenario, campaign.flight);
  if (options.replay) return replay(campaign, options, common);
  std::optional<ForgottenDatabase> forgotten;
  if (options.database == in_memory) options.database = forgotten.emplace().path();
  const bool all =
      CampaignCrew(campaign, options.database, options.jobs, first && progress_is_seen(common.quiet)).work();
  if (first) return publish(campaign, options, common);
  return all ? ExitStatus::done : ExitStatus::undecided;
}

}  // namespace

void add_campaign(Program& program) {
  Command command = program.add_command("campaign", "fly a scenario many times, with faults injected");
  const auto options = std::make_shared<CampaignOptions>();
  command.add_option("FILE", options->file, "a .scn file, or a compiled .json").required();
  command.add_option("--only", options->only, "the scenario of the file").option_text("NAME");
  add_monitors(command, options->monitors);
  add_whole_number(command, "--runs", options->runs, 1, most_runs,
                   "number of runs; with --enumerate, runs for each fault at each time");
  add_whole_number(command, "--faults", options->faults, 0, 1000, "how many faults to draw in each run (default: 0)");
  command.add_flag("--enumerate", options->enumerate, "inject every single fault at each of the times --at");
  command.add_option("--at", options->at, "when --enumerate injects each fault; may be given several times")
      .option_text("TIME")
      .repeatable();
  command.add_flag("--unmodelled", options->unmodelled,
                   "inject each fault at its time, even if the model has no transition to it then");
  add_whole_number(command, "--seed", options->seed, 0, std::numeric_limits<std::uint64_t>::max(),
                   "seed of all runs (default: 1)");
  add_whole_number(command, "--jobs,-j", options->jobs, 1, most_jobs,
                   "how many runs fly at once in this process (default: one per processor)");
  command
      .add_option("--db", options->database,
                  "the database of results: created, or continued;\n:memory: for a temporary one")
      .option_text("OUT.sqlite");
  add_read(command, "--at-most", options->at_most, at_most,
           "how many runs may fail, as a number or a percentage (default: 0)")
      .option_text("N|P%");
  command.add_option("--csv", options->csv, "write the results as a table, one line per run").option_text("OUT.csv");
  command.add_option("--report", options->report, "write the summary as a page; with --replay, write the flight")
      .option_text("OUT.html");
  add_whole_number(command, "--replay", options->replay, 0, most_runs,
                   "fly only this run, by its number from 0, and tell its story; not with --db");
  command.footer(campaign_footer);
  program.add({command,
               [options, &program] {
                 return within_limits([&] { return run(*options, program.common(), program.settings()); });
               },
               AtSignal::tell});
}

}  // namespace rmpl::tools
