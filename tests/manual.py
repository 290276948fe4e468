#!/usr/bin/env python3
# The manual, --help and the parser agree: every option of every subcommand, in both directions.
# SPDX-License-Identifier: MIT
"""Usage: manual.py ROOT PROGRAMS.

In man/PROGRAM.1.scd the section OPTIONS is divided by headings that name subcommands (`## reachability, safety`), or
`## everywhere`; below one, a line that begins with an option defines the options that stand in it in bold. What is
there for a subcommand has to be what its --help lists, and what its parser takes: of all options of a program it
refuses the others as unknown. What the parser says of a command line is in the words of the house.

A page of a language, man/LANGUAGE.5.scd, has every word of grammar/LANGUAGE.ebnf in bold. A block that begins with
`// FILE` is that file; one that begins with `$ ` has commands over these files, which end well and print what follows
them. Where no command names a file, `rmplc format` reads it. Each page is built, and a page that another one names is
there.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

OPTION = re.compile(r"(?<![\w-])--?[a-zA-Z][a-z-]*")
# Words of the option parser that people should never see.
RAW = re.compile(r"\bTEXT\b|\bUINT\b|\bINT\b|\bFLOAT\b|REQUIRED|Excludes:|Needs:|\[Option|Could not|not in range|Value |"
                 r"required but|were not expected|is required|At Most|Exactly|\bx 2\b", re.MULTILINE)

LANGUAGES = ("rmpl", "tcca", "scn", "props", "mon")
WITH_EXAMPLES = ("scn", "props", "mon")  # whole files
OF_OTHERS = {"editrc.5", "mpirun.1", "timeout.1"}
BLOCK = re.compile(r"^```\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def run(*words):
    done = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, timeout=60, check=False)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def in_help(text):
    """The options that a help lists: each line of them begins with two blanks and a dash."""
    return {option for line in text.splitlines() if re.match(r"  -", line)
            for option in OPTION.findall(line.split("  ")[1])}


def in_manual(path, subcommands):
    """Per subcommand the options that its manual page promises, and those that it promises for all."""
    promised = {name: set() for name in subcommands}
    everywhere, names, inside = set(), [], False
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("# "):
            inside, names = line == "# OPTIONS", []
        elif line.startswith("## ") and inside:
            names = line[3:].split(", ")
        elif line.startswith("*-") and inside:
            options = {o for bold in re.findall(r"\*(-[^*]*)\*", line) for o in OPTION.findall(bold)}
            for name in names:
                (everywhere if name == "everywhere" else promised.setdefault(name, set())).update(options)
    return promised, everywhere


def differences(of, manual, help_):
    for option in sorted(manual - help_):
        yield f"{of}: the manual promises {option}, --help does not"
    for option in sorted(help_ - manual):
        yield f"{of}: --help lists {option}, the manual does not"


def refusals(program, name, own, all_options):
    """What is wrong with how the parser takes each option."""
    for option in sorted(all_options):
        for words in ([option], [option + "=x" if option.startswith("--") else option]):
            if option in ("--help", "-h", "--version") or (words == ["--list"] and option in own):
                continue  # whole as they are
            code, out, errors = run(program, name, *words)
            if (name == "server" or option == "--dap") and option in own and code == 1 and not out + errors:
                continue  # it serves, and its input ended without a farewell
            if code != 2 or out:
                yield f"{name} {words}: exit {code}, expected 2 and nothing on standard output"
            if ("unknown option" in errors) == (option in own):
                yield f"{name} {words}: {errors.splitlines()[0]}"
            if RAW.search(errors):
                yield f"{name} {words}: raw text of the parser: {errors.splitlines()[0]}"


def check(root, programs, name):
    program = programs / name
    _, top, _ = run(program, "--help")
    subcommands = re.findall(r"^  ([a-z-]+) ", top.split("\nSubcommands:")[1].split("\n\n")[0], re.MULTILINE)
    short = {"-o", "-q", "-v", "-h"}
    manual, everywhere = in_manual(root / "man" / f"{name}.1.scd", subcommands)
    yield from (f"{name}: the manual speaks of {other}, --help does not" for other in sorted(set(manual) - set(subcommands)))
    yield from differences(name, everywhere | short & in_help(top), in_help(top))
    helps = {sub: run(program, sub, "--help")[1] for sub in subcommands}
    common = in_help(top)
    options = {sub: in_help(text) - {"-h", "--help"} for sub, text in helps.items()}
    every = common.union(*options.values())
    for sub in subcommands:
        if RAW.search(helps[sub]):
            yield f"{name} {sub} --help: raw text of the parser: {RAW.search(helps[sub])[0]}"
        yield from differences(f"{name} {sub}", manual[sub], options[sub])
        yield from (f"{name} {line}" for line in refusals(program, sub, options[sub] | common, every))


def words_missing(root, language):
    """Words of a grammar that its page does not have in bold."""
    grammar = re.sub(r"\(\*.*?\*\)", "", (root / f"grammar/{language}.ebnf").read_text(encoding="utf-8"), flags=re.DOTALL)
    page = (root / f"man/{language}.5.scd").read_text(encoding="utf-8").split("\n# EXAMPLE\n")[0]
    bold = " ".join(re.findall(r"\*((?:[^*\n]|\n(?!\n))+)\*", page))
    for word in sorted(set(re.findall(r'"([a-z][a-z-]*)"', grammar))):
        if not re.search(rf"(?<![\w-]){word}(?![\w-])", bold):
            yield f"{language}(5) lacks {word}, a word of its grammar"


def examples(root, programs, page, folder):
    """What is wrong with the examples of a page."""
    blocks = BLOCK.findall((root / f"man/{page}.scd").read_text(encoding="utf-8").replace("\\\\", "\\"))
    commands = [block for block in blocks if block.startswith("$ ")]
    environment = dict(os.environ, PATH=f"{programs.resolve()}{os.pathsep}{os.environ['PATH']}", LC_ALL="C.UTF-8")
    for name, block in ((block.split("\n")[0][3:], block) for block in blocks if block.startswith("// ")):
        (folder / name).write_text(block, encoding="utf-8")
        if not any(name in told for told in commands):
            commands.append(f"$ rmplc format {name} >/dev/null\n")
    if not commands:
        yield f"{page}: there is no example"
    for block in commands:
        printed = ""
        for command in re.findall(r"^\$ (.*)$", block, re.MULTILINE):
            done = subprocess.run(["sh", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60, check=False)
            printed += f"$ {command}\n{done.stdout}"
            if done.returncode != 0:
                yield f"{page}: {command} ends with {done.returncode}"
        if printed != block:
            yield f"{page}: the page shows\n{block}the programs print\n{printed}"


def pages(root):
    """Pages that nothing builds, and pages that are named and not there."""
    built = set(re.findall(r"[\w.-]+\.[15]\b", re.search(r"foreach\(page (.*?)\)", (root / "cmake/Man.cmake").read_text())[1]))
    there = {path.stem for path in (root / "man").glob("*.scd")}
    yield from (f"{page} is in man/ or in cmake/Man.cmake, not in both" for page in sorted(built ^ there))
    for page in sorted(there):
        for name, section in re.findall(r"\*([\w.-]+)\*\(([15])\)", (root / f"man/{page}.scd").read_text(encoding="utf-8")):
            if f"{name}.{section}" not in there | OF_OTHERS:
                yield f"{page} names {name}({section}), which is not there"


def main(root, programs):
    found = [line for name in ("rmplc", "rmpl-run", "tcca-check") for line in check(root, programs, name)]
    found += pages(root)
    for language in LANGUAGES:
        found += words_missing(root, language)
    for language in WITH_EXAMPLES:
        with tempfile.TemporaryDirectory() as folder:
            found += examples(root, programs, f"{language}.5", pathlib.Path(folder))
    print("\n".join([*found, f"{len(found)} differences"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
