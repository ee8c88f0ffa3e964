"""What mypy must see."""
import pxm

pxm.render("tetra", sise=(64, 48))  # wrong
pxm.render(3)  # wrong
pxm.Scene.read("tetra").render(size="64x48")  # wrong
depth: int = pxm.render("tetra").depth  # wrong
pxm.Machine("964").render("tetra", levels="all")  # wrong
