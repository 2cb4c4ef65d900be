"""The documentation as a site: it builds without a warning, and every link leads somewhere."""

import re
import subprocess
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
MARKDOWN = sorted([*CHECKOUT.glob("*.md"), CHECKOUT / "page" / "README.md",
                   *(CHECKOUT / "docs").rglob("*.md")])
MARKDOWN_LINK = re.compile(r"\]\(([^)\s]+)\)")


class Page(HTMLParser):
    """The links and the anchors of a page of the site."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        named = dict(attributes)
        self.links += [named[key] for key in ("href", "src") if named.get(key)]
        self.anchors |= {named["id"]} if "id" in named else set()


@pytest.fixture(scope="session")
def site(tmp_path_factory):
    """The folder of the site."""
    for module in ("sphinx", "myst_parser", "furo"):
        pytest.importorskip(module, reason=f"{module} is not installed; scripts/test does that")
    folder = tmp_path_factory.mktemp("site")
    done = subprocess.run([CHECKOUT / "scripts" / "site", folder], capture_output=True, text=True,
                          timeout=100)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    return folder


@pytest.fixture(scope="session")
def pages(site):
    return {path: Page(path) for path in sorted(site.rglob("*.html"))}


def test_picture_of_the_rooms_is_that_of_the_includes():
    done = subprocess.run([CHECKOUT / "scripts" / "draw-rooms", "--check"], capture_output=True,
                          text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def broken_link(pages, path, target):
    """Whether a link on a page leads to no file, or to no anchor of a page of the site."""
    place = (path.parent / unquote(target.path)).resolve() if target.path else path
    if not place.exists():
        return True
    return bool(target.fragment) and place in pages and target.fragment not in pages[place].anchors


def test_every_link_and_image_of_the_site_leads_somewhere(pages):
    links = [(path, urlsplit(link)) for path, page in pages.items() for link in page.links]
    inside = [(path, link) for path, link in links if not link.scheme and not link.netloc]
    assert len(inside) > 5000
    assert [(path.name, link.geturl()) for path, link in inside
            if broken_link(pages, path, link)] == []


def anchors_of(markdown):
    """The anchors that hosts of repositories, and the site, make of its headings."""
    headings = re.findall(r"^#+ (.+)$", markdown.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading).lower().replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("document", MARKDOWN,
                         ids=lambda path: path.relative_to(CHECKOUT).as_posix())
def test_every_link_and_image_in_markdown_leads_somewhere(document):
    """What a reader of the sources clicks on."""
    links = [urlsplit(link) for link in MARKDOWN_LINK.findall(document.read_text())]
    for link in (each for each in links if not each.scheme):
        place = (document.parent / link.path).resolve() if link.path else document
        assert place.exists(), link.geturl()
        assert not link.fragment or link.fragment in anchors_of(place), link.geturl()


def test_every_public_name_of_the_module_is_on_its_page(site, pages):
    text = (CHECKOUT / "python" / "zenosphere" / "__init__.py").read_text()
    names = re.findall(r'"(\w+)"', re.search(r"__all__ = \[(.*?)\]", text, re.DOTALL)[1])
    assert len(names) > 5
    assert {f"zenosphere.{name}" for name in names} <= pages[site / "api.html"].anchors


def test_search_finds_words_of_the_pages(site):
    index = (site / "searchindex.js").read_text()
    assert index.startswith("Search.setIndex(") and '"restitut"' in index
