"""Laws of renders: the same pixels as the program's, arrays without copies, and the ways to watch and stop them."""
import os
import signal
import struct
import subprocess
import tempfile
import threading
import time
import unittest
import zlib
from pathlib import Path

import numpy as np

import pxm

PROGRAM = os.environ.get("PXM_BINARY")


class Render(unittest.TestCase):
    @unittest.skipUnless(PROGRAM, "PXM_BINARY is not set")
    def test_a_picture_is_the_programs(self):
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = Path(folder, "ours.png"), Path(folder, "theirs.png")
            pxm.render("tetra", size=(96, 72)).save(ours)
            subprocess.run([PROGRAM, "render", "tetra", "--size", "96x72", "--quiet", "--no-scene", "-o", theirs], check=True)
            self.assertEqual(ours.read_bytes(), theirs.read_bytes())
            ours, theirs = Path(folder, "ours.exr"), Path(folder, "theirs.exr")
            pxm.render("menger", size=(64, 48)).save(ours, aovs=["Z", "N", "word"])
            subprocess.run(
                [PROGRAM, "render", "menger", "--size", "64x48", "--quiet", "--aov", "Z,N,word", "-o", theirs],
                check=True,
            )
            self.assertEqual(len(ours.read_bytes()) > 1000, True)
            told = subprocess.run([PROGRAM, "compare", ours, theirs], capture_output=True, text=True)
            self.assertEqual(told.returncode, 0, told.stdout + told.stderr)

    def test_arrays_share_the_memory_of_the_render(self):
        picture = pxm.render("tetra", size=(64, 48))
        for array in (picture.color, picture.depth, picture.normal, picture.word, picture.aov("heap")):
            self.assertEqual(array.shape[:2], (48, 64))
            self.assertFalse(array.flags.owndata)
            self.assertTrue(np.shares_memory(array, picture.pixels))
        picture.pixels["color"][0, 0, 0] = 2.5
        color = picture.color
        self.assertEqual(color[0, 0, 0], 2.5)
        del picture
        self.assertEqual(color[0, 0, 0], 2.5)  # the memory lives as long as an array of it

    def test_what_is_known_of_a_pixel_fits_together(self):
        picture = pxm.render("tetra", size=(64, 48))
        hit = picture.hit
        self.assertGreater(hit.sum(), 300)
        np.testing.assert_array_equal(picture.word != 0, hit)
        np.testing.assert_array_equal(picture.aov("level") >= 0, hit)
        np.testing.assert_array_equal(picture.aov("object") >= 0, hit)
        self.assertTrue((picture.depth[hit] > 0).all())
        self.assertEqual(picture.statistics["rays"]["eye"], 64 * 48)

    def test_a_png_has_the_bytes_of_srgb(self):
        picture = pxm.render("tetra", size=(40, 30))
        png = picture._repr_png_()
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", png[16:24]), (40, 30))
        place = png.index(b"IDAT")
        length = struct.unpack(">I", png[place - 4 : place])[0]
        lines = np.frombuffer(zlib.decompress(png[place + 4 : place + 4 + length]), np.uint8).reshape(30, 121)
        np.testing.assert_array_equal(lines[:, 1:].reshape(30, 40, 3), picture.srgb())
        self.assertGreater(picture.srgb().max(), 100)

    def test_a_window_is_part_of_the_image(self):
        whole = pxm.render("tetra", size=(64, 48))
        part = pxm.render("tetra", size=(64, 48), crop=(16, 8, 48, 40))
        self.assertEqual(part.window, (16, 8, 48, 40))
        np.testing.assert_array_equal(part.word, whole.word[8:40, 16:48])

    def test_progress_is_told_and_rises(self):
        shares = []
        pxm.render("tetra", size=(512, 512), samples=4, threads=1, progress=shares.append)
        self.assertEqual(shares, sorted(set(shares)))
        self.assertEqual(shares[-1], 1)

    def test_what_progress_throws_ends_the_render(self):
        def refuse(share):
            raise KeyError("enough")

        begin = time.monotonic()
        with self.assertRaisesRegex(KeyError, "enough"):
            pxm.render("tetra", size=(1024, 1024), samples=4096, progress=refuse)
        self.assertLess(time.monotonic() - begin, 120)  # of a render that would take far longer

    def test_control_c_ends_a_render(self):
        # Whoever starts the tests may have it ignored, as shells do behind `&`.
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            pxm.render("tetra", size=(1024, 1024), samples=4096)
        timer.join()
        self.assertLess(time.monotonic() - begin, 120)  # of a render that would take far longer
        self.assertGreater(pxm.render("tetra", size=(32, 24)).hit.sum(), 0)

    def test_others_go_on_while_it_renders(self):
        counted = 0
        done = threading.Event()

        def render():
            pxm.render("tetra", size=(512, 512), samples=16, threads=1)
            done.set()

        thread = threading.Thread(target=render)
        thread.start()
        while not done.is_set():
            counted += 1
            time.sleep(0.001)
        thread.join()
        self.assertGreater(counted, 20)

    def test_two_renders_at_a_time_give_what_each_gives_alone(self):
        alone = {name: pxm.render(name, size=(96, 72)).word.copy() for name in ("tetra", "menger")}
        found = {}

        def render(name):
            found[name] = [pxm.render(name, size=(96, 72), threads=2).word.copy() for _ in range(4)]

        threads = [threading.Thread(target=render, args=(name,)) for name in alone]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for name, words in alone.items():
            self.assertEqual(len(found[name]), 4)
            for word in found[name]:
                np.testing.assert_array_equal(word, words)

    def test_a_machine_counts_what_its_nodes_do(self):
        machine = pxm.Machine("964")
        picture = machine.render("tetra", size=(64, 48))
        self.assertEqual(len(picture.nodes), machine.columns * machine.rows)
        self.assertEqual(picture.nodes["pixels"].sum(), 64 * 48)
        self.assertEqual(picture.nodes["hits"].sum(), picture.hit.sum())
        np.testing.assert_array_equal(picture.nodes["id"], np.arange(64))
        sums = np.bincount(picture.aov("node").ravel(), picture.aov("cycles").ravel(), 64)
        self.assertTrue((picture.nodes["cycles"] >= sums).all())
        self.assertEqual(pxm.render("tetra", size=(8, 8)).nodes.size, 0)
        self.assertEqual(pxm.render("tetra", size=(64, 48), machine="964").nodes["cycles"].sum(), picture.nodes["cycles"].sum())

    def test_a_frame_of_a_film(self):
        film = pxm.Scene(
            "animation { frames: 3 }\ncamera { eye: 0,0,-4 look: 0,0,0 }\n"
            "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 newmap scale: 0.5 translate: 0,key(t: 0 -> 0.5, 1 -> 1),0 }"
        )
        self.assertEqual(film.frames, 3)
        first, last = (film.render(size=(48, 36), frame=frame).word for frame in (0, 2))
        self.assertFalse(np.array_equal(first, last))


class Refusals(unittest.TestCase):
    def test_each_is_an_exception_that_names_what_is_wrong(self):
        for options, expected in [
            ({"size": (0, 48)}, 'size: found "0x48", expected WxH with 1 to 65536 pixels a side'),
            ({"shading": "low-pas"}, r"shading: found \"low-pas\".*did you mean 'low-pass'"),
            ({"samples": 0}, "samples: found 0, expected 1 to 65536"),
            ({"zoom": -1.0}, "zoom: found -1, expected a number greater than 0"),
            ({"threads": -1}, "threads: found -1, expected 0 to 1024"),
            ({"machine": "965"}, 'machine: found "965", expected a model out of'),
            ({"cost_model": "a.json"}, "cost_model: cycles are counted on the machine only"),
            ({"frame": -1.0}, "frame: found -1, expected 0 or more"),
        ]:
            with self.subTest(options), self.assertRaisesRegex(pxm.SettingError, expected):
                pxm.render("tetra", **{"size": (16, 12), **options})
        with self.assertRaisesRegex(ValueError, "model: found '1', expected one of 9"):
            pxm.Machine("1")
        with self.assertRaisesRegex(ValueError, "aov: found 'z', expected one of Z, N"):
            pxm.render("tetra", size=(16, 12)).aov("z")

    def test_files(self):
        with self.assertRaisesRegex(pxm.FileError, "terta: no such file \\(did you mean 'tetra'\\?\\)"):
            pxm.render("terta")
        with self.assertRaises(pxm.PxmError):
            pxm.render("tetra", size=(16, 12)).save("/nowhere/tetra.png")
        with self.assertRaises(OSError):
            pxm.Scene.read("/nowhere/tetra.pxm")

    def test_a_machine_that_is_too_small(self):
        maps = np.zeros((6000, 3, 4))
        maps[:, :, :3] = 0.01 * np.eye(3)
        maps[:, 0, 3] = np.arange(6000)
        with self.assertRaises(pxm.MachineLimitError):
            pxm.Machine("964").render(pxm.System(maps), size=(8, 8))
