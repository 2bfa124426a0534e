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


LINES = cases("Wire* LineWidth LinesAdjacency NumPatchVertices ObjAdj ObjPatch Shp glBegin glEnd")
POINTS = cases("PointCloud PointSize PointSizeMode JitterCloud")

# The first that names the driver and the scene holds. share: of the pixels may differ.
EXCEPTIONS = [
    {"drivers": ["softpipe", "angle"], "scenes": LINES, "share": .06,
     "why": "lines begin, end and step at other pixels, which OpenGL leaves to the driver"},
    {"drivers": ["softpipe", "angle"], "scenes": POINTS, "share": .04,
     "why": "a point covers one row of pixels more or fewer, which OpenGL leaves to the driver"},
    {"drivers": ["softpipe", "angle"], "scenes": cases("Noise2D Noise3D"), "share": .07,
     "why": "llvmpipe weighs neighbouring texels in steps of 1/256; the noise's contrast is raised eightfold"},
    {"drivers": ["softpipe"], "scenes": cases("Flat Cylinder"), "share": .01,
     "why": "an edge goes exactly through the centres of pixels; which side has them is left to the driver"},
    {"drivers": ["angle"], "scenes": cases("CubeMap Prefilter Ladder Texture2D glTexCoord Clamp RenderToTexture RenderToCube Include")
     + " scenes/light/*/* scenes/refraction-room/*", "share": .14,
     "why": "SwiftShader interpolates otherwise what passes between the shaders (it places vertices by 1/16 of a pixel, "
            "llvmpipe by 1/256), and mirrors magnify it; directions computed from gl_FragCoord give the same picture"},
    {"drivers": ["angle"], "scenes": cases("Box Cone Cylinder Fragment Geometry GeometryInput GeometryOutput LookAt Obj QuadBox Soccerball Teapot Torus"),
     "share": .01, "why": "for the same reason, single pixels of edges belong to the other side"},
]

# Scenes that are drawn with other rungs too, because these need more of OpenGL.
RUNGS = [("scenes/light/crystal/crystal.glib", "BEND=mesh")]

# What OpenGL ES 3.0 lacks, by scene: the message that says so. All others are the same.
REFUSED_BY_ES30 = {
    "Wireframe": "wireframe-unsupported",  # no glPolygonMode
    "ObjPatch": "wireframe-unsupported",   # draws what it divides as wires
}

# By driver: the tests that are run, perhaps with a filter, the names of those that may fail, and why.
TESTS = {
    "zink": [("harness", "*", {}), ("pictures", "*", {}),
             ("runtime", "*", {"RandomPrograms.GiveWhat*": "of 7 expressions, one form gives NaN and the other a number"}),
             ("library", "*", {})],
    "softpipe": [
        ("harness", "*", {"Harness.AskedForADebugContext": "softpipe has no debug contexts"}),
        ("pictures", "Pictures.*:Cases.*", {"Pictures.ShowWhatTheCasesDraw": "softpipe has one sample a pixel",
                                           "Cases.EveryCommand*": "its compiler warns of an extension that it lacks"}),
    ],
}

# Markdown, one for each.
BUGS = [
    "snell, found by softpipe: in OpenGL 3.3, uniforms that only a geometry shader uses were taken for unused, and its "
    "picture was empty. Fixed (`Faults.OpenGl33DrawsGeometryAsOpenGl45Does`).",
    "snell, found by ANGLE: wide lines were thin without a word where neither the driver nor a geometry stage widens "
    "them. Said now (`NarrowLines.WithoutGeometryShadersAreSaidToStayThin`).",
    "snell, found by softpipe: a debug build, and every test of OpenGL, found no graphics where the driver makes no debug "
    "contexts. Fixed; the tests below could not run otherwise.",
    "snell, found by ANGLE: a machine with OpenGL ES only was one without graphics unless `--context es3.0` was given. "
    "Fixed (`Faults.OpenGlEsServesWhereThereIsNoOpenGl`).",
    "snell, found by ANGLE, whose compiler is stricter than Mesa's: OpenGL ES 3.0 and 3.1 pass no interface blocks between "
    "shaders. They become single variables (`GlslStages.BlocksAreSingleVariablesInEs30`, `Reference.AcceptsEs30`).",
    "snell, found by the tests on OpenGL ES 3.0: `PointSizeMode 0` did not outdo a `gl_PointSize` that the shader writes. "
    "Fixed (`ContextEs.PointsAreAsLargeAsTheirModeSays`).",
    "snell, found on a GPU (NVIDIA H100, driver 580.159): its compiler takes `!(x > 0.)` for `x <= 0.`, so that NaN passed the "
    "guards of the library, and it flushes `1 / x` to 0 for x above 8e37. 3 % of special values gave reflectances that "
    "were not in [0,1], 19 % hits of a ball that are NaN. Fixed: none (`LibraryFresnel.SpecialValuesGiveReflectances`, "
    "`LibraryRay.SpecialValuesGiveNumbers`, `Library.ConditionsSayWhatMustHold`).",
    "NVIDIA H100 (driver 580.159, OpenGL 4.5): 94 of 105 pictures are llvmpipe's. Noise2D and Noise3D differ by the weights of "
    "texels, Cylinder at an edge that goes through the centres of pixels, and seven by single pixels of edges, points, lines and mirrors; "
    "one could not be drawn, for lack of OpenImageIO there. The tests of the library pass, but for the errors of two-sided glass, which are a sixth larger where they are .1 of a degree. Its tessellator lists triangles in another order and with other diagonals, which OpenGL "
    "leaves to the driver; a geometry shader may emit 1024 numbers there, and lines that one emits are at most ten "
    "pixels wide.",
    "softpipe (Mesa 22.3.6) refuses `EGL_CONTEXT_OPENGL_DEBUG` with `EGL_BAD_ATTRIBUTE`.",
    "zink (Mesa 22.3.6) does not start by `MESA_LOADER_DRIVER_OVERRIDE` without a display (`failed to create dri2 screen`).",
    "ANGLE's EGL also makes contexts of OpenGL 4.6, whose functions libepoxy takes from the system's libGL; `--context "
    "es3.1` must be given.",
    "In OpenGL, llvmpipe and softpipe draw no point whose position is outside of the picture; in OpenGL ES (3.0 to 3.2), "
    "llvmpipe draws the part of it that reaches in. With `PointSize` above 1, the picture's edge differs.",
    "llvmpipe, and so zink over lavapipe, weigh neighbouring texels in steps of 1/256: a ramp between two texels is wrong by "
    "up to .8 of 255, by softpipe and SwiftShader by 0.",
]
