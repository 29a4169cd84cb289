"""The documentation promises nothing that is not there."""

import re
import subprocess
from pathlib import Path

import pytest

from softlub.study.drawings import DRAWINGS

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", ROOT / "config" / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_link_leads_somewhere(page):
    links = re.findall(r"\]\(([^)#]+)", page.read_text(encoding="utf-8"))
    missing = [link for link in links if "://" not in link and not (page.parent / link).exists()]
    assert not missing


def test_every_make_target_named_has_a_rule():
    text = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)
    named = set(re.findall(r"(?:^|`)make ([a-z]+)", text, flags=re.MULTILINE))
    listed = set(re.findall(r"^([a-z]+):.*##", (ROOT / "Makefile").read_text(), flags=re.MULTILINE))
    assert {"reproduce", "test"} <= named <= listed


def test_readme_notebook_examples_run():
    film, body = re.findall(
        r"```python\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL
    )
    scope: dict = {}
    exec(film, scope)
    assert bool(scope["curve"]["converged"].all())
    scope = {}
    exec(body, scope)
    assert abs(scope["answer"] - scope["last"].edge_displacement).max() < 0.02 * scope["last"].plate_height


def test_every_option_of_a_drawing_stands_in_its_table():
    text = (ROOT / "config" / "README.md").read_text(encoding="utf-8").split("## Options of drawings")[1]
    rows = [re.findall(r"`(\w+)`", line) for line in text.splitlines() if line.startswith("| `")]
    for name, drawing in DRAWINGS.items():
        told = {word for row in rows if name in row for word in row}
        assert set(drawing.options) <= told


def test_no_path_of_a_machine_is_committed():
    found = subprocess.run(
        [
            "git",
            "grep",
            "-nIE",
            r"(^|[^a-zA-Z0-9_.])/(work|farm|home|root)/",
            "--",
            ".",
            ":!tests/unit/test_docs.py",
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    assert found.stdout == ""
