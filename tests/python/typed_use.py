"""What users write, for mypy --strict: every line has the type that it says."""
import numpy as np
from numpy.typing import NDArray

import pxm

picture: pxm.Picture = pxm.render("tetra", size=(64, 48), covers=(0.05, 2.0))
depth: NDArray[np.float32] = picture.depth
scene: pxm.Scene = pxm.Scene.read("tetra", set={"camera.fov": 30})
again: pxm.Picture = scene.render(progress=lambda share: print(share))
facts: pxm.Inspection = scene.inspect()
exact: float | None = facts.systems["tetra"].dimension.exact
cloud: NDArray[np.float64] = scene.points(1000, seed=2)
counted: pxm.Picture = pxm.Machine("964").render("tetra", size=(16, 16))
system = pxm.System(np.zeros((1, 3, 4)), follow={0: [0]}, weights=[1])
made = pxm.Scene([system, pxm.Object(system, name="other")], camera=pxm.Camera(eye=(0, 0, -3)))
