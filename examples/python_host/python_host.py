# SPDX-License-Identifier: MIT
"""Composes a recipe by the C library: python_host.py LIBRARY RECIPE"""
import sys

import crease


def main(path, recipe):
    library = crease.load(path)
    view = crease.View()
    # A field of view of 90 degrees, depth from 1 at the near plane to 0 at infinity.
    projection = (crease.c_float * 16)(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, -1, 0, 0, 0.1, 0)
    error = library.crease_set_projection(view, projection, 512, 512, 0, 0)
    if error:
        raise ValueError(error.decode())
    with crease.Composition(library, recipe) as composed:
        print(composed.effect.recipe.decode())
        for each in composed.passes:
            print(f"pass {each.name.decode()}: {len(each.text)} bytes of GLSL")
        for each in composed.settings:
            print(f"setting {each.part.decode()}.{each.name.decode()}: {each.least:g} to {each.most:g}")
        print(f"uniform block: {len(composed.block(view, radius=0.75, strength=1.2))} bytes")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except (OSError, ValueError) as error:
        sys.exit(str(error))
