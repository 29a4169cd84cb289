"""The parts know only the parts below them, and light ones load nothing heavy."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import softlub

SOURCE = Path(softlub.__file__).parent

BASE = {"units", "pressure_table", "protocols", "datasets", "references"}
PHYSICS = {"surfaces", "contact", "solid", "lubrication", "coupling", "calibration"}
MAY_IMPORT = {
    "units": set(),
    "pressure_table": set(),
    "protocols": {"pressure_table"},
    "datasets": {"units"},
    "references": set(),
    "surfaces": BASE,
    "contact": BASE | {"surfaces"},
    "solid": BASE | {"surfaces", "contact"},
    "lubrication": BASE,
    "coupling": BASE | {"lubrication", "solid"},
    "calibration": BASE,
    "study": BASE | PHYSICS,
    "claims": BASE | PHYSICS | {"study"},
    "figures": BASE | PHYSICS | {"study"},
    "stages": BASE | PHYSICS | {"study", "claims", "figures"},
}
"""Part of the package -> other parts that its modules may import. A new part has to be placed here."""


def modules():
    return sorted(path for path in SOURCE.rglob("*.py"))


def dotted(path):
    parts = ["softlub", *path.relative_to(SOURCE).with_suffix("").parts]
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def for_types_only(node):
    return isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"


def imported_names(path, types_too=True):
    """Modules of softlub that a file imports, wherever in the file the import stands."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    if not types_too:
        tree.body = [node for node in tree.body if not for_types_only(node)]
    known = {dotted(module) for module in modules()}
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path} imports relatively"
            for alias in node.names:
                submodule = f"{node.module}.{alias.name}"
                names.add(submodule if submodule in known else str(node.module))
    return {name for name in names if name == "softlub" or name.startswith("softlub.")}


def part_of(name):
    return name.split(".")[1] if "." in name else ""


@pytest.mark.parametrize("path", modules(), ids=dotted)
def test_a_module_imports_only_from_below(path):
    part = part_of(dotted(path))
    if not part:
        return  # the package itself
    assert part in MAY_IMPORT, f"the part {part} has no place in the order of imports"
    upward = {name for name in imported_names(path) if part_of(name) not in MAY_IMPORT[part] | {part}}
    assert not upward, f"{dotted(path)} must not import {sorted(upward)}"


def test_the_order_has_no_cycle():
    placed, left = set(), dict(MAY_IMPORT)
    while left:
        free = [part for part, below in left.items() if below <= placed]
        assert free, f"{sorted(left)} import each other"
        placed.update(free)
        for part in free:
            del left[part]


def test_modules_import_each_other_in_no_circle():
    imports = {dotted(path): imported_names(path, types_too=False) for path in modules()}
    done, path = set(), []

    def visit(name):
        assert name not in path, " -> ".join([*path[path.index(name) :], name])
        if name in done:
            return
        path.append(name)
        for other in sorted(imports.get(name, ())):
            visit(other)
        path.pop()
        done.add(name)

    for name in imports:
        visit(name)


def loaded_by(statement):
    code = f"{statement}\nimport sys\nprint(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return {name.split(".")[0] for name in done.stdout.split()}


@pytest.mark.parametrize(
    ("statement", "heavy"),
    [
        ("import softlub", {"numba", "scipy", "xarray", "matplotlib", "felupe", "pint"}),
        ("import softlub.units", {"numpy", "pint"}),
        ("import softlub.study", {"felupe", "matplotlib", "SurfaceTopography", "numba"}),
        ("import softlub.lubrication", {"felupe", "matplotlib", "SurfaceTopography", "pint"}),
        ("import softlub.stages.panel", {"felupe", "matplotlib", "SurfaceTopography", "pint", "pydantic"}),
        ("import softlub.solid", {"numpy", "scipy", "felupe", "matplotlib", "xarray"}),
        (
            "import softlub.contact.laws.persson",
            {"felupe", "matplotlib", "SurfaceTopography", "pint", "xarray"},
        ),
    ],
)
def test_light_parts_load_nothing_heavy(statement, heavy):
    assert not loaded_by(statement) & heavy


def test_references_stand_alone():
    """They check the solvers, so they may share nothing with them."""
    for path in (SOURCE / "references").glob("*.py"):
        assert all(name.startswith("softlub.references") for name in imported_names(path))
