// Codes of the registry: control programs.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{Code::clock_never_started, "clock never started",
             "The condition reads a clock that no step starts: every atom over it would be false for ever.",
             "Main() :: { when t1 >= 30 s donext engine = off }",
             "Main() :: { t1 = 0; when t1 >= 30 s donext engine = off }"},
    CodeInfo{Code::clock_not_allowed, "clock where none is allowed",
             "Clocks stand only in conditions: of `if`, `unless`, `when`, `whenever`, `watching` and `maintaining`. A "
             "goal cannot ask for a time. A clock starts at 0 and is never reset.",
             "Main() :: { t1 >= 30 s }", "Main() :: { t1 = 0; when t1 >= 30 s donext engine = off }"},
    CodeInfo{Code::unguarded_recursion, "recursion that never waits",
             "The definition calls itself again without a step in between that takes time: it would start itself for "
             "ever within one instant.",
             "Poll() :: { Poll() }", "Poll() :: { when valve = open donext { engine = on; Poll() } }"},
    CodeInfo{Code::non_tail_recursion, "recursion that is not the last step",
             "A definition may call itself only as the last thing that it does, and not inside its own `do … watching` "
             "or `maintaining`: then the call is a way back to its start. Anything else would need a stack.",
             "Poll() :: { when a = on donext Poll(); b = off }", "Poll() :: { b = off; when a = on donext Poll() }"},
    CodeInfo{Code::not_a_mode_goal, "goal that is no conjunction of modes",
             "A goal is an assignment of a mode, or a conjunction of such (thesis 5.1.1). Disjunctions, negations and "
             "attributes cannot be achieved, only asked for.",
             "Main() :: { engine = on | spare = on }", "Main() :: { if engine = failed thennext spare = on }"},
    CodeInfo{Code::wrong_argument_count, "wrong number of arguments",
             "The call gives more or fewer arguments than the definition has parameters.",
             "Open(v) :: { v = open }\nMain() :: { Open() }", "Open(v) :: { v = open }\nMain() :: { Open(valve) }"},
    CodeInfo{Code::ambiguous_entry, "several entry points",
             "The program starts at the definition that no other calls, and here are several. `--main NAME`, or `main "
             "NAME` in a scenario, decides.",
             "A() :: { x = on }\nB() :: { y = on }", "A() :: { x = on }\nB() :: { y = on, A() }"},
    CodeInfo{
        Code::no_entry, "no entry point",
        "No definition can be the start: each is called by another, there is none, or `--main` names none of them.",
        "A() :: { when x = on donext B() }\nB() :: { when x = off donext A() }",
        "Main() :: { A() }\nA() :: { when x = on donext B() }\nB() :: { when x = off donext A() }"},
    CodeInfo{Code::not_in_plant, "not in the plant",
             "The program speaks of a variable or a value that the plant does not have.",
             "Main() :: { motor = on }  // the plant has engine", "Main() :: { engine = on }"},
    CodeInfo{Code::wrong_argument, "argument that does not fit",
             "The parameter is used where this argument cannot stand: a value where a variable is needed, a constraint "
             "where a name is.",
             "Open(v) :: { v = open }\nMain() :: { Open(a = b) }",
             "Open(v) :: { v = open }\nMain() :: { Open(valve) }"},
    CodeInfo{Code::model_program, "only in model programs",
             "`choose`, and declarations of variables, belong to model programs: they describe what the plant does. A "
             "control program says what it should do.",
             "Main() :: { choose { a = on with 0.5, a = off with 0.5 } }", "Main() :: { a = on }"},
    CodeInfo{Code::contradictory_goal, "goal that contradicts itself",
             "One goal asks for two modes of one component at once.", "Main() :: { engine = on & engine = off }",
             "Main() :: { engine = on; engine = off }"},
    CodeInfo{Code::no_program, "no control program",
             "A control program was expected, and none of the inputs holds one.", R"(scenario "s" { plant "p.tcca"; })",
             R"(scenario "s" { program "p.rmpl"; plant "p.tcca"; })"},
    CodeInfo{Code::several_programs, "several control programs",
             "One input set holds at most one control program: give one file, which imports the others.",
             "rmplc compile entry.rmpl descent.rmpl", R"(import "descent.rmpl";  // in entry.rmpl)"},
};

}  // namespace

std::span<const CodeInfo> program_codes() { return table; }

}  // namespace rmpl::grammar
