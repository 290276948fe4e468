# The classics of tests/bench/distinct as an engineer writes them: what keeps a time, a place or a token is a component.
# SPDX-License-Identifier: MIT
"""A timer is a component with the modes `idle`, `run` and `over`, and what waits for it asks it. A variable that several
share (a fork, a machine, the number in a cell) is a component, and who changes it tells it so. Guards ask attributes.
Delays are arguments, as in tests/bench/distinct."""


def numbers(n):
    return range(1, n + 1)


def pairs(names):
    return ' | '.join(f'{a} & {b}' for i, a in enumerate(names) for b in names[i + 1:])


def listed(n, prefix='i', first=()):
    return ', '.join([*first, *(f'{prefix}{i}' for i in numbers(n))])


def timer(name, seconds, initial='idle'):
    """Starts anew where it is told to while it runs."""
    return f"""
component {name} {{
  input  starts, stops : Bool;
  output over : Bool;
  initial {initial};
  mode idle {{ over = no }};
  mode run  {{ over = no }};
  mode over {{ over = yes }};
  idle -> run  when starts = yes;
  over -> run  when starts = yes;
  run  -> run  restart when starts = yes;
  run  -> over after {seconds} s;
  run  -> idle when stops = yes & starts = no;
  over -> idle when stops = yes & starts = no;
}}"""


def window(name, lower, upper):
    """A timer that tells from when on something may be, and when it has to be."""
    return f"""
component {name} {{
  input  starts, stops : Bool;
  output may, due : Bool;
  initial idle;
  mode idle  {{ may = no  & due = no }};
  mode early {{ may = no  & due = no }};
  mode open  {{ may = yes & due = no }};
  mode late  {{ may = yes & due = yes }};
  idle  -> early when starts = yes;
  early -> open  after {lower} s;
  open  -> late  after {upper - lower} s;
  any   -> idle  when stops = yes;
}}"""


def until(name, initial, before, after, seconds, told):
    """A timer that tells by an attribute in which of its modes it is."""
    def says(mode):
        return f'{told} = {"yes" if mode == told else "no"}'
    width = max(len('idle'), len(before), len(after))
    modes = '\n'.join(f'  mode {mode:{width}} {{ {says(mode)} }};' for mode in ('idle', before, after))
    arrows = max(len('idle'), len(before), len('any'))
    return f"""
component {name} {{
  input  starts, stops : Bool;
  output {told} : Bool;
  initial {initial};
{modes}
  {'idle':{arrows}} -> {before:{width}} when starts = yes;
  {before:{arrows}} -> {after:{width}} after {seconds} s;
  {'any':{arrows}} -> {'idle':{width}} when stops = yes;
}}"""


def philosophers(n, delays):
    lines = [f'// never: {" | ".join(f"p{i} = eating & p{i % n + 1} = eating" for i in numbers(n))}',
             f'domain Turn = {{ {listed(n, first=("nobody",))} }};', 'domain Bool = { no, yes };', """
component Fork {
  input  takes_left, takes_right, drops_left, drops_right : Bool;   // what its neighbours do
  output free : Bool;
  initial lies;
  mode lies { free = yes };
  mode held { free = no };
  lies -> held when takes_left = yes | takes_right = yes;
  held -> lies when drops_left = yes | drops_right = yes;
}"""]
    for i in numbers(n):
        patience, eats = delays(i)
        lines += [timer(f'Patience{i}', patience), timer(f'Meal{i}', eats), f"""
component Philosopher{i} {{
  input  turn : Turn;          // whose step the scheduler takes
  input  left, right : Bool;   // the forks that are free
  input  bored, full : Bool;   // what the timers say
  output takes_left, takes_right, drops_left, drops_right : Bool;

  initial idle;
  mode idle {{
    (takes_left = yes <-> turn = i{i} & left = yes) & takes_right = no & drops_left = no & drops_right = no
  }};
  mode waiting {{
    takes_left = no & (takes_right = yes <-> turn = i{i} & right = yes & bored = no) & drops_left = bored & drops_right = no
  }};
  mode eating  {{ takes_left = no & takes_right = no & drops_left = no & drops_right = full }};
  mode leaving {{ takes_left = no & takes_right = no & drops_left = yes & drops_right = no }};

  idle    -> waiting when takes_left = yes;
  waiting -> eating  when takes_right = yes;
  waiting -> idle    when drops_left = yes;
  eating  -> leaving when drops_right = yes;
  leaving -> idle;
}}"""]
    lines.append('\nplant Table {')
    for i in numbers(n):
        lines.append(f'  p{i} : Philosopher{i};  f{i} : Fork;  patience{i} : Patience{i};  meal{i} : Meal{i};')
    for i in numbers(n):
        left, after = (i - 2) % n + 1, i % n + 1
        lines.append(f"""  p{i}.left = f{left}.free;  p{i}.right = f{i}.free;
  p{i}.bored = patience{i}.over;  p{i}.full = meal{i}.over;
  patience{i}.starts = p{i}.takes_left;  meal{i}.starts = p{i}.takes_right;  meal{i}.stops = p{i}.drops_right;
  patience{i}.stops = yes <-> p{i}.takes_right = yes | p{i}.drops_left = yes;
  f{i}.takes_right = p{i}.takes_right;  f{i}.drops_right = p{i}.drops_right;
  f{i}.takes_left = p{after}.takes_left;  f{i}.drops_left = p{after}.drops_left;""" + (f'\n  p{i}.turn = p1.turn;' if i > 1 else ''))
    lines.append('  control p1.turn default nobody;\n}')
    return '\n'.join(lines)


def critical_region(n, delay):
    lines = [f'// never: {pairs([f"c{i} = critical" for i in numbers(n)])}',
             f'domain Turn = {{ {listed(n, first=("nobody", "counter"))} }};',
             f'domain Word = {{ {listed(n, prefix="w", first=("same", "w0"))} }};', 'domain Bool = { no, yes };', """
component Counter {
  input  turn : Turn;
  input  word : Word;
  output value : Word;

  initial start;
  mode start { value = w0 };"""]
    lines += [f'  mode w{i} {{ value = w{i} }};' for i in range(n + 1)]
    lines += [f'  w{i} -> w{i % n + 1} when turn = counter;' for i in numbers(n)]
    lines.append('  start -> w1 when turn = counter;')
    lines += [f'  any -> w{i} when word = w{i};' for i in range(n + 1)]
    lines.append('}')
    for i in numbers(n):
        quiet = 'enters = no & exits = no & begins = no & ends = no & begins_long = no & ends_long = no'

        def signals(quiet=quiet, **told):
            parts = [part for part in quiet.split(' & ') if part.split(' = ')[0] not in told]
            return ' & '.join([*(f'({name} = yes <-> {when})' for name, when in told.items()), *parts])
        lines += [timer(f'Short{i}', delay(i)), timer(f'Long{i}', 2 * delay(i), 'run'), f"""
component Cell{i} {{
  input  turn : Turn;
  input  id : Word;
  input  due, late : Bool;                                // the short timer is over, the long one
  output enters, exits : Bool;                            // the region, with its next step
  output begins, ends, begins_long, ends_long : Bool;     // what the timers do with it

  initial unready;
  mode unready {{
    {signals(begins=f'turn = i{i} & late = no', ends_long=f'late = yes | turn = i{i}')}
  }};
  mode resting {{ {quiet} }};
  mode testing {{
    {signals(ends=f'due = yes | turn = i{i}', begins_long='due = yes')}
  }};
  mode requesting {{
    {signals(enters=f'turn = i{i} & id = w{i}', begins=f'turn = i{i} & id = w{i}', begins_long=f'turn = i{i} & id = w{i}')}
  }};
  mode critical {{
    {signals(exits=f'turn = i{i} & due = no', begins=f'turn = i{i} & due = no', ends='late = yes',
             ends_long=f'late = yes | turn = i{i} & due = no')}
  }};
  mode leaving {{
    {signals(ends=f'due = yes | turn = i{i}')}
  }};
  mode safe  {{ {quiet} }};
  mode error {{ {quiet} }};

  unready    -> testing    when begins = yes;
  unready    -> resting    when late = yes;
  testing    -> requesting when turn = i{i} & due = no;
  testing    -> unready    when due = yes;
  requesting -> critical   when enters = yes;
  critical   -> leaving    when exits = yes;
  critical   -> error      when late = yes;
  leaving    -> safe       when turn = i{i} & due = no;
  leaving    -> error      when due = yes;
}}"""]
    lines.append('\nplant Region {\n  id : Counter;')
    lines += [f'  c{i} : Cell{i};  short{i} : Short{i};  long{i} : Long{i};' for i in numbers(n)]
    for i in numbers(n):
        lines.append(f"""  c{i}.turn = id.turn;  c{i}.id = id.value;  c{i}.due = short{i}.over;  c{i}.late = long{i}.over;
  short{i}.starts = c{i}.begins;  short{i}.stops = c{i}.ends;
  long{i}.starts = c{i}.begins_long;  long{i}.stops = c{i}.ends_long;
  c{i}.enters = yes -> id.word = w0;  c{i}.exits = yes -> id.word = w{i};""")
    silent = ' & '.join(f'c{i}.enters = no & c{i}.exits = no' for i in numbers(n))
    lines.append(f'  {silent} -> id.word = same;\n\n  control id.turn default nobody;\n}}')
    return '\n'.join(lines)


def fddi(n, delay):
    rotation = 50 * n
    lines = [f'// never: {pairs([f"p{i}.holds = yes" for i in numbers(n)])}',
             'domain Bool = { no, yes };', 'domain Go = { stay, leave };', f"""
component Ring {{
  input  released : Bool;
  output at : {{ {listed(n, prefix="q")}, none }};
  initial q1;"""]
    lines += [f'  mode q{i} {{ at = q{i} }};\n  mode r{i} {{ at = none }};' for i in numbers(n)]
    lines += [f'  q{i} -> r{i};\n  r{i} -> q{i % n + 1} when released = yes;' for i in numbers(n)]
    lines.append('}')
    for i in numbers(n):
        held = delay(i)
        lines.append(f"""
component Station{i} {{
  input  go : Go;
  input  token : Bool;               // it comes in this step
  input  fresh_a, fresh_b : Bool;    // the rotation has not taken its time yet
  input  over_a, over_b : Bool;      // the token has been held as long as it may be
  output holds, releases : Bool;
  output starts_a, starts_b, stops_a, stops_b : Bool;

  initial q0;""")
        for half, first, other in (('a', 0, 'b'), ('b', 4, 'a')):
            waits, late, early, free, ends, then = (f'q{first}', f'q{first + 1}', f'q{first + 2}', f'q{first + 3}',
                                                   f'q{first + 1}end', f'q{(first + 4) % 8}')
            quiet = f'starts_{half} = no & stops_{other} = no'
            lines.append(f"""
  mode {waits} {{ holds = no & releases = no & {quiet} & starts_{other} = token & stops_{half} = no }};
  mode {late} {{ holds = yes & releases = no & {quiet} & starts_{other} = no & stops_{half} = no }};
  mode {ends} {{ holds = yes & releases = yes & {quiet} & starts_{other} = no & stops_{half} = yes }};
  mode {early} {{ holds = yes & releases = no & {quiet} & starts_{other} = no & stops_{half} = no }};
  mode {free} {{ holds = yes & (releases = yes <-> go = leave | over_{half} = yes) & {quiet} & starts_{other} = no
                & stops_{half} = releases }};

  {waits} -> {early} when token = yes & fresh_{half} = yes;
  {waits} -> {late} when token = yes & fresh_{half} = no;
  {late} -> {ends} after {held} s;
  {ends} -> {then};
  {early} -> {free} after {held} s;
  {free} -> {then} when releases = yes;""")
        lines.append('}')
        for half, timer, watchdog in (('A', 'fresh', 'run'), ('B', 'idle', 'idle')):
            lines += [until(f'Timer{half}{i}', timer, 'fresh', 'old', rotation, told='fresh'),
                      until(f'Watchdog{half}{i}', watchdog, 'run', 'over', rotation + held, told='over')]
    lines.append('\nplant Fddi {\n  ring : Ring;')
    for i in numbers(n):
        lines.append(f'  p{i} : Station{i};')
        lines += [f'  t{half}{i} : Timer{half.upper()}{i};  w{half}{i} : Watchdog{half.upper()}{i};' for half in 'ab']
    lines.append(f'  ring.released = yes <-> {" | ".join(f"p{i}.releases = yes" for i in numbers(n))};')
    for i in numbers(n):
        lines.append(f'  p{i}.token = yes <-> ring.at = q{i};')
        lines += [f"""  p{i}.fresh_{half} = t{half}{i}.fresh;  p{i}.over_{half} = w{half}{i}.over;
  t{half}{i}.starts = p{i}.starts_{half};  t{half}{i}.stops = p{i}.stops_{half};
  w{half}{i}.starts = p{i}.starts_{half};  w{half}{i}.stops = p{i}.stops_{half};""" for half in 'ab']
        if i > 1:
            lines.append(f'  p{i}.go = p1.go;')
    lines.append('  control p1.go default stay;\n}')
    return '\n'.join(lines)


def job_shop(makespan, work):
    """`work`: of each job, the machines and how long it needs them."""
    jobs = numbers(len(work))
    most = max(len(tasks) for tasks in work)
    steps = ', '.join(f't{t}' for t in numbers(most))
    lines = [f'// never: {" & ".join(f"j{j} = done" for j in jobs)}', f'// by: {makespan} s',
             'domain Bool = { no, yes };', f'domain Turn = {{ {listed(len(work), first=("nobody",))} }};',
             f'domain Task = {{ none, {steps} }};', """
component Machine {
  input  taken, left : Bool;
  output free : Bool;
  initial idle;
  mode idle { free = yes };
  mode busy { free = no };
  idle -> busy when taken = yes;
  busy -> idle when left = yes;
}"""]
    for j, tasks in enumerate(work, 1):
        lines.append(f"""
component Work{j} {{
  input  starts : Task;
  input  stops : Bool;
  output over : Bool;
  initial idle;
  mode idle {{ over = no }};
  mode over {{ over = yes }};
  over -> idle when stops = yes;""")
        for t, (_, duration) in enumerate(tasks, 1):
            lines.append(f'  mode t{t} {{ over = no }};\n  idle -> t{t} when starts = t{t};\n  t{t} -> over after {duration} s;')
        lines.append(f"""}}

component Job{j} {{
  input  turn : Turn;
  input  free1, free2, free3 : Bool;     // the machines
  input  over : Bool;                    // the work at one of them
  output takes1, takes2, takes3, leaves1, leaves2, leaves3 : Bool;
  output starts : Task;

  initial i1;""")

        def mode(name, takes=None, leaves=None, task='none', j=j):
            parts = []
            for m in numbers(3):
                parts.append(f'(takes{m} = yes <-> turn = i{j} & free{m} = yes)' if m == takes else f'takes{m} = no')
                parts.append(f'(leaves{m} = yes <-> turn = i{j} & over = yes)' if m == leaves else f'leaves{m} = no')
            start = f'(takes{takes} = yes -> starts = {task}) & (takes{takes} = no -> starts = none)' if takes else 'starts = none'
            lines.append(f'  mode {name} {{ {" & ".join([*parts, start])} }};')
        for t, (machine, _) in enumerate(tasks, 1):
            after = f'i{t + 1}' if t < len(tasks) else 'done'
            mode(f'i{t}', takes=machine, task=f't{t}')
            mode(f'w{t}', leaves=machine)
            lines.append(f'  i{t} -> w{t} when takes{machine} = yes;\n  w{t} -> {after} when leaves{machine} = yes;')
        mode('done')
        lines.append('}')
    lines.append('\nplant Shop {')
    lines += [f'  m{m} : Machine;' for m in numbers(3)]
    lines += [f'  j{j} : Job{j};  work{j} : Work{j};' for j in jobs]
    for m in numbers(3):
        lines.append(f'  m{m}.taken = yes <-> {" | ".join(f"j{j}.takes{m} = yes" for j in jobs)};')
        lines.append(f'  m{m}.left = yes <-> {" | ".join(f"j{j}.leaves{m} = yes" for j in jobs)};')
    for j in jobs:
        free = '  '.join(f'j{j}.free{m} = m{m}.free;' for m in numbers(3))
        lines.append(f'  {free}  j{j}.over = work{j}.over;  work{j}.starts = j{j}.starts;'
                     + f'  work{j}.stops = yes <-> {" | ".join(f"j{j}.leaves{m} = yes" for m in numbers(3))};'
                     + (f'  j{j}.turn = j1.turn;' if j > 1 else ''))
    lines.append('\n  control j1.turn default nobody;\n}')
    return '\n'.join(lines)


def train_gate(n, delays, clever):
    """`clever`: the model of examples/classics, of which gate and queue stay; the trains ask timers."""
    lines = clever.split('\ncomponent Gate {')
    domains = lines[0].split('\ncomponent Train1 {')[0]
    trains = []
    for i in numbers(n):
        times = delays(i)
        trains += [window(f'{kind.capitalize()}{i}', *times[kind]) for kind in ('approach', 'start', 'cross')]
        trains.append(f"""
component Train{i} {{
  input  me, turn : Turn;                       // its name, whose step it is
  input  admitted, stopped, called : Turn;      // what the gate says, to whom
  input  may_approach, may_start, may_cross, due_approach, due_start, due_cross : Bool;   // what the timers say
  output wants : Turn;                          // its name where it would arrive
  output over, arrives, starts, enters, leaves : Bool;

  initial safe;
  mode safe {{
    wants = me & over = no & starts = no & enters = no & leaves = no & (arrives = yes <-> admitted = me)
  }};
  mode approaching {{
    wants = nobody & over = no & arrives = no & starts = no & leaves = no
    & (enters = yes <-> due_approach = yes | turn = me & may_approach = yes)
  }};
  mode standing {{
    wants = nobody & over = no & arrives = no & enters = no & leaves = no & (starts = yes <-> called = me)
  }};
  mode starting {{
    wants = nobody & over = no & arrives = no & starts = no & leaves = no
    & (enters = yes <-> due_start = yes | turn = me & may_start = yes)
  }};
  mode crossing {{
    wants = nobody & over = no & arrives = no & starts = no & enters = no
    & (leaves = yes <-> due_cross = yes | turn = me & may_cross = yes)
  }};
  mode leaving {{ wants = nobody & over = yes & arrives = no & starts = no & enters = no & leaves = no }};   // in no time

  safe        -> approaching when arrives = yes;
  safe        -> standing    when stopped = me;
  approaching -> crossing    when enters = yes;
  standing    -> starting    when starts = yes;
  starting    -> crossing    when enters = yes;
  crossing    -> leaving     when leaves = yes;
  leaving     -> safe;
}}""")
    rest = '\ncomponent Gate {' + lines[1]
    for i in numbers(n):
        rest = rest.replace(f'  t{i} : Train{i};\n',
                            f'  t{i} : Train{i};  approach{i} : Approach{i};  start{i} : Start{i};  cross{i} : Cross{i};\n')
        asks = '  '.join(f't{i}.{what}_{kind} = {kind}{i}.{what};' for what in ('may', 'due') for kind in ('approach', 'start', 'cross'))
        rest = rest.replace(f'  t{i}.me = i{i};', f"""  {asks}
  approach{i}.starts = t{i}.arrives;  start{i}.starts = t{i}.starts;  cross{i}.starts = t{i}.enters;
  approach{i}.stops = t{i}.enters;  start{i}.stops = t{i}.enters;  cross{i}.stops = t{i}.leaves;
  t{i}.turn = gate.turn;  t{i}.me = i{i};""")
    return '\n'.join([domains, *trains]) + rest
