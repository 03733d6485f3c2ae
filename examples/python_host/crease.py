# SPDX-License-Identifier: MIT
"""crease for Python by ctypes: the structs and functions of crease_c.h that this example needs, under the same names."""
import ctypes
from ctypes import POINTER, Structure, c_char_p, c_float, c_int, c_int32, c_size_t, c_uint32, c_void_p


class Extent(Structure):
    _fields_ = [(name, c_uint32) for name in ("divisor", "guarded", "fixed_width", "fixed_height", "level")]


class Binding(Structure):
    _fields_ = [("name", c_char_p), ("resource", c_uint32), ("access", c_int), ("set", c_uint32),
                ("slot", c_uint32), ("level", c_uint32)]


class Constant(Structure):
    _fields_ = [("part", c_char_p), ("number", c_char_p), ("id", c_uint32), ("value", c_int32)]


class Pass(Structure):
    _fields_ = [("name", c_char_p), ("stage", c_int), ("dialect", c_int), ("text", c_char_p),
                ("vertex_text", c_char_p), ("bindings", POINTER(POINTER(Binding))),
                ("constants", POINTER(POINTER(Constant))), ("binding_count", c_uint32), ("constant_count", c_uint32),
                ("size", Extent), ("dispatch", c_int), ("group_width", c_uint32), ("group_height", c_uint32),
                ("view", c_uint32)]


class Resource(Structure):
    _fields_ = [("name", c_char_p), ("kind", c_int), ("format", c_int), ("element", c_char_p), ("lifetime", c_int),
                ("size", Extent), ("meaning", c_char_p), ("layers", c_uint32), ("levels", c_uint32),
                ("samples", c_uint32), ("arrayed", c_uint32), ("centred", c_uint32), ("previous_of", c_char_p),
                ("cleared", c_uint32), ("clear", c_uint32), ("texels", POINTER(c_uint32)), ("texel_count", c_uint32),
                ("content", c_char_p)]


class Setting(Structure):
    _fields_ = [("part", c_char_p), ("name", c_char_p), ("meaning", c_char_p), ("fallback", c_float),
                ("least", c_float), ("most", c_float), ("shared", c_uint32), ("offset", c_uint32)]


class Features(Structure):
    _fields_ = [(name, c_uint32) for name in ("extended_storage_formats", "fragment_stores_and_atomics",
                                              "subgroup_arithmetic", "depth_samples", "centred_depth_samples")]


class Effect(Structure):
    _fields_ = [("recipe", c_char_p), ("parts", c_void_p), ("passes", POINTER(POINTER(Pass))),
                ("resources", POINTER(POINTER(Resource))), ("settings", POINTER(POINTER(Setting))),
                ("part_count", c_uint32), ("pass_count", c_uint32), ("resource_count", c_uint32),
                ("setting_count", c_uint32), ("view_count", c_uint32), ("block_size", c_uint32),
                ("from_first_offset", c_uint32), ("radius_offset", c_uint32), ("frame_offset", c_uint32),
                ("features", Features)]


class View(Structure):
    _fields_ = [("from_texel", c_float * 4), ("depth_unpack", c_float * 2), ("far_depth", c_float),
                ("guard", c_float), ("resolution", c_float * 2), ("texel_size", c_float * 2)]


def load(path):
    """The library at a path, its functions declared."""
    library = ctypes.CDLL(path)
    for name, result, arguments in (
            ("crease_c_version_text", c_char_p, []),
            ("crease_compose", c_void_p, [c_char_p]),
            ("crease_error", c_char_p, [c_void_p]),
            ("crease_effect_of", POINTER(Effect), [c_void_p]),
            ("crease_destroy", None, [c_void_p]),
            ("crease_write_defaults", c_char_p, [POINTER(Effect), c_void_p, c_size_t]),
            ("crease_set", c_char_p, [POINTER(Effect), c_void_p, c_char_p, c_float]),
            ("crease_set_projection", c_char_p, [POINTER(View), POINTER(c_float)] + [c_uint32] * 4)):
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


class Composition:
    """The effect of a recipe; a ValueError with crease's sentence where there is none. For use in `with`."""

    def __init__(self, library, recipe):
        self.library = library
        self.handle = library.crease_compose(recipe.encode())
        error = library.crease_error(self.handle)
        if error:
            self.__exit__()
            raise ValueError(error.decode())
        self.effect = library.crease_effect_of(self.handle).contents

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.library.crease_destroy(self.handle)

    @property
    def passes(self):
        return [self.effect.passes[i].contents for i in range(self.effect.pass_count)]

    @property
    def settings(self):
        return [self.effect.settings[i].contents for i in range(self.effect.setting_count)]

    def block(self, view, radius, **settings):
        """The bytes of the uniform block."""
        block = ctypes.create_string_buffer(self.effect.block_size)
        self._require(self.library.crease_write_defaults(self.effect, block, len(block)))
        for name, value in settings.items():
            self._require(self.library.crease_set(self.effect, block, name.encode(), value))
        ctypes.memmove(block, ctypes.byref(view), ctypes.sizeof(view))
        c_float.from_buffer(block, self.effect.radius_offset).value = radius
        return bytes(block)

    @staticmethod
    def _require(error):
        if error:
            raise ValueError(error.decode())
