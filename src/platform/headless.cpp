#include "src/platform/headless.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <array>
#include <climits>
#include <filesystem>
#include <vector>

namespace snell {

namespace {

struct Attempt {
    EGLDisplay display = EGL_NO_DISPLAY;
    std::string platform;
};

std::vector<Attempt> displays() {
    std::vector<Attempt> attempts;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        attempts.push_back(
            {eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), "surfaceless"});
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        eglQueryDevicesEXT(devices.size(), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i)
            attempts.push_back(
                {eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(i)], nullptr),
                 "device"});
    }
    return attempts;
}

// What a context should have if the driver offers it. Mesa's softpipe makes no debug contexts.
struct Wishes {
    bool notify = false;  // reports resets by the driver; otherwise it would silently continue with undefined pictures
    bool debug = false;
};

EGLContext make_context(EGLDisplay display, EGLConfig config, const ContextRequest& request, int version,
                        const Wishes& wishes) {
    const EGLint profile =
        request.compatibility ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT;
    std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION, version / 10, EGL_CONTEXT_MINOR_VERSION, version % 10};
    if (!request.es) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK, profile});
    if (wishes.debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
    if (wishes.notify)
        attributes.insert(attributes.end(),
                          {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
    attributes.push_back(EGL_NONE);
    return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

EGLContext best_context(EGLDisplay display, const ContextRequest& request) {
    if (!eglBindAPI(request.es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (!epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) {
        // EGL's default surface type is a window, which none of these configurations supports.
        const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                           request.es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
        EGLint count = 0;
        if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;
    }
    const std::vector<int> desktop{45, 41, 33};
    const std::vector<int> embedded{32, 30};
    const std::vector<int> exact{request.version};
    const bool can_notify = epoxy_egl_version(display) >= 15;
    for (int version : request.version ? exact : request.es ? embedded : desktop)
        for (const Wishes& wishes : {Wishes{true, true}, {false, true}, {true, false}, {false, false}}) {
            if ((wishes.notify && !can_notify) || (wishes.debug && !request.debug)) continue;
            EGLContext context = make_context(display, config, request, version, wishes);
            if (context != EGL_NO_CONTEXT) return context;
        }
    return EGL_NO_CONTEXT;
}

}  // namespace

std::unique_ptr<HeadlessContext> HeadlessContext::make(const ContextRequest& request, std::string& error) {
    auto made = make_one(request, error);
    const bool any = request.version == 0 && !request.es && !request.compatibility;
    if (made || !any) return made;
    ContextRequest embedded = request;
    embedded.es = true;
    std::string second;
    made = make_one(embedded, second);
    if (!made && second.find("context") != std::string::npos) error += ", and no OpenGL ES 3 context either";
    return made;
}

std::unique_ptr<HeadlessContext> HeadlessContext::make_one(const ContextRequest& request, std::string& error) {
    if (!dlopen("libEGL.so.1", RTLD_LAZY)) {  // without it, libepoxy ends the process
        error = "EGL cannot be loaded";
        return nullptr;
    }
    error = "EGL supports neither the surfaceless nor the device platform";
    for (const Attempt& attempt : displays()) {
        EGLint major = 0, minor = 0;
        if (attempt.display == EGL_NO_DISPLAY || !eglInitialize(attempt.display, &major, &minor)) {
            error = "EGL's " + attempt.platform + " platform cannot be initialised";
            continue;
        }
        EGLContext context = best_context(attempt.display, request);
        if (context != EGL_NO_CONTEXT) {
            std::unique_ptr<HeadlessContext> result(new HeadlessContext);
            result->display_ = attempt.display;
            result->context_ = context;
            result->platform_ = attempt.platform;
            if (result->make_current()) return result;
        }
        error =
            request.es ? "EGL cannot create an OpenGL ES 3 context" : "EGL cannot create an OpenGL 3.3 core context";
        eglTerminate(attempt.display);
    }
    return nullptr;
}

std::string HeadlessContext::missing_package() {
    if (!dlopen("libEGL.so.1", RTLD_LAZY)) return "EGL (Debian: libegl1)";
    void* mesa = dlopen("libEGL_mesa.so.0", RTLD_LAZY);
    if (!mesa) return "Mesa's EGL (Debian: libegl-mesa0)";
    std::array<char, PATH_MAX> folder{};
    std::error_code none;
    if (dlinfo(mesa, RTLD_DI_ORIGIN, folder.data()) != 0) return {};
    return std::filesystem::exists(std::filesystem::path(folder.data()) / "dri/swrast_dri.so", none)
               ? ""
               : "Mesa's drivers (Debian: libgl1-mesa-dri)";
}

bool HeadlessContext::make_current() {
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
}

HeadlessContext::~HeadlessContext() {
    if (kept_) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

}  // namespace snell
