#!/usr/bin/env python3
# The packages, as somebody gets them: built, installed into an empty root, used, and removed without a trace.
# SPDX-License-Identifier: MIT
"""Usage: package.py ROOT BUILD.  Exit code 77 where a tool of Debian is missing: the test is skipped, and says why."""

import gzip
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
PROGRAMS = ("rmplc", "rmpl-run", "tcca-check")
# Where the programs' package may put something.
PLACES = re.compile(r"usr/bin/[a-z-]+|usr/share/(man|rmpl|doc/rmpl|bash-completion|zsh/vendor-completions|"
                    r"fish/vendor_completions\.d)(/.*)?")
ENVIRONMENT = dict(os.environ, PATH=os.environ["PATH"] + ":/usr/sbin:/sbin", LC_ALL="C.UTF-8")


class Failed(Exception):
    """What is not as it should be."""


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=300, check=False, env=ENVIRONMENT, text=True, **options)
    if done.returncode != 0:
        raise Failed(f"{' '.join(map(str, words))}: exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def expect(holds, complaint):
    if not holds:
        raise Failed(complaint)


def packages(build, into):
    run("cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", into)
    found = {run("dpkg-deb", "-f", file, "Package").strip(): file for file in into.glob("*.deb")}
    python = {"python3-rmpl"} if any((build / "python/rmpl").glob("_rmpl*.so")) else set()
    expect(set(found) == {"rmpl", "librmpl-dev"} | python, f"packages: {sorted(found)}")
    return found


def dpkg(root, *words):
    return run("dpkg", "--root", root, "--force-not-root", "--force-depends", "--log", "/dev/null", *words)


def files_below(root):
    return {str(path.relative_to(root)) for path in root.rglob("*") if not path.is_dir() or path.is_symlink()}


def new_root(folder):
    for name in ("info", "updates", "triggers"):
        (folder / "var/lib/dpkg" / name).mkdir(parents=True)
    (folder / "var/lib/dpkg/status").touch()
    return folder


def check_contents(root, package):
    depends = run("dpkg-deb", "-f", package, "Depends")
    for library in ("libc6", "libstdc++6", "libgmp10", "libpugixml1v5"):
        expect(library in depends, f"the package does not depend on {library}: {depends}")
    files = {file for file in files_below(root) if not file.startswith("var/lib/dpkg/")}
    strange = sorted(file for file in files if not PLACES.fullmatch(file))
    expect(not strange, f"files in strange places: {strange}")
    for schema in sorted((root / "usr/share/rmpl/schema").glob("*.json")):
        described = json.loads(schema.read_text(encoding="utf-8"))
        expect(described["$id"] == f"urn:rmpl:schema:{schema.name.removesuffix('.schema.json')}", f"{schema}: $id")
    expect((root / "usr/share/doc/rmpl/copyright").is_file(), "there is no copyright file")


def check_programs(root, work):
    """Every program runs from where it is installed, on the examples beside it."""
    bin_dir, examples = root / "usr/bin", root / "usr/share/doc/rmpl/examples"
    for program in PROGRAMS:
        expect(run(bin_dir / program, "--version").startswith(program), f"{program} --version")
    propulsion = examples / "propulsion/propulsion.tcca"
    run(bin_dir / "rmplc", "compile", propulsion, "-o", work / "propulsion.json")
    run(bin_dir / "tcca-check", "reachability", work / "propulsion.json", "--target", "engine = heating")
    run(bin_dir / "rmpl-run", "scenario", examples / "propulsion/burn.scn")


def check_pages(source, root):
    """Every page of man/ is there, and renders without a warning."""
    pages = sorted(path.stem for path in (source / "man").glob("*.scd"))
    installed = sorted(path.stem for path in (root / "usr/share/man").rglob("*.gz"))
    expect(pages == installed, f"installed are the pages {installed}, expected {pages}")
    for page in (f"man{name[-1]}/{name}.gz" for name in pages):
        with gzip.open(root / "usr/share/man" / page, "rb") as compressed:
            done = subprocess.run(["groff", "-man", "-Tutf8", "-P-cbou", "-ww", "-K", "utf8"], input=compressed.read(),
                                  capture_output=True, timeout=60, check=False)
        expect(done.returncode == 0 and b"\nNAME\n" in done.stdout, f"{page} does not render")
        expect(not done.stderr, f"{page}: {done.stderr.decode()}")


def check_removal(root):
    dpkg(root, "--purge", "rmpl")
    left = sorted(file for file in files_below(root) if not file.startswith("var/lib/dpkg/"))
    folders = sorted(str(path.relative_to(root)) for path in root.glob("usr/**/*"))
    expect(not left and not folders, f"left behind: {left + folders}")


def check_consumer(source, package, work):
    """A project that finds the libraries builds and runs."""
    run("dpkg-deb", "-x", package, work / "dev")
    run("cmake", "-S", source, "-B", work / "consumer", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={work / 'dev/usr'}")
    run("cmake", "--build", work / "consumer")
    said = run(work / "consumer/consumer")
    expect(said == "Tap: 1 component\n", f"the consumer says {said}")


def check_python(source, package, work):
    """The module, from where the package puts it, for the Python of the system."""
    depends = run("dpkg-deb", "-f", package, "Depends")
    expect("python3 (>=" in depends and "libstdc++6" in depends, f"the package depends on {depends}")
    run("dpkg-deb", "-x", package, work / "python")
    said = run("env", "PYTHONDONTWRITEBYTECODE=1", f"PYTHONPATH={work / 'python/usr/lib/python3/dist-packages'}", "/usr/bin/python3", "-c",
               f"import rmpl; print(rmpl.compile('{source / 'examples/propulsion/propulsion.tcca'}').plants)")
    expect(said == "['Propulsion']\n", f"the module says {said}")
    strange = sorted(file for file in files_below(work / "python") if not re.fullmatch(r"usr/(lib/python3/dist-packages/rmpl|share/doc/python3-rmpl)/[^/]+", file))
    expect(not strange, f"files of the module in strange places: {strange}")


def main(source, build):
    missing = [tool for tool in ("cpack", "dpkg", "dpkg-deb", "dpkg-shlibdeps", "groff", "scdoc") if not shutil.which(tool)]
    if missing:
        print(f"skipped: there is no {', '.join(missing)}")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        try:
            built = packages(build, work / "packages")
            root = new_root(work / "root")
            dpkg(root, "--install", built["rmpl"])
            check_contents(root, built["rmpl"])
            check_programs(root, work)
            check_pages(source, root)
            check_removal(root)
            check_consumer(source / "tests/package/consumer", built["librmpl-dev"], work)
            if "python3-rmpl" in built:
                check_python(source, built["python3-rmpl"], work)
        except Failed as failure:
            print(failure)
            return 1
    print("installed, used and removed: rmpl; built upon: librmpl-dev" + ("; imported: python3-rmpl" if "python3-rmpl" in built else ""))
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
