"""What tests/faults/kill and tests/faults/power_loss disturb: commands, what they need, and what they make."""
import dataclasses
import os
import pathlib
import subprocess
import tempfile

OLD = "what was there before\n"

TETRA = """ifs tetra {
    newmap scale: 1/2
    newmap scale: 1/2 translate: 1/2,0,0
    newmap scale: 1/2 translate: 1/4,sqrt(3)/4,0
    newmap scale: 1/2 translate: 1/4,sqrt(3)/12,sqrt(6)/6
}
object tetra { ifs: tetra }
camera { eye: 0.4,0.3,-2 look: 0.4,0.3,0.2 }
"""
FILM = """animation { frames: 4 rate: 10 }
ifs a {
    newmap scale: 0.5 rotate: y,90*t
    newmap scale: 0.5 translate: 0.5,0,0
    newmap scale: 0.5 translate: 0,0.5,0
}
object a { ifs: a }
camera { eye: 0.3,0.4,-2 look: 0.3,0.3,0 }
"""
FRACTINT = "tri {\n .5 0 0 .5 0 0 .33\n .5 0 0 .5 1 0 .33\n .5 0 0 .5 .5 1 .34\n}\n"
PROGRAM = "start: r1 = 0\n return (r14)\n nop\n"


@dataclasses.dataclass
class Work:
    command: list
    finals: list = dataclasses.field(default_factory=list)  # the files that it makes
    over_old: bool = False  # OLD stands in them before
    before: list = dataclasses.field(default_factory=list)  # commands that make what it needs
    folders: list = dataclasses.field(default_factory=list)
    keeps: bool = False  # what is measured stays for the next run
    parts: list = dataclasses.field(default_factory=list)  # folders of parts: beginnings of the dead stay there
    alone: bool = False  # two at a time would be in each other's way


def render(*more, size="240x180"):
    return ["render", "tetra.pxm", "--size", size, "--threads", "2", "--quiet", *more]


def film(*more):
    return ["render", "film.pxm", "--frames", "0-3", "--size", "120x90", "--threads", "2", "--quiet", *more]


FRAMES = [f"f/{i}.png" for i in range(4)]
WORKS = {
    "check": Work(["check", "tetra.pxm"]),
    "format": Work(["check", "--format", "wild.pxm"]),
    "inspect": Work(["inspect", "tetra.pxm", "-o", "facts.txt"], ["facts.txt"], over_old=True),
    "render": Work(render("-o", "a.png"), ["a.png"]),
    "render_over": Work(render("-o", "a.png"), ["a.png"], over_old=True),
    "render_exr": Work(render("-o", "a.exr", "--aov", "Z,word"), ["a.exr"], over_old=True),
    "render_jpeg": Work(render("-o", "a.jpg"), ["a.jpg"], over_old=True),
    "machine": Work(["render", "tetra.pxm", "--size", "16x12", "--machine", "916", "--threads", "2", "--quiet", "-o", "a.png"],
                    ["a.png"], over_old=True),
    "keep": Work(render("-o", "a.png", "--keep", "kept"), ["a.png"], over_old=True, keeps=True, parts=["kept"]),
    "part": Work(render("-o", "parts", "--part", "2/3"), ["parts/part-2-of-3.pxmpart"], keeps=True, parts=["parts"]),
    "claim": Work(render("--claim", "parts", "--part", "any/3", "--claim-expiry", "0.3"),
                  [f"parts/part-{i}-of-3.pxmpart" for i in (1, 2, 3)], keeps=True, parts=["parts"]),
    "join": Work(["join", "parts", "-o", "a.exr", "--quiet"], ["a.exr"], over_old=True, before=[render("-o", "parts", "--part", "1/1")]),
    "points": Work(["points", "tetra.pxm", "-n", "40000", "--threads", "2", "--quiet", "-o", "a.ply"], ["a.ply"], over_old=True),
    "points_keep": Work(["points", "tetra.pxm", "-n", "400000", "--threads", "2", "--quiet", "-o", "a.ply", "--keep", "kept"],
                        ["a.ply"], keeps=True, parts=["kept"]),
    "film": Work(film("-o", "f/%d.png"), FRAMES, folders=["f"]),
    "film_keep": Work(film("-o", "f/%d.png", "--keep", "kept"), FRAMES, folders=["f"], keeps=True, parts=["kept"]),
    "film_parts": Work(film("-o", "parts", "--part", "1/2"), ["parts/frame-0000/part-1-of-1.pxmpart"], keeps=True, parts=["parts"]),
    "import": Work(["import", "tri.ifs", "-o", "new.pxm"], ["new.pxm"], over_old=True),
    "export": Work(["export", "tetra.pxm", "--levels", "4", "--quiet", "-o", "a.glb"], ["a.glb"], over_old=True),
    "study": Work(["study", "balance", "tetra.pxm", "--size", "8x8", "--quiet", "-o", "report"], keeps=True),
    "asm": Work(["asm", "a.s", "-o", "a.o"], ["a.o"], over_old=True),
}


def program_environment(more=None):
    return dict(os.environ, SOURCE_DATE_EPOCH="0", OMP_WAIT_POLICY="passive", **(more or {}))


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def prepared(root, work, program):
    """A folder with what the work needs."""
    folder = pathlib.Path(tempfile.mkdtemp(dir=root))
    for name, text in [("tetra.pxm", TETRA), ("film.pxm", FILM), ("tri.ifs", FRACTINT), ("a.s", PROGRAM),
                       ("wild.pxm", TETRA.replace("    newmap", " newmap   "))]:
        (folder / name).write_text(text)
    for name in work.folders:
        (folder / name).mkdir()
    for command in work.before:
        subprocess.run([program, *command], cwd=folder, check=True, capture_output=True, env=program_environment())
    if work.over_old:
        for name in work.finals:
            (folder / name).write_text(OLD)
    return folder
