#!/usr/bin/env python3
# The site of the documentation: built strictly, every link and anchor of it leads somewhere, and its search knows every page.
# SPDX-License-Identifier: MIT
"""Usage: site.py ROOT.  Exit code 77 where a tool of `cmake/install-packages site` is missing: the test is skipped. Where
chromium is, the search is tried in it."""

import functools
import html.parser
import http.server
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).parent / "browser"))
import webdriver  # noqa: E402 pylint: disable=wrong-import-position,import-error

SKIPPED = 77
# Where the theme says who made it.
OF_THEME = {"https://squidfunk.github.io/mkdocs-material/"}


class Page(html.parser.HTMLParser):
    """What a page links to, what it loads, and what can be linked to in it."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.names = set(), set(), set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.names |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        if tag == "a" and attributes.get("href"):
            self.links.add(attributes["href"])
        elif tag in ("link", "script", "img", "object", "iframe"):
            self.loads |= {attributes[key] for key in ("href", "src", "data") if attributes.get(key)}


def dangling(site):
    """Links that lead nowhere, and what a page loads from another server."""
    pages = {path: Page(path) for path in sorted(site.rglob("*.html")) if path.name != "404.html"}
    for path, page in pages.items():
        for link in sorted(page.loads | page.links - OF_THEME):
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                if link in page.loads:
                    yield f"{path.relative_to(site)} loads {link}"
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir():
                target = target / "index.html"
            if not target.is_file():
                yield f"{path.relative_to(site)} leads to {link}, which is not there"
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].names:
                yield f"{path.relative_to(site)} leads to {link}: the page has no such heading"


def unknown_to_search(root, site):
    """Pages that the search does not find."""
    index = json.loads((site / "search/search_index.json").read_text(encoding="utf-8"))
    found = {entry["location"].split("#")[0] for entry in index["docs"]}
    pages = [path.relative_to(root) for path in [*root.glob("docs/**/*.md"), *root.glob("examples/*/README.md")]]
    pages += [path.relative_to(root).with_suffix(".md") for path in root.glob("man/*.scd")]
    for page in sorted(pages):
        name = page.with_name("index.html") if page.name == "README.md" else page.with_suffix(".html")
        if str(name) not in found:
            yield f"the search does not know {name}"


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):  # pylint: disable=arguments-differ
        pass


def searched(site):
    """What is wrong with the search as a reader uses it."""
    if not webdriver.programs():
        print("the search is not tried: there is no chromium and chromedriver")
        return
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=site)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        with webdriver.Browser(1280, 900) as browser:
            browser.open(f"http://127.0.0.1:{server.server_port}/docs/guide.html")
            browser.run("document.querySelector('.md-search__input').focus()")
            browser.wait("document.querySelector('.md-search-result__meta').textContent.includes('Type to')")
            browser.press(*"RMPL0500")
            browser.wait("document.querySelector('.md-search-result__link')")
            found = browser.run("return [...document.querySelectorAll('.md-search-result__link')].map(e => e.href)")
            if not any("diagnostics/RMPL0500.html" in link for link in found):
                yield f"the search for RMPL0500 finds {found}"
            yield from (f"the console says {line}" for line in browser.complaints())
        server.shutdown()


def main(root):
    with tempfile.TemporaryDirectory() as folder:
        site = pathlib.Path(folder).resolve() / "site"
        done = subprocess.run([root / "docs/site/build", site], capture_output=True, text=True, timeout=300, check=False)
        if done.returncode == 2:
            print(f"skipped: {done.stderr}")
            return SKIPPED
        if done.returncode != 0 or done.stdout + done.stderr:
            print(f"docs/site/build ends with {done.returncode}\n{done.stdout}{done.stderr}")
            return 1
        found = [*dangling(site), *unknown_to_search(root, site), *searched(site)]
        pages = len(list(site.rglob("*.html")))
    print("\n".join([*found, f"{pages} pages, {len(found)} complaints"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
