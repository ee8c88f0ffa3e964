# What ffmpeg and ImageMagick read of EXR pictures of cubes.pxm is the PNG of the same render, pixel by
# pixel; around a data window ffmpeg has black and ImageMagick white.
import array

columns, rows = 320, 240
left, top, right, bottom = 100, 60, 220, 140


def srgb(linear):
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055


def of_ffmpeg(name):
    """Its planes are green, blue and red."""
    floats = array.array("f", open(name + ".planes", "rb").read())
    pixels = columns * rows
    assert len(floats) == 3 * pixels, (name, len(floats))
    return [(floats[2 * pixels + i], floats[i], floats[pixels + i]) for i in range(pixels)]


def of_imagemagick(name):
    floats = array.array("f", open(name + ".floats", "rb").read())
    assert len(floats) == 3 * columns * rows, (name, len(floats))
    return list(zip(floats[0::3], floats[1::3], floats[2::3]))


data = open("whole.bytes", "rb").read()
expected = list(zip(data[0::3], data[1::3], data[2::3]))
assert sum(any(pixel) for pixel in expected) > 1000
# ImageMagick has its raw numbers in sRGB.
for reader, shade, around in ((of_ffmpeg, srgb, 0), (of_imagemagick, float, 1)):
    for name in ("whole", "half", "aov", "crop"):
        pixels = reader(name)
        for i, (found, bytes_) in enumerate(zip(pixels, expected)):
            row, column = divmod(i, columns)
            if name == "crop" and not (left <= column < right and top <= row < bottom):
                assert found == (around,) * 3, (reader.__name__, column, row, found)
                continue
            # ImageMagick reads floats of 16 bits.
            near = all(abs(255 * shade(f) - b) <= 0.7 for f, b in zip(found, bytes_))
            assert near, (reader.__name__, name, column, row, found, bytes_)
print("pictures: ffmpeg and ImageMagick read the pixels of the PNG")
