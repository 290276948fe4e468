#!/usr/bin/env python3
# The completions of the shells know every subcommand and option that --help lists, and complete them.
# SPDX-License-Identifier: MIT
"""Usage: completions.py PROGRAMS.  Shells that are not there are named and left out; without any, exit code 77."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
PROGRAMS = ("rmplc", "rmpl-run", "tcca-check")
OPTION = re.compile(r"(?<![\w-])--?[a-zA-Z][a-z-]*")
# What is typed, and what has to be offered for it, per program.
# zsh completes on a terminal only: it gets one, with a key that shows what stands in the line.
TERMINAL = r"""
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell 'show() { print -r -- "<$BUFFER>"; BUFFER= }; zle -N show; bindkey "^T" show'
zpty -w shell 'fpath=(%(folder)s $fpath); autoload -U compinit; compinit -u -D; print READ""Y'
zpty -r shell said '*READY*'
zpty -n -w shell $'%(line)s\t\C-t'
zpty -r shell said '*<*>*'
print -r -- $said
"""
TYPED = (("rmplc", ["comp"], ["compile"]), ("rmplc", ["compile", "--fo"], ["--format"]),
         ("rmplc", ["compile", "--format", "j"], ["json"]), ("rmplc", ["--color", "n"], ["never"]),
         ("rmpl-run", ["diag"], ["diagnose"]), ("tcca-check", ["safety", "--commands", "a"], ["any"]))


def run(*words, **options):
    return subprocess.run([str(word) for word in words], stdin=subprocess.DEVNULL, capture_output=True, timeout=60,
                          check=False, text=True, **options)


def listed(text):
    """The options of a help: the lines of them begin with two blanks and a dash."""
    return {option for line in text.splitlines() if re.match(r"  -", line)
            for option in OPTION.findall(line.split("  ")[1])}


def scripts(programs, program, folder):
    """The script of each shell, under the name that it is installed as."""
    for shell, name in (("bash", program), ("zsh", f"_{program}"), ("fish", f"{program}.fish")):
        path = folder / name
        path.write_text(run(programs / program, "--completion", shell).stdout, encoding="utf-8")
        yield shell, path


def forgotten(programs, program, shell, text):
    """Subcommands and options that a script does not name."""
    help_text = run(programs / program, "--help").stdout
    commands = re.findall(r"^  ([a-z]+) ", help_text.split("\nSubcommands:")[1].split("\n\n")[0], re.MULTILINE)
    for command in ("", *commands):
        if command and not re.search(rf"\b{command}\b", text):
            yield f"{program}: the {shell} completion does not name {command}"
        for option in sorted(listed(run(programs / program, *command.split(), "--help").stdout)):
            form = option
            if shell == "fish":
                form = f"-l {option[2:]}" if option.startswith("--") else f"-s {option[1:]}"
                start = rf"^complete -c {program}.*" if option in ("-h", "--help") or not command else \
                    rf"^complete -c {program}.*(from {command}'|).*"
                pattern = start + re.escape(form) + r"\b"
            else:
                pattern = rf"(?<![\w-]){re.escape(form)}(?![\w-])"
            if not re.search(pattern, text, re.MULTILINE):
                yield f"{program} {command}: the {shell} completion does not name {option}"


def offered(shell, path, program, words):
    """What a shell offers for the last of the words."""
    if shell == "bash":
        line = " ".join(f"'{word}'" for word in [program, *words])
        function = "_" + program.replace("-", "_")
        done = run("bash", "--norc", "-c", f"source '{path}'; COMP_WORDS=({line}); COMP_CWORD={len(words)}; {function}; "
                   "printf '%s\\n' \"${COMPREPLY[@]}\"")
    elif shell == "zsh":
        script = TERMINAL % {"folder": path.parent, "line": " ".join([program, *words])}
        done = run("zsh", "-f", "-c", script, env=dict(os.environ, TERM="xterm"))
        line = re.findall(r"<([^<>$]*)>", done.stdout)[-1:]
        return [line[0].split()[-1].rstrip("=")] if line else [], done.stderr
    else:
        done = run("fish", "--no-config", "-c", f"source '{path}'; complete --do-complete '{' '.join([program, *words])}'")
    return [line.split("\t")[0] for line in done.stdout.splitlines()], done.stderr


def complaints(programs, shells, folder):
    for program in PROGRAMS:
        for shell, path in scripts(programs, program, folder):
            yield from forgotten(programs, program, shell, path.read_text(encoding="utf-8"))
            if shell not in shells:
                continue
            for of, words, expected in TYPED:
                if of != program:
                    continue
                found, said = offered(shell, path, program, words)
                if found != expected or said:
                    yield f"{program} {' '.join(words)}: {shell} offers {found}, expected {expected} {said}"


def main(programs):
    shells = [shell for shell in ("bash", "zsh", "fish") if shutil.which(shell)]
    for shell in ("bash", "zsh", "fish"):
        if shell not in shells:
            print(f"skipped: there is no {shell}")
    if not shells:
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        found = list(complaints(programs, shells, pathlib.Path(folder)))
    print("\n".join([*found, f"{', '.join(shells)}: {len(found)} complaints"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
