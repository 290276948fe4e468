// The command line of tcca-check.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <thread>

#include "tools/shared/complaint.hpp"

namespace rmpl::verifier {

using automata::Ticks;

namespace {

constexpr unsigned most_faults = 1'000'000;

/// A duration with or without a unit. What is wrong with it is said by CLI11 with the option's name before it.
Ticks duration(const std::string& text) {
  if (const auto ticks = automata::parse_duration(text)) return *ticks;
  throw CLI::ValidationError("'" + text +
                             "' is no duration; expected a number and perhaps a unit, such as 30, 0.5s or 270min, "
                             "of less than 292 years");
}

Ticks positive_duration(const std::string& text) {
  const Ticks ticks = duration(text);
  if (ticks > Ticks{0} && !ticks.is_infinite()) return ticks;
  throw CLI::ValidationError("'" + text + "' is no length of time; expected a finite duration above 0");
}

/// A number of bytes, perhaps in K, M or G of them (powers of 1024).
std::size_t memory_size(const std::string& text) {
  static const std::map<std::string, unsigned> shifts = {{"", 0}, {"K", 10}, {"M", 20}, {"G", 30}};
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const auto shift = shifts.find(text.substr(digits));
  std::size_t count = 0;
  std::istringstream number(text.substr(0, digits));
  if (shift == shifts.end() || !(number >> count) ||
      count > (std::numeric_limits<std::size_t>::max() >> shift->second)) {
    throw CLI::ValidationError("'" + text +
                               "' is no amount of memory; expected bytes, perhaps with K, M or G, such as 512M");
  }
  return count << shift->second;
}

/// An option whose text `read` turns into `value`.
template <class Value, class Read>
CLI::Option* add(CLI::App* app, const std::string& name, Value& value, const Read& read,
                 const std::string& description) {
  return app->add_option_function<std::string>(
      name,
      [&value, read, name](const std::string& text) {
        try {
          value = read(text);
        } catch (const CLI::ValidationError& error) {
          throw CLI::ValidationError(name, error.what());
        }
      },
      description);
}

template <class Value>
CLI::Option* add_choice(CLI::App* app, const std::string& name, Value& value, const std::map<std::string, Value>& names,
                        const std::string& description) {
  std::string type;
  for (const auto& [text, meaning] : names) type += (type.empty() ? "" : "|") + text;
  const auto read = [names, type](const std::string& text) {
    const auto at = names.find(text);
    if (at == names.end()) throw CLI::ValidationError("'" + text + "' is not known; expected one of " + type);
    return at->second;
  };
  return add(app, name, value, read, description)->type_name(type);
}

void add_common(CLI::App* app, CommandLine& line) {
  using Color = CommandLine::Color;
  add_choice(app, "--color", line.color,
             {{"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}},
             "colour in text; auto: on a terminal");
  app->add_flag("-q,--quiet", line.quiet, "no warnings, no progress");
  app->add_flag("-v,--verbose", line.verbose, "tell what is being checked");
}

CLI::App* add_subcommand(CLI::App& app, CommandLine& line, CommandLine::Kind kind, const std::string& name,
                         const std::string& description) {
  CLI::App* sub = app.add_subcommand(name, description);
  sub->fallthrough();
  sub->callback([&line, kind] { line.kind = kind; });
  return sub;
}

void add_model(CLI::App* sub, CommandLine& line) {
  sub->add_option("model", line.models, "the plant: .tcca or compiled .json; - for standard input")
      ->required()
      ->expected(1)
      ->type_name("MODEL");
}

void add_commands(CLI::App* sub, CommandLine& line) {
  add_choice(sub, "--commands", line.commands,
             {{"none", Commands::none}, {"one", Commands::one}, {"any", Commands::any}},
             "how many controls may be off their idle value in one step; one unless given");
}

/// Of a run: the reading of time, faults, the start.
void add_freedom(CLI::App* sub, CommandLine& line) {
  const auto period = [](const std::string& text) {
    return text == "dense" ? std::nullopt : std::optional(positive_duration(text));
  };
  add(sub, "--time", line.period, period, "dense time (the default), or the period at whose multiples steps happen")
      ->type_name("dense|T");
  sub->add_option("--faults", line.faults, "the most faults that may happen; 0 unless given")
      ->check(CLI::Range(0u, most_faults))
      ->type_name("K");
  sub->add_flag("--entailed", line.entailed, "a formula holds where the constraints imply it, not where they allow it");
  sub->add_option("--from", line.from,
                  "modes to start in, such as 'engine = off'; what is not named starts as in the plant")
      ->type_name("MODES");
}

void add_limits(CLI::App* sub, CommandLine& line) {
  sub->add_option("--max-states", line.max_states, "give up after so many symbolic states")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000'000}))
      ->type_name("N");
  add(sub, "--timeout", line.timeout, duration, "give up after so much time")->type_name("T");
  add(sub, "--max-memory", line.max_bytes, memory_size, "give up when so much memory is in use")
      ->type_name("BYTES[K|M|G]");
}

void add_format(CLI::App* sub, CommandLine& line) {
  using Format = CommandLine::Format;
  add_choice(sub, "--format", line.format, {{"text", Format::text}, {"json", Format::json}, {"junit", Format::junit}},
             "text unless given");
}

/// What every check has: what is free, limits, the form of the answer.
CLI::App* add_check(CLI::App& app, CommandLine& line, CommandLine::Kind kind, const std::string& name,
                    const std::string& description) {
  CLI::App* sub = add_subcommand(app, line, kind, name, description);
  add_freedom(sub, line);
  add_limits(sub, line);
  add_format(sub, line);
  sub->add_flag("--stats", line.statistics, "tell what the check has cost");
  return sub;
}

/// One property of a plant as a subcommand.
CLI::App* add_property(CLI::App& app, CommandLine& line, CommandLine::Kind kind, const std::string& name,
                       const std::string& description) {
  CLI::App* sub = add_check(app, line, kind, name, description);
  add_model(sub, line);
  add_commands(sub, line);
  return sub;
}

/// `φ within T`, or `φ` alone: then the time stands in `--within`.
Promise promise(const std::string& text) {
  constexpr std::string_view keyword = " within ";
  const std::size_t at = text.rfind(keyword);
  if (at == std::string::npos) return {text, std::nullopt};
  return {text.substr(0, at), duration(text.substr(at + keyword.size()))};
}

/// The properties that are the same for every program, by a list of their names.
std::vector<ProgramProperty::Kind> general_properties(const std::string& text) {
  using Kind = ProgramProperty::Kind;
  std::vector<Kind> result;
  std::istringstream names(text);
  for (std::string name; std::getline(names, name, ',');) {
    const std::size_t before = result.size();
    for (const Kind kind : {Kind::goal_conflict, Kind::no_plan, Kind::endless_wait, Kind::termination}) {
      if (name == name_of(kind) || name == "all") result.push_back(kind);
    }
    if (result.size() == before) {
      throw CLI::ValidationError("'" + name +
                                 "' is not known; expected goal-conflict, no-plan, endless-wait, termination or all");
    }
  }
  return result;
}

/// Every promise has a time: its own, or that of `--within`.
void finish_promises(const CLI::App& app, CommandLine& line) {
  if (line.kind != CommandLine::Kind::program) return;
  const bool within = app.get_subcommand("program")->count("--within") > 0;
  for (Promise& promise : line.eventuallys) {
    if (promise.within) continue;
    if (!within) throw CLI::ValidationError("--eventually", "expected 'FORMULA within T', or a time in --within");
    promise.within = line.within;
  }
}

void add_program(CLI::App& app, CommandLine& line) {
  CLI::App* sub = add_check(app, line, CommandLine::Kind::program, "program",
                            "what can become of a program that controls a plant? each violation with a timed trace");
  const auto model = [&line](const std::string& path) { line.models.push_back(path); };
  sub->add_option_function<std::string>("program", model,
                                        "the program: .rmpl, or a compiled .json of program and plant")
      ->required()
      ->type_name("PROGRAM");
  sub->add_option_function<std::string>("plant", model, "the plant: .tcca or compiled .json")->type_name("PLANT");
  sub->add_option("--main", line.entry, "the definition to start with; else the one that no other calls")
      ->type_name("NAME");
  add(sub, "--check", line.general, general_properties,
      "goal-conflict, no-plan, endless-wait, termination, or all of them: what is checked where nothing else is asked")
      ->type_name("LIST");
  sub->add_option("--never", line.nevers, "what is never to hold up to the program's end")
      ->type_name("FORMULA")
      ->expected(1)
      ->take_all();
  sub->add_option_function<std::vector<std::string>>(
         "--eventually",
         [&line](const std::vector<std::string>& texts) {
           try {
             for (const std::string& text : texts) line.eventuallys.push_back(promise(text));
           } catch (const CLI::ValidationError& error) {
             throw CLI::ValidationError("--eventually", error.what());
           }
         },
         "what is to come true in time, as 'FORMULA within T', or with --within")
      ->type_name("FORMULA")
      ->expected(1)
      ->take_all();
  add(sub, "--within", line.within, duration, "how soon, from the start")->type_name("T")->needs("--eventually");
  sub->add_option("--finally", line.finallys, "what is to hold where the program ends")
      ->type_name("FORMULA")
      ->expected(1)
      ->take_all();
  sub->add_flag("--each-fault", line.each_fault, "a table: every fault by itself, and what can come of it");
  sub->add_option("--scenario", line.scenario, "write the first violation as a scenario that fails the same way")
      ->type_name("OUT.scn")
      ->excludes("--each-fault");
  add(sub, "--cycle", line.cycle, positive_duration,
      "the cycle of that scenario, where time is dense; 0.5s unless given")
      ->type_name("T")
      ->needs("--scenario");
}

void add_threads(CLI::App* sub, CommandLine& line) {
  constexpr unsigned most = 64;
  sub->add_option(
         "--threads", line.threads,
         "how many threads explore; the result is the same for any number; as many as there are cores unless given")
      ->check(CLI::Range(1u, most))
      ->type_name("N");
}

/// What a search for a trace can be asked, besides how it is bounded.
void add_search_options(CLI::App* sub, CommandLine& line) {
  CLI::Option* fewest =
      sub->add_flag("--fewest-faults", line.fewest_faults,
                    "a trace with the least number of faults there is; --faults bounds how many are tried");
  CLI::Option* cut_sets =
      sub->add_option("--cut-sets", line.cut_sets, "every minimal set of up to so many faults that leads to a trace")
          ->type_name("N");
  CLI::Option* faults = sub->get_option("--faults");
  add_threads(sub, line);
  sub->add_flag("--no-symmetry", line.no_symmetry, "explore also what differs only in the names of like components");
  cut_sets->excludes(fewest)->excludes(faults);
  sub->parse_complete_callback([&line, faults] { line.faults_given = faults->count() > 0; });
}

/// All properties of a file, which says itself what is free.
void add_check_file(CLI::App& app, CommandLine& line) {
  CLI::App* sub = add_subcommand(app, line, CommandLine::Kind::check_file, "check",
                                 "do all properties of a file come out as it expects? a table of verdicts");
  sub->add_option_function<std::vector<std::string>>(
         "files",
         [&line](const std::vector<std::string>& files) {
           line.models = {files[0]};
           line.properties = files[1];
         },
         "the plant, .tcca or compiled .json, and its properties, .props; one of them - for standard input")
      ->required()
      ->expected(2)
      ->type_name("MODEL PROPERTIES");
  sub->add_option("--only", line.only, "check this property alone; may be given several times")
      ->type_name("NAME")
      ->expected(1)
      ->take_all();
  add_limits(sub, line);
  add_threads(sub, line);
  add_format(sub, line);
  sub->add_flag("--stats", line.statistics, "tell what each search has cost; properties may share one");
}

/// The question of reachability or safety in the language of another tool.
void add_export(CLI::App& app, CommandLine& line) {
  using Tool = CommandLine::Tool;
  CLI::App* sub = add_subcommand(app, line, CommandLine::Kind::export_model, "export",
                                 "the same question for another tool, which has to give the same answer");
  add_model(sub, line);
  add_choice(sub, "--format", line.tool,
             {{"tchecker", Tool::tchecker}, {"uppaal", Tool::uppaal}, {"prism", Tool::prism}},
             "which tool is asked: the first two in dense time, prism with the period of --time")
      ->required();
  CLI::Option_group* question = sub->add_option_group("question");
  question->require_option(1);
  question->add_option("--target", line.target, "what is to be reached")->type_name("FORMULA");
  question->add_option("--never", line.never, "what is never to hold")->type_name("FORMULA");
  add_freedom(sub, line);
  add_commands(sub, line);
  add_limits(sub, line);
}

void add_window(CLI::App* sub, CommandLine& line) {
  add(sub, "--not-before", line.not_before, duration, "the formula counts from this time on")->type_name("T");
  add(sub, "--by", line.by, duration, "the formula counts up to this time")->type_name("T");
  sub->add_flag("--fastest", line.fastest, "a trace with least time, not with fewest steps");
}

void add_properties(CLI::App& app, CommandLine& line) {
  using Kind = CommandLine::Kind;
  CLI::App* reachability = add_property(app, line, Kind::reachability, "reachability",
                                        "can the plant reach a state in which a formula holds? yes: a timed witness");
  reachability->add_option("--target", line.target, "what is to be reached")->required()->type_name("FORMULA");
  add_window(reachability, line);
  add_search_options(reachability, line);

  CLI::App* safety =
      add_property(app, line, Kind::safety, "safety", "does a formula never hold? no: a timed counterexample");
  safety->add_option("--never", line.never, "what is never to hold")->required()->type_name("FORMULA");
  add_window(safety, line);
  add_search_options(safety, line);

  CLI::App* response =
      add_property(app, line, Kind::response, "response",
                   "whenever one formula holds, does another follow in time? no: a timed counterexample");
  response->add_option("--after", line.after, "what asks for the response, each time it holds")
      ->required()
      ->type_name("FORMULA");
  // CLI11 counts how many words an option takes: `--within T FORMULA` takes two.
  response
      ->add_option_function<std::vector<std::string>>(
          "--within",
          [&line](const std::vector<std::string>& words) {
            try {
              line.within = duration(words[0]);
            } catch (const CLI::ValidationError& error) {
              throw CLI::ValidationError("--within", error.what());
            }
            line.then = words[1];
          },
          "how soon, and what the response is")
      ->required()
      ->expected(2)
      ->type_name("T FORMULA");
  add_search_options(response, line);
  add_program(app, line);
}

}  // namespace

ParsedCommandLine parse_command_line(int count, const char* const* arguments, const std::string& version) {
  CommandLine line;
  line.threads = std::max(1u, std::thread::hardware_concurrency());
  CLI::App app(
      "Checks what a plant model (TCCA) can do in time, by itself or under a control program (RMPL).\n"
      "Exit status: 0 holds or reachable, 1 violated or unreachable, 2 wrong input, 3 undecided.",
      "tcca-check");
  app.set_version_flag("--version", "tcca-check " + version);
  app.require_subcommand(1);
  add_common(&app, line);
  add_properties(app, line);
  add_check_file(app, line);
  add_export(app, line);
  ParsedCommandLine result;
  try {
    app.parse(count, arguments);
    finish_promises(app, line);
    result.command_line = line;
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    result.failed = app.exit(error, out, err) != 0;
    result.message = result.failed ? automata::complaint(app, error) : out.str();
  }
  return result;
}

}  // namespace rmpl::verifier
