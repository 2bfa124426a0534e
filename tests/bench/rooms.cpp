#include "tests/bench/rooms.h"

#include <cstdint>
#include <optional>

#include "src/document/document.h"
#include "src/gl/target.h"
#include "src/platform/headless.h"
#include "tests/bench/handwritten/room.h"

namespace snell::bench {

RuntimeOptions for_values() {
    RuntimeOptions options;
    options.settle = [](Controls&, const Scene&) {};
    return options;
}

namespace {

std::uint64_t calls = 0;

template <typename... Arguments>
void silence(void (*&function)(Arguments...)) {
    function = [](Arguments...) { ++calls; };
}

template <typename... Functions>
void silence_all(Functions&... functions) {
    (silence(functions), ...);
}

// All that frames of the room call.
void silence_gl() {
    silence_all(epoxy_glEnable, epoxy_glDisable, epoxy_glColorMask, epoxy_glDepthMask, epoxy_glDepthFunc,
                epoxy_glClearColor, epoxy_glClear, epoxy_glViewport, epoxy_glBindFramebuffer, epoxy_glUseProgram,
                epoxy_glBlendFunc, epoxy_glCullFace, epoxy_glPolygonMode, epoxy_glLineWidth, epoxy_glPointSize,
                epoxy_glActiveTexture, epoxy_glBindTexture, epoxy_glBindSampler, epoxy_glBindVertexArray,
                epoxy_glVertexAttrib4f, epoxy_glUniform1fv, epoxy_glUniform1iv, epoxy_glUniformMatrix3fv,
                epoxy_glUniformMatrix4fv, epoxy_glDrawArrays, epoxy_glDrawElements);
}

}  // namespace

struct Rooms::Room {
    std::unique_ptr<HeadlessContext> context;
    gl::Target target;
    std::unique_ptr<Document> document;  // snell's
    View view;
    std::optional<by_hand::Room> by_hand;
};

Rooms::Rooms(const std::string& root) {
    for (const Who who : everybody) {
        auto room = std::make_unique<Room>();
        std::string error;
        room->context = HeadlessContext::make({}, error);
        if (!room->context) throw NoGraphics(error);
        if (who == Who::snell) {
            room->document = open_document(root + "/scenes/refraction-room/refraction-room.glib", gl::query_caps(),
                                           nullptr, nullptr, for_values());
            if (room->document->diagnostics.has_errors()) throw std::runtime_error("the scene has errors");
        } else {
            room->by_hand.emplace(root + "/scenes/environments/room", who == Who::by_hand);
        }
        rooms_[static_cast<std::size_t>(who)] = std::move(room);
    }
}

Rooms::~Rooms() {
    for (auto& room : rooms_) {
        if (!room) continue;
        room->context->make_current();
        room->target = {};
        room->document.reset();
    }
}

void Rooms::resize(int width, int height) {
    for (auto& room : rooms_) {
        room->context->make_current();
        room->target = gl::make_target(width, height, 1);
    }
}

void Rooms::draw(Who who) {
    Room& room = *rooms_[static_cast<std::size_t>(who)];
    const unsigned framebuffer = room.target.framebuffer.get();
    if (room.by_hand)
        room.by_hand->draw(framebuffer, room.target.width, room.target.height);
    else
        room.document->runtime->draw({0, room.view, room.document->controls},
                                     {framebuffer, room.target.width, room.target.height});
}

Times Rooms::frames(Who who, int count) {
    rooms_[static_cast<std::size_t>(who)]->context->make_current();
    draw(who);
    glFinish();
    const Times all = measure([&] {
        for (int i = 0; i < count; ++i) {
            draw(who);
            glFinish();
        }
    });
    return {all.cpu / count, all.wall / count};
}

std::vector<std::byte> Rooms::picture(Who who) {
    Room& room = *rooms_[static_cast<std::size_t>(who)];
    room.context->make_current();
    draw(who);
    return gl::read_rgba8(room.target.framebuffer.get(), room.target.width, room.target.height, 1);
}

Rooms::OwnCost Rooms::own_cost(Who who, int count) {
    rooms_[static_cast<std::size_t>(who)]->context->make_current();
    draw(who);
    glFinish();
    silence_gl();
    calls = 0;
    const Times all = measure([&] {
        for (int i = 0; i < count; ++i) draw(who);
    });
    return {static_cast<double>(calls) / count, {all.cpu / count, all.wall / count}};
}

}  // namespace snell::bench
