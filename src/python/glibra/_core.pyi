from os import PathLike
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy

__version__: str

class Diagnostic:
    id: str
    text: str
    severity: str
    file: str
    line: int
    column: int

class SceneError(RuntimeError):
    diagnostics: List[Diagnostic]

class Value:
    name: str
    program: str
    type: str
    value: List[float]
    initial: List[float]
    words: List[str]
    range: Optional[Tuple[float, float]]

class Comparison:
    same: bool
    reason: str
    differing_pixels: int
    largest: float
    root_mean_square: float
    flip: Optional[float]
    structure: Optional[float]
    def __bool__(self) -> bool: ...

class Renderer:
    def __init__(self, driver: str = ...) -> None: ...
    def load(self, path: str) -> "Scene": ...
    def load_text(self, text: str, name: str, files: Dict[str, Union[str, bytes]]) -> "Scene": ...

class Scene:
    def draw(self, width: int, height: int, time: float, samples: int, alpha: bool, floats: bool) -> numpy.ndarray: ...
    def values(self) -> List[Value]: ...
    def set(self, name: str, text: str) -> None: ...
    def set_numbers(self, name: str, numbers: List[float]) -> None: ...
    def check(self, time: float) -> List[Diagnostic]: ...
    def target(self, name: str) -> numpy.ndarray: ...
    def buffer(self, name: str) -> numpy.ndarray: ...
    def diagnostics(self) -> List[Diagnostic]: ...
    def files(self) -> List[Any]: ...
    def stats(self) -> Dict[str, int]: ...
    def reload(self) -> None: ...

def save(picture: numpy.ndarray, file: Union[str, PathLike[str]]) -> None: ...
def compare(got: Any, expected: Any, largest: float, fraction: float, cluster: int, line: int, bias: float,
            flip: Optional[float], structure: Optional[float], relative: float, absolute: float, exact: bool) -> Comparison: ...
