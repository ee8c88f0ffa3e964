"""Laws of scenes: from text, files and objects; what is asked of them; and what is wrong with them."""
import pickle
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import pxm

TETRA = """ifs tetra {
    newmap scale: 0.5 translate: 0,0.5,0
    newmap scale: 0.5 translate: 0,-1/6,-sqrt(2)/3
    newmap scale: 0.5 translate: sqrt(6)/6,-1/6,sqrt(2)/6
    newmap scale: 0.5 translate: -sqrt(6)/6,-1/6,sqrt(2)/6
}
"""


def tetra_maps():
    maps = np.zeros((4, 3, 4))
    maps[:, :, :3] = 0.5 * np.eye(3)
    maps[:, :, 3] = [
        (0, 0.5, 0),
        (0, -1 / 6, -(2**0.5) / 3),
        (6**0.5 / 6, -1 / 6, 2**0.5 / 6),
        (-(6**0.5) / 6, -1 / 6, 2**0.5 / 6),
    ]
    return maps


def random_maps(count, seed):
    random = np.random.default_rng(seed)
    maps = random.normal(size=(count, 3, 4))
    for matrix in maps:
        matrix[:, :3] *= random.uniform(0.2, 0.6) / np.linalg.norm(matrix[:, :3], 2)
    return maps


class FromObjects(unittest.TestCase):
    def test_a_system_of_arrays_is_the_one_of_the_text(self):
        of_text = pxm.Scene(TETRA).render(size=(96, 72))
        of_arrays = pxm.render(pxm.System(tetra_maps(), name="tetra"), size=(96, 72))
        np.testing.assert_array_equal(of_text.pixels, of_arrays.pixels)

    def test_columns_are_multiplied_from_the_left(self):
        """A point of the attractor stays in it when a map is applied as the array says."""
        for seed in range(3):
            maps = random_maps(3, seed)
            scene = pxm.Scene(pxm.System(maps))
            ball = scene.inspect().systems["system"].bounding_sphere
            points = scene.points(2000)
            for matrix in maps:
                moved = points @ matrix[:, :3].T + matrix[:, 3]
                self.assertLess(np.linalg.norm(moved - ball.center, axis=1).max(), ball.radius * (1 + 1e-9))
            fixed = np.linalg.solve(np.eye(3) - maps[0][:, :3], maps[0][:, 3])
            self.assertLess(np.linalg.norm(points - fixed, axis=1).min(), 0.2 * ball.radius)

    def test_a_system_comes_back_as_it_was_given(self):
        maps = random_maps(3, 7)
        follow = np.array([[1, 1, 0], [0, 1, 1], [1, 0, 0]], dtype=bool)
        colors = np.array([[1, 0, 0, 0.5], [0, 1, 0, 0.25], [0, 0, 1, 1]])
        given = pxm.System(
            maps, name="graph", names=["a", "b", "c"], follow=follow, start=["b", 0], weights=[1, 2, 3.5], colors=colors
        )
        (found,) = pxm.Scene(given).systems
        np.testing.assert_array_equal(found.maps, maps)
        np.testing.assert_array_equal(found.follow, follow)
        np.testing.assert_array_equal(found.colors, colors)
        np.testing.assert_array_equal(found.weights, [1, 2, 3.5])
        self.assertEqual((found.name, found.names, found.start), ("graph", ("a", "b", "c"), (1, 0)))
        by_names = pxm.System(maps, names=["a", "b", "c"], follow={"a": ["a", 1], "b": ["b", "c"], 2: [0]})
        np.testing.assert_array_equal(by_names.follow, follow)

    def test_follow_changes_the_attractor(self):
        maps = tetra_maps()
        free = pxm.Scene(pxm.System(maps)).inspect().systems["system"].dimension.exact
        self.assertAlmostEqual(free, 2)
        no_repeats = pxm.Scene(pxm.System(maps, follow=1 - np.eye(4))).inspect().systems["system"]
        self.assertAlmostEqual(no_repeats.dimension.similarity, np.log2(3), places=9)

    def test_a_whole_scene(self):
        ball = pxm.System(tetra_maps(), name="tetra")
        scene = pxm.Scene(
            [pxm.Object(ball, name="left", color=(1, 0, 0, 1)), pxm.Object(ball, name="right", matrix=np.eye(3, 4))],
            camera=pxm.Camera(eye=(0, 1, -4), look=(0, 0, 0), fov=35),
            lights=[pxm.Light(direction=(0, 1, 0), shadow=True), pxm.Light(position=(3, 3, -3))],
            planes=[pxm.Plane(point=(0, -1, 0), reflect=0.25)],
            render={"ambient": (0.1, 0.1, 0.1), "shading": "low-pass", "samples": 2},
        )
        self.assertEqual(len(scene.inspect().objects), 2)
        self.assertGreater(scene.render(size=(64, 48)).hit.sum(), 1000)
        self.assertEqual(pxm.Scene(scene.text).text, scene.text)

    def test_what_is_wrong_is_named(self):
        maps = tetra_maps()
        broken = maps.copy()
        broken[2, 1, 3] = np.nan
        for arguments, expected in [
            ({"maps": maps[0]}, r"maps: found the shape \(3, 4\), expected \(n, 3, 4\)"),
            ({"maps": np.zeros((0, 3, 4))}, "maps: found the shape"),
            ({"maps": broken}, r"maps: found nan at \(2, 1, 3\), expected finite numbers"),
            ({"weights": [1, 2]}, r"weights: found the shape \(2,\), expected \(4,\)"),
            ({"colors": np.ones((4, 3))}, r"colors: found the shape \(4, 3\), expected \(4, 4\)"),
            ({"follow": np.zeros((4, 4))}, "follow: nothing may follow map 0"),
            ({"follow": np.ones((3, 3))}, r"follow: found the shape \(3, 3\), expected \(4, 4\)"),
            ({"follow": {0: [9]}}, "found the map 9, expected 0 to 3"),
            ({"names": ["a"]}, "names: found 1 names, expected one of each of the 4 maps"),
        ]:
            with self.subTest(expected), self.assertRaisesRegex(ValueError, expected):
                pxm.System(**{"maps": maps, **arguments})
        two = [pxm.System(maps, name="a"), pxm.System(2 * maps, name="a")]
        with self.assertRaisesRegex(ValueError, "two systems have the name 'a'"):
            pxm.Scene(two)
        with self.assertRaises(pxm.SceneError):
            pxm.Scene(pxm.System(maps, name="no name"))
        with self.assertRaisesRegex(pxm.SceneError, "could not be shown to contract"):
            pxm.Scene(pxm.System(3 * maps)).render(size=(8, 8))


class FromTextAndFiles(unittest.TestCase):
    def test_mistakes_have_places_and_carets(self):
        with self.assertRaises(pxm.SceneError) as raised:
            pxm.Scene("ifs a {\n    newmap scale: 0.5\n    newmap scal: 0.5\n}\nlight { colour: 1,1,1 }\n", name="mine")
        error = raised.exception
        self.assertEqual((error.file, error.line, error.column), ("mine", 3, 12))
        self.assertEqual(error.mistakes[1].line, 5)
        self.assertEqual(len(error.mistakes), 2)
        lines = str(error).splitlines()
        self.assertTrue(lines[0].startswith("mine:3:12: error: "), lines)
        self.assertEqual(lines[2].index("^"), lines[1].index("scal"))
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.mistakes), (str(error), error.mistakes))

    def test_a_file_finds_what_it_includes(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "part.pxm").write_text(TETRA)
            Path(folder, "whole.pxm").write_text('include: "part.pxm"\nobject it { ifs: tetra }\n')
            scene = pxm.Scene.read(Path(folder, "whole.pxm"), set={"object.it.levels": 2})
            self.assertEqual(scene.inspect().objects[0].name, "it")
            self.assertEqual(scene.render(size=(48, 36)).aov("level").max(), 2)

    def test_scenes_come_by_their_names(self):
        self.assertIn("tetra", pxm.scene_names())
        self.assertTrue(pxm.Scene.read("exhibition/forest").path.endswith("forest.pxm"))

    def test_a_notebook_shows_a_picture_and_the_text(self):
        page = pxm.Scene(TETRA)._repr_html_()
        self.assertIn('<img src="data:image/png;base64,iVBOR', page)
        self.assertIn("ifs tetra {", page)
        self.assertIn("<table>", pxm.System(tetra_maps())._repr_html_())

    def test_a_scene_can_be_sent_to_another_process(self):
        scene = pickle.loads(pickle.dumps(pxm.Scene.read("tetra")))
        np.testing.assert_array_equal(scene.render(size=(32, 24)).word, pxm.render("tetra", size=(32, 24)).word)


class Questions(unittest.TestCase):
    def test_inspect_knows_the_dimension(self):
        facts = pxm.inspect(pxm.Scene(TETRA))
        tetra = facts.systems["tetra"]
        self.assertAlmostEqual(tetra.dimension.exact, 2)
        self.assertEqual(len(tetra.maps), 4)
        self.assertEqual(tetra.maps[0].fixed_point, (0, 1, 0))
        self.assertAlmostEqual(tetra.contractivity, 0.5)
        self.assertAlmostEqual(tetra.bounding_sphere.radius, 1, places=6)
        self.assertFalse(facts.over_limit)
        self.assertGreater(facts.memory["back_buffer"].used_bytes, 0)
        self.assertEqual(facts.json["scene"], "scene")

    def test_points_lie_in_the_attractor(self):
        scene = pxm.Scene(TETRA)
        points = scene.points(200_000)
        self.assertEqual((points.shape, points.dtype), ((200_000, 3), np.float64))
        self.assertLess(np.linalg.norm(points, axis=1).max(), 1 + 1e-9)
        np.testing.assert_array_equal(points, scene.points(200_000, threads=1))
        np.testing.assert_array_equal(points, scene.colored_points(200_000)[0])
        self.assertFalse(np.array_equal(points, scene.points(200_000, seed=2)))
        # Each of four corners has a quarter of them.
        corner = np.argmax(points @ tetra_maps()[:, :, 3].T, axis=1)
        np.testing.assert_allclose(np.bincount(corner) / 200_000, 0.25, atol=0.01)

    def test_colours_of_points(self):
        painted = pxm.System(tetra_maps(), colors=np.array([[1, 0, 0, 1]] * 4))
        _, colors = pxm.Scene(painted).colored_points(1000)
        np.testing.assert_allclose(colors, np.tile([1, 0, 0], (1000, 1)), atol=1e-12)

    def test_there_are_no_points_of_no_fractal(self):
        with self.assertRaisesRegex(pxm.SceneError, "no linear fractal"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            pxm.Scene("object ball { sphere: (0,0,0) 1 }").points(10)
        with self.assertRaisesRegex(ValueError, "count: found 0"):
            pxm.points("tetra", 0)

    def test_warnings_are_told(self):
        doubtful = "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 }\nobject a { ifs: a sphere: (0,0,0) 0.1 }"
        with self.assertWarns(pxm.PxmWarning):
            picture = pxm.Scene(doubtful).render(size=(32, 24))
        self.assertIn("warning", picture.warnings)
