# Two pictures of one size have the same silhouette, up to a share of its pixels:
# same_silhouette.py OURS THEIRS SHARE. Ours is black where nothing is, theirs transparent.
import subprocess
import sys


def pixels(path):
    """Four bytes a pixel."""
    done = subprocess.run(["convert", path, "-alpha", "on", "-depth", "8", "rgba:-"], capture_output=True, check=True)
    return done.stdout


ours, theirs = pixels(sys.argv[1]), pixels(sys.argv[2])
assert len(ours) == len(theirs) > 0, (len(ours), len(theirs))
inside = [any(ours[i : i + 3]) for i in range(0, len(ours), 4)]
there = [alpha > 127 for alpha in theirs[3::4]]
covered = sum(inside)
different = sum(a != b for a, b in zip(inside, there))
print(f"{sys.argv[1]} covers {covered} pixels, {sys.argv[2]} {sum(there)}; {different} differ")
assert covered > 300 and different <= float(sys.argv[3]) * covered
