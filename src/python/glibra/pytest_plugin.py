"""Golden pictures in pytest.

    def test_teapot(golden):
        golden.check("teapot.glib", time=2)

compares the picture with ``golden/TEST.png`` beside the test. ``--glibra-update`` accepts what is drawn;
``--glibra-report FOLDER`` writes a page with the pictures that differ.
"""
from __future__ import annotations

import html
import itertools
import json
import os
import pathlib
import re
from typing import Any, Dict, Mapping, Optional, Union

import pytest
from numpy.typing import NDArray

import glibra


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("glibra")
    group.addoption("--glibra-update", action="store_true", help="accept the pictures as the new golden ones")
    group.addoption("--glibra-report", metavar="FOLDER", help="write a page with the pictures that differ")


class Golden:
    """Compares pictures with accepted ones; see golden.check."""

    def __init__(self, request: pytest.FixtureRequest) -> None:
        self._request = request
        self._count = 0
        self._folder = pathlib.Path(request.node.path).parent

    def check(self, scene: Union[str, os.PathLike[str], glibra.Scene], *, name: Optional[str] = None, width: int = 0,
              height: int = 0, time: float = 0.0, set: Optional[Mapping[str, Any]] = None, **tolerance: Any) -> None:
        """Draws a scene (a path beside the test, or a glibra.Scene) and compares it with its golden picture. ``tolerance``
        as for glibra.compare."""
        if not isinstance(scene, glibra.Scene):
            scene = glibra.Scene(self._folder / scene)
        for each, value in (set or {}).items():
            scene[each] = value
        self.check_picture(scene.draw(width, height, time=time), name=name, **tolerance)

    def check_picture(self, picture: NDArray[Any], *, name: Optional[str] = None, **tolerance: Any) -> None:
        """The same for a picture: an array of height x width x 3 or 4 numbers."""
        self._count += 1
        from_test = name is None
        if name is None:
            name = re.sub(r"[^\w.-]+", "_", self._request.node.name) + (f"-{self._count}" if self._count > 1 else "")
        golden = self._folder / "golden" / f"{name}.png"
        if from_test:
            self._claim(golden)
        if self._request.config.getoption("--glibra-update"):
            known = glibra.compare(picture, golden, **tolerance) if golden.exists() else None
            if not known or known.diagnostics:
                golden.parent.mkdir(exist_ok=True)
                glibra.save(picture, golden)
            return
        if not golden.exists():
            pytest.fail(f"there is no golden picture {golden}; --glibra-update makes it", pytrace=False)
        found = glibra.compare(picture, golden, **tolerance)
        for each in found.diagnostics:  # the golden may be shown as another picture than the one that was compared
            pytest.fail(f"{name}: {each}", pytrace=False)
        if not found:
            self._note(name, picture, golden, found)
            pytest.fail(f"{name}: {found.reason}", pytrace=False)

    def _claim(self, golden: pathlib.Path) -> None:
        """Fails if the name of another test gives the same golden picture."""
        node = self._request.node.nodeid
        none: Dict[pathlib.Path, str] = {}
        first = self._request.config.stash.setdefault(_OWNERS, none).setdefault(golden, node)
        if first != node:
            pytest.fail(f"{first} and {node} have the same golden picture {golden}; give one of them a name of its own: "
                        'golden.check(..., name="...")', pytrace=False)

    def _note(self, name: str, picture: NDArray[Any], golden: pathlib.Path, found: glibra.Comparison) -> None:
        folder = self._request.config.getoption("--glibra-report")
        if not folder:
            return
        folder = pathlib.Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        # Tests of other folders may have the same names, and tests run in several processes (pytest-xdist): a name belongs to
        # the test that makes its record.
        note = json.dumps({"test": self._request.node.nodeid, "count": self._count, "reason": found.reason})
        for number in itertools.count(1):
            free = name.replace("/", "_") + (f" ({number})" if number > 1 else "")
            try:
                with open(folder / (free + _RECORD), "x", encoding="utf-8") as record:
                    record.write(note)
                break
            except FileExistsError:
                continue
        glibra.save(picture, folder / f"{free}.got.png")
        (folder / f"{free}.expected.png").write_bytes(golden.read_bytes())


_RECORD = ".difference.json"  # of a picture that differs, until the page is written
_OWNERS: pytest.StashKey[Dict[pathlib.Path, str]] = pytest.StashKey()  # of golden pictures, those that are named by tests: the node of the first test


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Golden:
    return Golden(request)


def _report_of(config: pytest.Config) -> Optional[pathlib.Path]:
    """The folder of the report; None in the worker processes of pytest-xdist, which only add to it."""
    folder = config.getoption("--glibra-report")
    return pathlib.Path(folder) if folder and not hasattr(config, "workerinput") else None


def pytest_configure(config: pytest.Config) -> None:
    folder = _report_of(config)
    for left in folder.glob("*" + _RECORD) if folder else ():  # by a run that was ended
        left.unlink()


def pytest_sessionfinish(session: pytest.Session) -> None:
    folder = _report_of(session.config)
    if not folder:
        return
    folder.mkdir(parents=True, exist_ok=True)
    differences = []
    for file in folder.glob("*" + _RECORD):
        record = json.loads(file.read_text(encoding="utf-8"))
        differences.append((record["test"], record["count"], file.name[:-len(_RECORD)], record["reason"]))
        file.unlink()
    rows = "".join(
        f'<section><h2>{html.escape(name)}</h2><p>{html.escape(test)}: {html.escape(reason)}</p>'
        f'<img src="{html.escape(name)}.expected.png" alt="expected">'
        f'<img src="{html.escape(name)}.got.png" alt="got"></section>'
        for test, _, name, reason in sorted(differences))
    page = ('<!doctype html><meta charset="utf-8"><title>Pictures that differ</title>'
            "<style>body{font:16px sans-serif;margin:2em}img{margin-right:1em;image-rendering:pixelated}</style>"
            f"<h1>Pictures that differ: expected, got</h1>{rows or '<p>None.</p>'}")
    (folder / "index.html").write_text(page, encoding="utf-8")
