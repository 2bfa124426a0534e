// An OpenGL context without a display, from EGL's surfaceless platform or else from its devices.
#pragma once

#include <memory>
#include <string>

namespace snell {

struct ContextRequest {
    // 33, 41, 45 …; with `es` 30 or 32; 0: the highest available from 4.5 down to 3.3, then ES.
    int version = 0;
    bool es = false;
    bool compatibility = false;  // for tests only, as the oracle of the GLSL translation
    bool debug = false;
};

// The context is current on the thread that made it, until it is destroyed.
class HeadlessContext {
public:
    // Returns null and sets `error` if no such context can be made.
    static std::unique_ptr<HeadlessContext> make(const ContextRequest& request, std::string& error);
    // The part of EGL that make() needs and that is not installed, for people, with Debian's name for it; "": all is
    // there.
    static std::string missing_package();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    bool make_current();
    // It lives until the process ends, not only as long as this object.
    void keep() { kept_ = true; }
    const std::string& platform() const { return platform_; }

private:
    HeadlessContext() = default;
    static std::unique_ptr<HeadlessContext> make_one(const ContextRequest& request, std::string& error);
    void* display_ = nullptr;
    void* context_ = nullptr;
    bool kept_ = false;
    std::string platform_;
};

}  // namespace snell
