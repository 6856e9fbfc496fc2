"""Every link of a page leads to a file or a heading, and every page that sources, tests or scripts name is there.

Usage: page_links.py SOURCE_FOLDER
"""

import glob
import os
import re
import sys

from checks import check, finish

ROOT = sys.argv[1]


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def anchors_of(page):
    """The names of its headings, as GitHub makes them: lower case, without punctuation, blanks as hyphens."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text_of(page), flags=re.S), re.M)
    plain = [re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower() for heading in headings]
    return {re.sub(r"[^\w -]", "", heading).replace(" ", "-") for heading in plain}


def main():
    pages = glob.glob(f"{ROOT}/*.md") + glob.glob(f"{ROOT}/doc/**/*.md", recursive=True)
    n_links = 0
    for page in pages:
        for link, anchor in re.findall(r"\]\(([^)#:]*)(?:#([^)]*))?\)", text_of(page)):
            n_links += 1
            target = os.path.join(os.path.dirname(page), link) if link else page
            if not os.path.exists(target):
                check(False, f"{os.path.relpath(page, ROOT)} leads to {link}, which is not there")
            elif anchor and target.endswith(".md") and anchor not in anchors_of(target):
                check(False, f"{os.path.relpath(page, ROOT)} leads to {link}#{anchor}, a heading that is not there")
    check(n_links > 50, f"{n_links} links of {len(pages)} pages followed")

    index = text_of(f"{ROOT}/doc/README.md")
    for page in glob.glob(f"{ROOT}/doc/*/*.md"):
        name = os.path.relpath(page, f"{ROOT}/doc")
        check(f"({name})" in index, f"doc/README.md lists {name}")

    n_names = 0
    for folder in ("include", "source", "tests", "benchmarks", "prm"):
        for path in glob.glob(f"{ROOT}/{folder}/**/*", recursive=True):
            if path.endswith((".h", ".cc", ".py", ".prm")):
                for name in re.findall(r"\bdoc/[\w/]+\.md", text_of(path)):
                    n_names += 1
                    if not os.path.exists(os.path.join(ROOT, name)):
                        check(False, f"{os.path.relpath(path, ROOT)} names {name}, which is not there")
    check(n_names > 20, f"{n_names} names of pages in sources looked up")
    finish()


main()
