// Codes of the registry: what is wrong with a text as such.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array text_table = {
    CodeInfo{Code::syntax, "syntax error",
             "The text does not follow the grammar at this place. The message names what the grammar permits here and "
             "what the text has instead. After an error, parsing continues behind the next `;` or `}`, so one run "
             "reports all syntax errors.",
             R"(EntrySequence() :: {
  when att = entry-orient do lander = separated
})",
             R"(EntrySequence() :: {
  when att = entry-orient donext lander = separated
})"},
    CodeInfo{Code::invalid_encoding, "not UTF-8 text",
             "Sources are UTF-8 text without NUL bytes. This place has a NUL byte, or bytes that are not UTF-8. The "
             "file may use another encoding, or may not be text.",
             R"($ printf '// caf\351\nMain() :: { engine = on }\n' > main.rmpl  # \351 is Latin-1
$ rmplc compile main.rmpl -o model.json)",
             R"($ printf '// caf\303\251\nMain() :: { engine = on }\n' > main.rmpl  # \303\251 is UTF-8
$ rmplc compile main.rmpl -o model.json)"},
    CodeInfo{Code::nesting_too_deep, "nested too deep",
             "Constraints and steps may nest at most 400 levels deep. The limit protects the stack against generated "
             "text. Split the text: move parts of a program into definitions of their own, and parts of a constraint "
             "into internal attributes.",
             R"($ many() { printf "$1%.0s" $(seq 401); }
$ echo "Main() :: { if $(many '(') valve = open $(many ')') thennext engine = on }" > main.rmpl
$ rmplc compile --max-input 8G main.rmpl -o model.json)",
             R"(Main() :: { if valve = open thennext engine = on })"},
    CodeInfo{Code::number_out_of_range, "number out of range",
             "The number is too large: a decimal goes up to 1.8e308, a whole number up to 2^64 - 1.",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  any -> failed with 1e999;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  any -> failed with 1e-9;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})"},
    CodeInfo{Code::duration_out_of_range, "duration out of range",
             "A duration is between 0 and about 292 years, and no finer than a nanosecond. Units are ns, us, ms, s, "
             "min (or mins), h, d and w (or weeks); a bare number is seconds. Months and years have no fixed length: "
             "write days.",
             R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm after 1000000 d;
}
plant Cabin { heater : Heater; })",
             R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm after 30 d;
}
plant Cabin { heater : Heater; })"},
    CodeInfo{Code::import_not_found, "import not found",
             "The imported file cannot be read. The path is taken relative to the file that imports it.",
             R"($ rmplc compile plant.tcca -o model.json
// gauge.tcca
component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
// plant.tcca
import "gauges.tcca";
plant Tank { gauge : Gauge; })",
             R"(// gauge.tcca
component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
// plant.tcca
import "gauge.tcca";
plant Tank { gauge : Gauge; })"},
    CodeInfo{Code::import_cycle, "files import each other",
             "A file imports itself, directly or by way of others. Put what both need into a third file.",
             R"($ rmplc compile entry.rmpl -o model.json
// entry.rmpl
import "descent.rmpl";
Entry() :: { engine = standby; Descent() }
// descent.rmpl
import "entry.rmpl";
Descent() :: { engine = on })",
             R"(// entry.rmpl
import "descent.rmpl";
Entry() :: { engine = standby; Descent() }
// descent.rmpl
Descent() :: { engine = on })"},
    CodeInfo{Code::too_many_errors, "too many syntax errors",
             "After 100 syntax errors the rest of the text is not read. Check that the text is in the language that "
             "the ending of the file name stands for.",
             R"($ seq 200 | sed 's/$/;/' > plant.tcca  # no plant at all: the numbers from 1 to 200
$ rmplc compile plant.tcca -o model.json 2>&1 | grep --after-context=4 RMPL0008)",
             R"(// plant.tcca
component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
plant Tank { gauge : Gauge; })"},
    CodeInfo{Code::text_too_long, "text too long", "A source text may have 4 GiB - 1 bytes.",
             R"($ truncate --size=5G main.rmpl
$ rmplc compile --max-input 8G main.rmpl -o model.json)",
             R"(Main() :: { engine = on })"},
    CodeInfo{Code::too_large, "model too large",
             "A plant may have at most 4 million values, modes and transitions altogether. A few lines can exceed this "
             "limit: a module of ten modules of ten modules, and so on.",
             R"(component Gauge {
  initial ok;
  mode ok;
}
module A { a, b, c, d, e, f, g, h, i, j : Gauge; }
module B { a, b, c, d, e, f, g, h, i, j : A; }
module C { a, b, c, d, e, f, g, h, i, j : B; }
module D { a, b, c, d, e, f, g, h, i, j : C; }
module E { a, b, c, d, e, f, g, h, i, j : D; }
module F { a, b, c, d, e, f, g, h, i, j : E; }
plant Tanks { a, b, c, d, e, f, g, h, i, j : F; })",
             R"(component Gauge {
  initial ok;
  mode ok;
}
module A { a, b, c, d, e, f, g, h, i, j : Gauge; }
plant Tanks { a, b, c, d, e, f, g, h, i, j : A; })"},
};

}  // namespace

std::span<const CodeInfo> text_codes() { return text_table; }

}  // namespace rmpl::grammar
