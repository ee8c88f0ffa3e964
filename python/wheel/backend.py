"""The build of a wheel (PEP 517): CMake builds the module, and what it reads is put beside it. The wheel holds the
scenes and the module for OpenEXR; OpenImageIO it leaves to the system, as the wheel is for the system that made it.

Settings, by `pip wheel --config-settings NAME=VALUE`: `build`, a folder to build in that is kept (else one that is removed),
and `jobs`, how many compilers at a time. What the variable CMAKE_ARGS says is handed to CMake."""
import base64
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import time
import zipfile
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent.parent


def version():
    return re.search(r"^project\(pxm VERSION (\S+)", (TOP / "CMakeLists.txt").read_text(), re.MULTILINE)[1]


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def metadata():
    return (f"Metadata-Version: 2.1\nName: pxm\nVersion: {version()}\n"
            "Summary: Ray tracing of linear fractals, and the Pixel Machine that they were first rendered on\n"
            "Requires-Python: >=3.10\nRequires-Dist: numpy\n")


def build_in(folder, jobs):
    """Configures and builds the module: below the prefix all of it lies in pxm/."""
    subprocess.run(["cmake", "-S", TOP, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DPXM_BUILD_TESTS=OFF",
                    "-DPXM_LOOK_IN_BUILD=OFF", "-DPXM_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}",
                    "-DCMAKE_INSTALL_PREFIX=/wheel", "-DCMAKE_INSTALL_LIBDIR=pxm/lib", "-DCMAKE_INSTALL_DATADIR=pxm/share",
                    "-DPXM_INSTALL_PYTHON=.", *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "pxm_python", *(["--parallel", jobs] if jobs else [])], check=True)


def files_of(build):
    """(name in the wheel, file)."""
    for path in sorted((build / "python/pxm").iterdir()):
        if path.suffix in (".py", ".pyi", ".so", ".typed") or path.name == "py.typed":
            yield f"pxm/{path.name}", path
    for module in ("pxm_openexr.so", "pxm_flint.so"):
        yield f"pxm/lib/pxm/{module}", build / "lib/pxm" / module
    for path in sorted((TOP / "scenes").rglob("*.pxm")):
        if "gallery" not in path.parts:
            yield f"pxm/share/pxm/scenes/{path.relative_to(TOP / 'scenes')}", path


class Wheel:
    """A zip with a record of what is in it. Its files have the date of SOURCE_DATE_EPOCH, so that wheels are equal."""

    def __init__(self, path):
        date = time.gmtime(max(int(os.environ.get("SOURCE_DATE_EPOCH", 315532800)), 315532800))  # a zip knows 1980 and later
        self.date = date[:6]
        self.zip = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED)
        self.record = []

    def add(self, name, data):
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self.record.append(f"{name},sha256={digest},{len(data)}\n")
        self._write(name, data)

    def close(self, folder):
        name = f"{folder}/RECORD"
        self._write(name, ("".join(self.record) + f"{name},,\n").encode())
        self.zip.close()

    def _write(self, name, data):
        info = zipfile.ZipInfo(name, self.date)
        info.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
        info.compress_type = zipfile.ZIP_DEFLATED
        self.zip.writestr(info, data)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    kept = settings.get("build")
    build = Path(kept or tempfile.mkdtemp(prefix="pxm-wheel-")).resolve()
    try:
        build_in(build, settings.get("jobs"))
        name = f"pxm-{version()}-{tag()}.whl"
        wheel = Wheel(Path(wheel_directory) / name)
        for inside, path in files_of(build):
            wheel.add(inside, path.read_bytes())
        folder = f"pxm-{version()}.dist-info"
        wheel.add(f"{folder}/METADATA", metadata().encode())
        wheel.add(f"{folder}/WHEEL", f"Wheel-Version: 1.0\nGenerator: pxm\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode())
        wheel.add(f"{folder}/LICENSE", (TOP / "LICENSE").read_bytes())
        wheel.close(folder)
        return name
    finally:
        if not kept:
            shutil.rmtree(build, ignore_errors=True)


def build_sdist(sdist_directory, config_settings=None):
    """What the repository has of the commit at hand."""
    name = f"pxm-{version()}"
    path = Path(sdist_directory) / f"{name}.tar.gz"
    subprocess.run(["git", "-C", TOP, "archive", f"--prefix={name}/", "-o", path, "HEAD"], check=True)
    return path.name
