#!/usr/bin/env python3
# The maker of density_table.inc: step probabilities of timed transitions in decimal arithmetic, without any scaling.
#   tests/unit/automata/time/density_table.py > tests/unit/automata/density_table.inc
# SPDX-License-Identifier: MIT
from decimal import Decimal, InvalidOperation, getcontext, ROUND_HALF_EVEN

NS = 10**9
INFINITE = 2**63 - 1
getcontext().prec = 420  # exp(-722), the probability of 38 standard deviations below the mean, and a nanosecond of it
getcontext().Emin, getcontext().Emax = -(10**17), 10**17
getcontext().rounding = ROUND_HALF_EVEN


def arctan_inverse(n):
    term = total = Decimal(1) / n
    k = 1
    while abs(term) > Decimal(10) ** -430:
        term /= -n * n
        k += 2
        total += term / k
    return total


PI = 4 * (4 * arctan_inverse(5) - arctan_inverse(239))


def erfc(x):
    if x < 0:
        return 2 - erfc(-x)
    if x < 6:  # the series of Maclaurin: terms up to exp(36), which the precision has room for
        term = total = x
        n = 0
        while abs(term) > Decimal(10) ** -420:
            n += 1
            term = -term * x * x / n
            total += term / (2 * n + 1)
        return 1 - 2 * total / PI.sqrt()
    # The continued fraction of Laplace.
    levels = 4 + int((200 / float(x)) ** 2) if x < 10**6 else 40
    tail = x
    for level in range(levels, 0, -1):
        tail = x + Decimal(level) / (2 * tail)
    return (-x * x).exp() / (tail * PI.sqrt())


def tail(kind, mean, deviation, ticks):
    t = Decimal(ticks) / NS
    if kind == 'exponential':
        return (-t / Decimal(mean)).exp()
    if kind == 'normal':
        return erfc((t - Decimal(mean)) / Decimal(deviation) / Decimal(2).sqrt()) / 2
    if kind == 'weibull':  # of shape `mean` and scale `deviation`
        return Decimal(1) if t == 0 else (-((t / Decimal(deviation)).ln() * Decimal(mean)).exp()).exp()
    if kind == 'erlang':  # of `mean` stages with the mean `deviation`
        x = t * int(mean) / Decimal(deviation)
        term = total = Decimal(1)
        for i in range(1, int(mean)):
            term *= x / i
            total += term
        return (-x).exp() * total
    return -t


def masses(kind, mean, deviation, lower, upper, start, end):
    """P(fires), P(survives), -ln P(survives) of the step from start to end, lower <= start < end < upper."""
    at = lambda ticks: tail(kind, mean, deviation, ticks)
    last = Decimal(0) if upper == INFINITE else at(upper)
    rest, after = at(start) - last, at(end) - last
    if rest < abs(last) * Decimal('1e-340'):
        raise InvalidOperation
    return (rest - after) / rest, after / rest, -(after / rest).ln()


def text(number):
    return format(number.quantize(Decimal(1)) if number == 0 else +number, '.16e')


def row(kind, mean, deviation, lower, upper, start, end):
    if end > 9 * 10**18 or upper != INFINITE and upper > 9 * 10**18:
        return  # beyond the range of ticks
    try:
        fires, survives, hazard = masses(kind, mean, deviation, lower, upper, start, end)
    except InvalidOperation:
        return  # too little mass for the precision
    least = Decimal('1e-300')
    shown = [text(x) if x > least else '0' for x in (fires, survives, hazard)]
    if kind == 'erlang' and shown[0] == '0':
        return
    top = 'endless' if upper == INFINITE else str(upper)
    print(f'{{Density::Kind::{kind}, {mean!r}, {deviation!r}, {lower}, {top}, {start}, {end}, {", ".join(shown)}}},')


def ages(mean):
    return [int(Decimal(mean) * a * NS) for a in map(Decimal, ('0', '1e-6', '0.3', '1', '17', '700', '744', '746', '1e4', '1e6'))]


print('// Made by density_table.py: kind, mean, deviation, lower, upper, from, to (ns); fires, survives, hazard. 0: too small.')
STEPS = [1, 1000, NS // 3, 60 * NS]
for step in STEPS:
    for mean in (1.0, 8640.0):
        for age in ages(mean):
            row('exponential', mean, 0.0, 0, INFINITE, age, age + step)
            for bound in (2 * age + 10 * step, age + step + 1):
                row('exponential', mean, 0.0, age // 2, bound, age, age + step)
    for bounds in ((0, 86400000 * NS), (30 * NS, 7230 * NS), (5, 2 * 10**18)):
        for part in (0, 3, 500, 999):
            start = bounds[0] + (bounds[1] - bounds[0]) * part // 1000
            if start + step < bounds[1]:
                row('uniform', 0.0, 0.0, bounds[0], bounds[1], start, start + step)
    for mean, deviation in ((40.0, 1.0), (100.0, 10.0), (0.3, 0.001), (86400.1, 3.7), (1e6, 1.0)):
        for z in ('-38', '-6', '-1', '-1e-9', '0', '0.5', '2', '7', '20', '39', '1000', '1e6'):
            start = int((Decimal(mean) + Decimal(deviation) * Decimal(z)) * NS)
            if start < 0:
                continue
            if step < 10**4 * deviation * NS:
                row('normal', mean, deviation, 0, INFINITE, start, start + step)
                row('normal', mean, deviation, start // 2, start + 2 * step + int(3 * deviation * NS), start, start + step)
                row('normal', mean, deviation, start // 2, start + step + 1, start, start + step)
    for shape, scale in ((0.3, 10.0), (0.75, 8640.0), (1.5, 1.0), (2.0, 3600.0), (4.25, 86400.0), (40.0, 100.0)):
        for age in ages(scale)[:6]:
            if step < 10**4 * scale * NS:
                row('weibull', shape, scale, 0, INFINITE, age, age + step)
                row('weibull', shape, scale, age // 2, 2 * age + 10 * step, age, age + step)
                row('weibull', shape, scale, age // 2, age + step + 1, age, age + step)
    for stages, mean in ((2.0, 1.0), (3.0, 3600.0), (10.0, 40.0), (100.0, 86400.0)):
        for age in [*ages(mean)[:6], int(mean * 0.9 * NS), int(mean * 1.1 * NS), int(mean * 7 * NS)]:
            if step < 10**4 * mean * NS:
                row('erlang', stages, mean, 0, INFINITE, age, age + step)
                row('erlang', stages, mean, age // 2, 2 * age + 10 * step, age, age + step)
                row('erlang', stages, mean, age // 2, age + step + 1, age, age + step)
