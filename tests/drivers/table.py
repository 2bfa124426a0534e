"""The drivers, the scenes of the quick half, and what is known to differ."""

ANGLE = "build/drivers/angle"

# environment: chooses the driver. renderer: what "snell info" says where it was found. context: of --context.
DRIVERS = {
    "llvmpipe": {"environment": {"GALLIUM_DRIVER": "llvmpipe"}, "renderer": "llvmpipe"},
    "core33": {"environment": {"MESA_GL_VERSION_OVERRIDE": "3.3", "MESA_GLSL_VERSION_OVERRIDE": "330"},
               "renderer": "OpenGL     3.3"},
    "es30": {"environment": {"MESA_GLES_VERSION_OVERRIDE": "3.0"}, "context": "es3.0", "renderer": "OpenGL ES 3.0"},
    "zink": {"environment": {"GALLIUM_DRIVER": "zink", "LIBGL_ALWAYS_SOFTWARE": "1", "XDG_RUNTIME_DIR": "/tmp"},
             "renderer": "zink"},
    "angle": {"environment": {"ANGLE_DEFAULT_PLATFORM": "swiftshader"}, "libraries": ANGLE, "context": "es3.1",
              "renderer": "ANGLE"},
    "softpipe": {"environment": {"GALLIUM_DRIVER": "softpipe"}, "renderer": "softpipe"},
}

CASES = "Background Blend Box Clear Color CubeMap CullFace DepthTest Filter Geometry GeometryInput Include Irradiance " \
        "Ladder Noise2D Obj Prefilter PushMatrix QuadBox RenderToTexture Smooth Sphere Texture1D Texture2D Texture3D Triangles"
QUICK = [f"tests/cases/{name}.glib" for name in CASES.split()]


def cases(names):
    return " ".join(f"tests/cases/{name}" for name in names.split())


# The first that names the driver and the scene holds. share: of the pixels may differ; status: instead of a picture.
EXCEPTIONS = []

# What may fail, and why.
TESTS = {}

BUGS = []
