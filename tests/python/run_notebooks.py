"""Runs the code cells of every notebook of a folder, each notebook in a process of its own, and asks what a cell ends
with to show itself as a notebook would. Fails at the first cell that does."""
import ast
import json
import os
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path


def shown(value):
    """A notebook asks what it has for a page and for a picture."""
    for name in ("_repr_html_", "_repr_png_"):
        show = getattr(value, name, None)
        if show is not None:
            assert show(), f"{name} of {value!r} is empty"
    return repr(value)


def run_cell(source, names, where):
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, where, "exec"), names)
    if last is not None:
        value = eval(compile(ast.Expression(last.value), where, "eval"), names)
        if value is not None:
            print(shown(value))
    if "matplotlib.pyplot" in sys.modules:  # a notebook shows a cell's figures and begins anew
        sys.modules["matplotlib.pyplot"].close("all")


def run(path):
    notebook = json.loads(path.read_text())
    assert notebook["nbformat"] == 4
    names = {"__name__": "__main__"}
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert cells, f"{path} has no code"
    for i, cell in enumerate(cells, 1):
        assert not cell["outputs"], f"{path}: cell {i} has output; notebooks are kept without"
        run_cell("".join(cell["source"]), names, f"{path.name}, cell {i}")


def main():
    if sys.argv[1] == "--one":
        warnings.simplefilter("error")
        run(Path(sys.argv[2]))
        return
    notebooks = sorted(Path(sys.argv[1]).resolve().glob("*.ipynb"))
    assert len(notebooks) >= 5, notebooks
    for path in notebooks:
        with tempfile.TemporaryDirectory() as folder:
            environment = os.environ | {"MPLBACKEND": "agg", "MPLCONFIGDIR": folder}
            subprocess.run([sys.executable, __file__, "--one", path], cwd=folder, env=environment, check=True)
        print(f"{path.name}: runs")


if __name__ == "__main__":
    main()
