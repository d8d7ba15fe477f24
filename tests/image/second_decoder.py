#!/usr/bin/env python3
"""Decodes pictures with Pillow and ImageMagick, and writes some of its own.

    second_decoder.py FOLDER

For each picture in the folder that one of the two reads, FOLDER/NAME.pillow and FOLDER/NAME.magick get its pixels as PNG.
Before that, the variants that the two can write are added as
made-*. Ends with status 77 if Pillow or ImageMagick is missing.
"""

import shutil
import subprocess
import sys
from pathlib import Path

try:
    from PIL import Image
except ImportError:
    sys.exit(77)
CONVERT, MOGRIFY = shutil.which("convert"), shutil.which("mogrify")
if not CONVERT or not MOGRIFY:
    sys.exit(77)

WIDTH, HEIGHT = 21, 13


def source(alpha):
    picture = Image.new("RGBA", (WIDTH, HEIGHT))
    picture.putdata([((x * 37 + y * 5) % 256, (x * 11 + y * 71) % 256, (x * x + 3 * y) % 256,
                      (x * 50 + y * 31) % 256 if alpha else 255)
                     for y in range(HEIGHT) for x in range(WIDTH)])
    return picture


def make(folder):
    clear, solid = source(True), source(False).convert("RGB")
    palette, grey, bits = solid.quantize(13), solid.convert("L"), solid.convert("1")
    both = {"clear": clear, "solid": solid, "grey": grey, "palette": palette, "bits": bits}
    for kind, picture in both.items():
        for name, options in {
            "plain.tga": {}, "rle.tga": {"compression": "tga_rle"}, "up.tga": {"orientation": 1}, "plain.gif": {},
            "plain.sgi": {}, "plain.ppm": {}, "plain.dds": {}, "best.webp": {"lossless": True, "exact": True},
            "raw.tif": {}, "lzw.tif": {"compression": "tiff_lzw"}, "deflate.tif": {"compression": "tiff_deflate"},
            "bits.tif": {"compression": "packbits"}, "plain.ico": {"sizes": [(WIDTH, HEIGHT)]}, "plain.bmp": {},
        }.items():
            try:
                picture.save(folder / f"made-{kind}-{name}", **options)
            except (OSError, ValueError, KeyError):
                pass  # not every format has every kind
    for turn in range(2, 9):
        solid.save(folder / f"made-turned-{turn}.tif", tiffinfo={274: turn})
    clear.save(folder / "source.png")
    solid.save(folder / "solid.png")
    commands = {alpha: [CONVERT, "-respect-parentheses", str(folder / (alpha + ".png"))] for alpha in ("source", "solid")}
    for name, options in {
        "interlaced.gif": ["-interlace", "GIF"], "rle.sgi": ["-compress", "RLE"], "none.sgi": ["-compress", "None"],
        "deep.sgi": ["-depth", "16", "-compress", "RLE"], "plain.pgm": ["-compress", "None"],
        "plain.pbm": ["-compress", "None"], "raw.pbm": [], "plain.ppm": ["-compress", "None"],
        "deep.ppm": ["-depth", "16"], "deep.pgm": ["-depth", "16"], "rle.tga": ["-compress", "RLE"],
        "dxt1.dds": ["-define", "dds:compression=dxt1"], "dxt5.dds": ["-define", "dds:compression=dxt5"],
        "levels.dds": ["-define", "dds:compression=none", "-define", "dds:mipmaps=3"],
        "fax.tif": ["-monochrome", "-compress", "Group4"],
        "tiles.tif": ["-define", "tiff:tile-geometry=16x16"], "lines.tif": ["-define", "tiff:rows-per-strip=1"],
        "planes.tif": ["-interlace", "Plane"], "big.tif": ["-define", "tiff:endian=msb"],
        "deep.tif": ["-depth", "16"], "one.tif": ["-monochrome", "-depth", "1"], "two.tif": ["-colors", "4", "-depth", "2"],
        "four.tif": ["-colors", "16"], "inks.tif": ["-colorspace", "CMYK"], "twelve.tif": ["-depth", "12"],
        "greys.tif": ["-colorspace", "gray", "-depth", "4"], "lab.tif": ["-colorspace", "lab"],
        "white.tif": ["-define", "quantum:polarity=min-is-white", "-colorspace", "gray"],
        "order.tif": ["-define", "tiff:fill-order=lsb"], "order1.tif": ["-define", "tiff:fill-order=lsb", "-monochrome"],
        "order2.tif": ["-define", "tiff:fill-order=lsb", "-compress", "LZW"],
        "order3.tif": ["-define", "tiff:fill-order=lsb", "-compress", "None"],
        "order4.tif": ["-define", "tiff:fill-order=lsb", "-monochrome", "-compress", "Group4"], "jpeg.tif": ["-compress", "JPEG"],
        "ycc.tif": ["-colorspace", "YCbCr"], "fax3.tif": ["-monochrome", "-compress", "Fax"],
        "plain.jpg": ["-sampling-factor", "1x1"], "progressive.jpg": ["-interlace", "JPEG"], "grey.jpg": ["-colorspace", "gray"],
        "inks.jpg": ["-colorspace", "CMYK"], "plain.psd": ["-compress", "RLE"], "flat.psd": ["-compress", "None"],
        "grey.psd": ["-colorspace", "gray", "-compress", "RLE"], "deep.psd": ["-depth", "16", "-compress", "RLE"],
        "grey.avif": ["-colorspace", "gray"], "grey.heic": ["-colorspace", "gray"],
        "rle8.bmp": ["-colors", "20", "-compress", "RLE"], "old.bmp": ["-define", "bmp:format=bmp2"],
        "associated.tif": ["-define", "tiff:alpha=associated"],  # the last: ImageMagick 7 keeps it for the pictures after it
    }.items():
        form = {"big.tif": "TIFF:", "old.bmp": "BMP2:"}.get(name, "")
        for alpha, command in commands.items():
            command += ["(", "+clone", *options, "-write", f"{form}{folder / f'made-{alpha}-{name}'}", "+delete", ")"]
    for command in commands.values():
        subprocess.run([*command, "null:"], stderr=subprocess.DEVNULL, check=False)


def by_pillow(file):
    try:
        with Image.open(file) as picture:
            picture.seek(0)
            if not picture.mode.startswith(("I", "F", "CMYK")):
                picture.convert("RGBA").save(f"{file}.pillow", "png")
    except Exception:  # Pillow raises errors of every kind for damaged files
        pass


def by_imagemagick(folder, files):
    out = folder / "png"
    out.mkdir()
    for suffix in sorted({file.suffix for file in files}):
        same = [file for file in files if file.suffix == suffix]
        subprocess.run([MOGRIFY, "-coalesce", "-auto-orient", "+repage", "-colorspace", "sRGB", "-depth", "8", "-path",
                        str(out), "-format", "png", *map(str, same)], stderr=subprocess.DEVNULL, check=False)
        for file in same:
            # Of several pictures, the first one.
            for made in (out / f"{file.stem}.png", out / f"{file.stem}-0.png"):
                if made.exists():
                    made.rename(folder / f"{file.name}.magick")
                    break
        for rest in out.iterdir():
            rest.unlink()
    out.rmdir()


def main():
    folder = Path(sys.argv[1])
    make(folder)
    files = [file for file in sorted(folder.iterdir()) if file.suffix != ".png"]
    for file in files:
        by_pillow(file)
    by_imagemagick(folder, files)


main()
