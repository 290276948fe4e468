# %% [markdown]
# # Three estimators on one plant
#
# The same flight is told to three estimators: exact, k-best, and a window that revises what it believed. The numbers are those of
# `rmpl-run estimate` over the same log, for both call the same functions.
#
# Open this file in Jupyter, VS Code or Spyder, or run it: `python3 examples/notebook/estimators.py`. From the build tree it takes
# `PYTHONPATH=build/release/python`.

# %%
# SPDX-License-Identifier: MIT
import pathlib
import time

import rmpl

HERE = pathlib.Path(globals().get("__file__", "examples/notebook/estimators.py")).resolve().parent
propulsion = HERE.parent / "propulsion"
plant = rmpl.compile(propulsion / "propulsion.tcca")
plant  # a notebook shows the plant as a picture

# %% [markdown]
# ## A flight with a surprise
#
# The burn is flown with a valve that sticks. Its trace is the log: what was commanded, and what was seen.

# %%
flight = rmpl.fly(propulsion / "burn.scn", "a valve sticks closed", trace="cycles")
print(flight.story)
flight  # a notebook shows the report

# %%
log = [{key: line[key] for key in ("time", "command", "observations")} for line in flight.trace if line["cycle"] > 0]
print(len(log), "lines")

# %% [markdown]
# ## What each believes
#
# Exact keeps every state that is possible. k-best keeps the best of them, and says at most how much it may miss.

# %%
exact = rmpl.Estimator(plant, estimator="exact")
few = rmpl.Estimator(plant, estimator="k-best", k=4)
surprises = []
for line in log:
    whole, best = exact.update(**line), few.update(**line)
    if whole.estimate != best.estimate:
        surprises.append(line["time"])
print(f"exact: {len(whole)} states; k-best: {len(best)} states, which miss at most {best.missing_mass:.3g}")
print("they name other modes at:", surprises or "no time")
print("valve1, exact: ", {mode: round(share, 6) for mode, share in whole.marginal("valve1").items()})
print("valve1, k-best:", {mode: round(share, 6) for mode, share in best.marginal("valve1").items()})

# %% [markdown]
# ## What a window revises
#
# An estimator says what is so now. With a window it also says what most likely was so, and where a reading changed that. Here the
# pressure behind the valve is not heard for two seconds: meanwhile the valve is believed open, as it was commanded.

# %%
window = rmpl.Estimator(plant, estimator="exact", window=8)
for line in log:
    heard = {name: value for name, value in line["observations"].items() if name != "valve1.outlet" or not 56 <= line["time"] < 58}
    seen = window.update(line["time"], line["command"], heard)
    for revision in seen.answer["revised"]:
        changed = {name: (revision["before"][name], mode) for name, mode in revision["modes"].items() if revision["before"][name] != mode}
        print(f"at {seen.time} s: what was so at {revision['time']} s is now thought otherwise: {changed}")

# %% [markdown]
# ## What it costs

# %%
for name, options in {"exact": {"estimator": "exact"}, "k-best, 16 states": {}, "k-best, 4 states": {"k": 4},
                      "exact, window of 8": {"estimator": "exact", "window": 8}}.items():
    begin = time.process_time()
    rmpl.estimate(plant, log, **options)
    print(f"{name}: {1e6 * (time.process_time() - begin) / len(log):.0f} us an update")

# %% [markdown]
# ## As a table
#
# Where pandas is installed, every answer is a frame too.

# %%
try:
    print(whole.frame().head().to_string())
except ImportError as error:
    print(error)
