// An OpenGL context without a display: EGL's surfaceless platform, then its devices.
#pragma once

#include <memory>
#include <string>

namespace snell {

struct ContextRequest {
    int version = 0;  // 33, 41, 45 …; with es 30, 32; 0: the best available, from 4.5 down to 3.3, then ES
    bool es = false;
    bool compatibility = false;  // tests only: the oracle of the GLSL translation
    bool debug = false;
};

// Current on the thread that made it, until it is destroyed.
class HeadlessContext {
public:
    // Null, with the reason, where there is no graphics.
    static std::unique_ptr<HeadlessContext> make(const ContextRequest& request, std::string& error);
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    void make_current();
    const std::string& platform() const { return platform_; }

private:
    HeadlessContext() = default;
    static std::unique_ptr<HeadlessContext> make_one(const ContextRequest& request, std::string& error);
    void* display_ = nullptr;
    void* context_ = nullptr;
    std::string platform_;
};

}  // namespace snell
