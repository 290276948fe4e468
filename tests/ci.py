#!/usr/bin/env python3
# The examples for other people's continuous integration, run as far as they go without the services.
# SPDX-License-Identifier: MIT
"""Usage: ci.py ROOT PROGRAMS.

The commands of docs/ci/*.yml run on the example that they name, but for those that install; what they write is held
against its schema. The steps of action.yml run as a service runs them. The hooks run under pre-commit itself, on a good model and on one with a fault. What lacks a tool is
named and left out; without any of them the exit code is 77.
"""

import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
EXAMPLE = "examples/propulsion"
ACTION_INPUT = re.compile(r"\$\{\{ inputs\.([\w-]+) \}\}")
TOOLS = {"workflows": "a module yaml (python3-yaml)", "xmllint": "xmllint (libxml2-utils)",
         "jsonschema": "a module jsonschema (python3-jsonschema)", "pre-commit": "pre-commit"}
ANNOTATION = re.compile(r"::(error|warning|notice) file=[^,]+,line=\d+(,\w+=[^,:]*)*::\S.*")


def has(tool):
    if tool in ("xmllint", "pre-commit"):
        return shutil.which(tool) is not None
    return importlib.util.find_spec({"workflows": "yaml"}.get(tool, tool)) is not None


def shell(line, folder, environment):
    return subprocess.run(["sh", "-e", "-c", line], cwd=folder, env=environment, stdin=subprocess.DEVNULL, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300, check=False)


def commands_of(document):
    """The shell commands of a workflow in order, and the variables that it sets for them."""
    if "jobs" in document:
        for job in document["jobs"].values():
            yield from ((step["run"], document.get("env", {})) for step in job["steps"] if "run" in step)
    else:
        for job in document.values():
            yield from ((line, job["variables"]) for line in [*job["before_script"], *job["script"]])


def copied(root, folder, environment):
    """A place with the files of the example, in the one style."""
    shutil.copytree(root / EXAMPLE, folder, ignore=shutil.ignore_patterns("README.md"))
    shell("rmplc format *.rmpl *.tcca *.scn *.props", folder, environment)
    return folder


def with_a_fault(folder):
    """The same transition twice: a warning."""
    plant = folder / "propulsion.tcca"
    text = plant.read_text(encoding="utf-8")
    line = next(line for line in text.splitlines(keepends=True) if re.match(r"  \w+ -> \w+ .*;$", line))
    plant.write_text(text.replace(line, line + line, 1), encoding="utf-8")
    return folder


def run_workflow(path, root, environment, work):
    """Runs what a workflow runs, and gives where."""
    import yaml  # pylint: disable=import-outside-toplevel
    folder = copied(root, work / path.stem, environment)
    for command, variables in commands_of(yaml.safe_load(path.read_text(encoding="utf-8"))):
        if "apt-get" in command:
            continue
        done = shell(command, folder, environment | variables)
        if done.returncode != 0:
            yield f"{path.name}: {command!r} ends with {done.returncode}\n{done.stdout}"


def invalid(folder, root):
    """What the workflows wrote and their schemas refuse."""
    for name in ("scenarios.xml", "properties.xml"):
        if has("xmllint"):
            done = subprocess.run(["xmllint", "--noout", "--schema", root / "grammar/schema/junit.xsd", name],
                                  cwd=folder / "gitlab", capture_output=True, text=True, timeout=60, check=False)
            if done.returncode != 0:
                yield f"{name}: {done.stderr}"


def findings(root, environment, work):
    """A fault is told in the forms of the services, too."""
    folder = with_a_fault(copied(root, work / "fault", environment))
    told = shell("rmplc lint burn.scn --format github", folder, environment)
    lines = told.stdout.splitlines()
    if told.returncode != 1 or not lines or not all(ANNOTATION.fullmatch(line) for line in lines):
        yield f"--format github ends with {told.returncode}:\n{told.stdout}"
    told = shell("rmplc lint burn.scn --format sarif", folder, environment)
    if told.returncode != 1:
        yield f"--format sarif ends with {told.returncode}:\n{told.stdout}"
        return
    results = [result["ruleId"] for run in json.loads(told.stdout)["runs"] for result in run["results"]]
    if "RMPL0500" not in results:
        yield f"--format sarif has {results}"
    if has("jsonschema"):
        import jsonschema  # pylint: disable=import-outside-toplevel
        schema = json.loads((root / "grammar/schema/sarif.schema.json").read_text(encoding="utf-8"))
        for error in jsonschema.validators.validator_for(schema)(schema).iter_errors(json.loads(told.stdout)):
            yield f"--format sarif: {error.json_path}: {error.message}"


def act(root, folder, environment, **inputs):
    """Runs the steps of action.yml as a service does, and gives the result of the last. Expressions but for inputs stay."""
    import yaml  # pylint: disable=import-outside-toplevel
    action = yaml.safe_load((root / "action.yml").read_text(encoding="utf-8"))
    given = {name: inputs.get(name, entry.get("default", "")) for name, entry in action["inputs"].items()}
    for step in action["runs"]["steps"]:
        variables = {name: ACTION_INPUT.sub(lambda match: given[match[1]], value) for name, value in step["env"].items()}
        place = folder / ACTION_INPUT.sub(lambda match: given[match[1]], step.get("working-directory", "."))
        done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]], cwd=place, text=True,
                              env=environment | variables, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=300, check=False)
        if done.returncode != 0:
            break
    return done


def action(root, environment, work):
    """The action passes on a good model, annotates a fault, and runs nothing that stands in its inputs."""
    folder = copied(root, work / "action/models", environment)
    for words in ({"files": "burn.scn propulsion.props"}, {"files": "*.scn", "level": "error"}):
        done = act(root, folder.parent, environment, **words, **{"working-directory": "models"})
        if done.returncode != 0:
            yield f"action.yml with {words} ends with {done.returncode}:\n{done.stdout}"
    done = act(root, with_a_fault(folder), environment, files="burn.scn")
    annotations = [line for line in done.stdout.splitlines() if ANNOTATION.fullmatch(line)]
    if done.returncode != 1 or not any("RMPL0500" in line for line in annotations):
        yield f"action.yml on a fault ends with {done.returncode}:\n{done.stdout}"
    done = act(root, folder, environment, files="$(touch broken) ; touch broken")
    if done.returncode != 2 or (folder / "broken").exists():
        yield f"action.yml runs what its input says:\n{done.stdout}"


def git(folder, *words):
    subprocess.run(["git", "-c", "user.name=t", "-c", "user.email=t@example.invalid", "-c", "init.defaultBranch=main",
                    *words], cwd=folder, check=True, capture_output=True, timeout=60)


def hooks(root, environment, work):
    """The hooks by pre-commit's own rules: they pass on the example, and stop a commit with a fault."""
    environment = environment | {"PRE_COMMIT_HOME": str(work / "home"), "GIT_CONFIG_NOSYSTEM": "1"}
    manifest = root / ".pre-commit-hooks.yaml"
    checked = shell(f"pre-commit validate-manifest '{manifest}'", work, environment)
    if checked.returncode != 0:
        yield checked.stdout
    ours = work / "hooks"
    ours.mkdir()
    shutil.copy(manifest, ours)
    for words in (["init"], ["add", "."], ["commit", "-m", "hooks"], ["tag", "v0.1.0"]):
        git(ours, *words)
    config = (root / "docs/ci/pre-commit.yml").read_text(encoding="utf-8")
    for name, expected in (("good", 0), ("bad", 1)):
        folder = copied(root, work / name, environment)
        if expected:
            with_a_fault(folder)
        (folder / ".pre-commit-config.yaml").write_text(
            re.sub(r"repo: \S+", f"repo: {ours}", config), encoding="utf-8")
        for words in (["init"], ["add", "."]):
            git(folder, *words)
        done = shell("pre-commit run --all-files --color never", folder, environment)
        if done.returncode != expected or ("RMPL0500" in done.stdout) != bool(expected):
            yield f"pre-commit on the {name} model ends with {done.returncode}:\n{done.stdout}"


def complaints(root, programs, present, work):
    environment = dict(os.environ, PATH=f"{programs}{os.pathsep}{os.environ['PATH']}", LC_ALL="C.UTF-8")
    if "workflows" in present:
        for path in (root / "docs/ci/github.yml", root / "docs/ci/gitlab.yml"):
            yield from run_workflow(path, root, environment, work)
        yield from invalid(work, root)
        yield from action(root, environment, work)
    yield from findings(root, environment, work)
    if "pre-commit" in present:
        yield from hooks(root, environment, work)


def main(root, programs):
    present = [tool for tool in TOOLS if has(tool)]
    for tool in TOOLS:
        if tool not in present:
            print(f"skipped: there is no {TOOLS[tool]}")
    if not present:
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        found = list(complaints(root, programs, present, pathlib.Path(folder)))
    print("\n".join([*found, f"{', '.join(present)}: {len(found)} complaints"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(word).resolve() for word in sys.argv[1:])))
