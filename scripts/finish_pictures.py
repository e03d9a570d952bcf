"""Makes small files of the pictures that scripts/pictures has taken: few colours, one animation of its frames, two views next to each other."""
import glob
import os
import shutil
import sys

from PIL import Image

COLOURS = 128
FRAME_MS = 140
ANIMATION_WIDTH = 800
PREVIEW = (800, 350)
CELL = (780, 480)


def small(image):
    return image.convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)


def middle_of(image, size):
    """As much of its middle as has that shape, in that size."""
    width, height = image.size
    scale = min(width / size[0], height / size[1])
    left, top = (width - scale * size[0]) / 2, (height - scale * size[1]) / 2
    box = (left, top, left + scale * size[0], top + scale * size[1])
    return image.convert("RGB").resize(size, Image.Resampling.LANCZOS, box=box)


def animation(files, target):
    frames = []
    for file in files:
        image = Image.open(file).convert("RGB")
        frames.append(image.resize((ANIMATION_WIDTH, ANIMATION_WIDTH * image.height // image.width), Image.Resampling.LANCZOS))
    # One palette for all: colours that change from frame to frame flicker, and cost bytes.
    palette = frames[len(frames) // 2].quantize(64, dither=Image.Dither.NONE)
    frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    frames[0].save(target, save_all=True, append_images=frames[1:], duration=FRAME_MS, loop=0, optimize=True)


def main():
    taken, pictures = sys.argv[1:]
    for name in ("laws.svg", "corner.svg"):
        shutil.copy(os.path.join(taken, name), pictures)
    for name in ("panel-move-absolute", "panel-ghost", "panel-refused", "panel-jog"):
        small(Image.open(os.path.join(taken, name + ".png"))).save(os.path.join(pictures, name + ".png"), optimize=True)
    frames = sorted(glob.glob(os.path.join(taken, "frames", "*.png")))
    small(Image.open(frames[len(frames) * 2 // 5])).save(os.path.join(pictures, "panel-pick-and-place.png"), optimize=True)
    animation(frames, os.path.join(pictures, "pick-and-place.gif"))
    both = Image.new("RGB", PREVIEW)
    for place, name in enumerate(("preview-driven", "preview-refused")):
        view = middle_of(Image.open(os.path.join(taken, name + ".png")), (PREVIEW[0] // 2, PREVIEW[1]))
        both.paste(view, (place * PREVIEW[0] // 2, 0))
    small(both).save(os.path.join(pictures, "preview.png"), optimize=True)
    small(middle_of(Image.open(os.path.join(taken, "cell-monitor.png")), CELL)).save(os.path.join(pictures, "cell-monitor.png"), optimize=True)
    small(Image.open(os.path.join(taken, "report", "report.png"))).save(os.path.join(pictures, "flight-report.png"), optimize=True)


if __name__ == "__main__":
    main()
