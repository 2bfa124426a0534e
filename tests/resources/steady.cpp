// A drag of a slider in the steady state: one uniform, and nothing from the heap, neither for the panels nor for the
// picture.
#include <imgui.h>
#include <new>

#include "src/app/window/measure/inspector_view.h"
#include "src/gl/present.h"
#include "src/ui/kit/gui.h"
#include "src/ui/shell.h"
#include "tests/harness/harness.h"

namespace {

// Of this thread, while somebody counts: drivers have threads of their own.
thread_local bool counting = false;
thread_local std::size_t allocations = 0;

void* allocated(std::size_t size) {
    allocations += counting;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocated(size); }
void* operator new[](std::size_t size) { return allocated(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    allocations += counting;
    return std::malloc(size ? size : 1);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace snell::test {
namespace {

class Steady : public GlTest {
protected:
    static constexpr int width = 1280, height = 800;

    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        ImGui::SetAllocatorFunctions([](std::size_t size, void*) { return allocated(size); },
                                     [](void* memory, void*) { std::free(memory); });
        gui_.emplace(nullptr);
        folder.write("plain.vert", plain_vertex);
        folder.write("paint.frag",
                     "#version 330 compatibility\nuniform float uBrightnessOfTheLight, uOtherNumber[3];\n"
                     "uniform vec4 uTheColorOfTheGlass;\nuniform bool uWhetherItIsLit;\nuniform int uSteps;\n"
                     "in vec2 vST;\nvoid main() {\n"
                     "    gl_FragColor = uTheColorOfTheGlass * uBrightnessOfTheLight + vec4(vST, uOtherNumber[0] + "
                     "uOtherNumber[2], float(uSteps)) * (uWhetherItIsLit ? .5 : .1);\n}\n");
        folder.write("texture.frag", texture_fragment);
    }
    void TearDown() override {
        textures_.reset();
        gui_.reset();
        ImGui::SetAllocatorFunctions([](std::size_t size, void*) { return std::malloc(size); },
                                     [](void* memory, void*) { std::free(memory); });
        GlTest::TearDown();
    }

    // As the window's: the panels, then the picture.
    void frame(Document& document, std::span<const Event> events) {
        gui_->input({width, height, 1, 1}, .016, events);
        gui_->begin();
        ui::Facts facts;
        facts.file = "a-scene-with-quite-a-long-name.glib";
        facts.scene = &document.scene();
        facts.linked = linked_;
        facts.frame_ms = 12.5;
        facts.samples = 4;
        facts.renderer = caps.renderer;
        facts.animated = document.runtime->animated();
        facts.timed = document.runtime->timed();
        facts.changed = true;
        facts.accuracy = accuracy_;
        if (textures_) {
            facts.textures = textures_->facts();
            document.controls.find(0, "uBrightnessOfTheLight")->value[0] = .01 * static_cast<double>(pictures_ % 100);
        }
        ui::Layout& layout = listening_ ? listener_ : deaf_;
        ui::shell(facts, document.controls, view_, memory_, gui_->fonts(), layout);
        gui_->end();
        Frame drawn{.time = 0, .view = view_, .controls = document.controls, .paced = true};
        document.runtime->draw(drawn, {target_.framebuffer.get(), width, height});
        if (textures_) textures_->follow(document, 1, ++pictures_, memory_, 1);
    }
    void frame(Document& document, const Event& event) { frame(document, std::span(&event, 1)); }

    // What a drag of the slider over so many frames allocates, after as long a one to warm up.
    std::size_t drag(Document& document, const std::string& slider, int frames = 40) {
        target_ = gl::make_target(width, height, 1);
        for (const auto& uniforms : document.runtime->active_uniforms()) linked_.push_back(!uniforms.empty());
        listening_ = true;
        for (int i = 0; i < 4; ++i) frame(document, std::span<const Event>{});
        ui::Rect bar;
        for (const ui::Placed& placed : listener_.items())
            if (placed.name == slider) bar = placed.rect;
        EXPECT_GT(bar.width, 50) << slider;
        listening_ = false;
        const auto moved = [&](double part) {
            return Event{.kind = Event::Kind::move, .x = bar.x + bar.width * part, .y = bar.y + bar.height / 2};
        };
        frame(document, moved(.2));
        frame(document, Event{.kind = Event::Kind::button, .button = MouseButton::left, .down = true});
        for (int i = 0; i < frames; ++i) frame(document, moved(.2 + .6 * i / frames));
        before_ = document.runtime->counters();
        allocations = 0;
        counting = true;
        for (int i = 0; i < frames; ++i) frame(document, moved(.8 - .6 * i / frames));
        counting = false;
        after_ = document.runtime->counters();
        return allocations;
    }

    std::optional<ui::Gui> gui_;
    gl::Target target_;
    std::vector<char> linked_;
    View view_;
    ui::Memory memory_;
    ui::Layout listener_{true}, deaf_{false};
    bool listening_ = false;
    Counters before_, after_;
    std::optional<TextureView> textures_;
    std::uint64_t pictures_ = 0;
    const ui::AccuracyFacts* accuracy_ = nullptr;
};

constexpr std::string_view program =
    "Vertex plain.vert\nFragment paint.frag\nProgram PaintOfTheWholeRoom uBrightnessOfTheLight <0. .25 1.> "
    "uTheColorOfTheGlass {.2 .4 .6 1.} uWhetherItIsLit <true> uSteps <1 2 9> uOtherNumber 0.1 0.2 0.3\n";

TEST_F(Steady, ADragAllocatesNothing) {
    auto document = open("Ortho -1 1 -1 1\n" + std::string(program) + "QuadXY 0. 1.\n");
    expect_clean(*document);
    memory_.panel = true;
    view_.axes = true;
    EXPECT_EQ(drag(*document, "PaintOfTheWholeRoom.uBrightnessOfTheLight"), 0U);
    EXPECT_EQ(after_.frames - before_.frames, 40U);
    EXPECT_LE(after_.uniform_uploads - before_.uniform_uploads, 40U);
    EXPECT_GE(after_.uniform_uploads - before_.uniform_uploads, 30U) << "the slider was dragged";
    EXPECT_EQ(after_.bytes_uploaded, before_.bytes_uploaded);
    EXPECT_EQ(after_.programs_compiled, before_.programs_compiled);
}

TEST_F(Steady, SoItIsWithPassesCubesAndManyDraws) {
    std::string many;
    for (int i = 0; i < 20; ++i) many += "PushMatrix\nTranslate " + std::to_string(i) + " 0. 0.\nCube .5\nPopMatrix\n";
    auto document = open("Texture2D 5 32 32\nCubeMap 6 16\nPerspective 60\nLookAt 0 0 5  0 0 0  0 1 0\n" +
                         std::string(program) + "RenderToTexture 5\nQuadXY 0. 1.\nRenderToTexture\n" + many +
                         "Fragment texture.frag\nProgram Shown uUnit 5\nQuadXY 0. 1.\n");
    expect_clean(*document);
    EXPECT_EQ(drag(*document, "PaintOfTheWholeRoom.uBrightnessOfTheLight"), 0U);
    EXPECT_GE(after_.uniform_uploads - before_.uniform_uploads, 30U);
}

TEST_F(Steady, ValuesOverThePictureAllocateNothingEither) {
    auto document = open("Ortho -1 1 -1 1\n" + std::string(program) + "QuadXY 0. 1.\n");
    expect_clean(*document);
    memory_.labels = true;
    EXPECT_EQ(drag(*document, "PaintOfTheWholeRoom.uBrightnessOfTheLight"), 0U);
}

TEST_F(Steady, NorDoesTheSectionAccuracy) {
    auto document = open("Ladder KIND plain <exact>\nOrtho -1 1 -1 1\n" + std::string(program) + "QuadXY 0. 1.\n");
    ASSERT_EQ(document->scene().ladders.size(), 1U);
    const ui::AccuracyFacts facts{.samples = 16, .wanted = 16, .clock = "GPU time", .error = .0123};
    accuracy_ = &facts;
    memory_.tab = ui::Tab::tools;
    memory_.accuracy.open = true;
    EXPECT_EQ(drag(*document, "accuracy.plot"), 0U);
}

TEST_F(Steady, NorDoesATextureThatIsLookedAt) {
    auto document = open("Texture2D 5 32 32\nOrtho -1 1 -1 1\n" + std::string(program) +
                         "RenderToTexture 5\nQuadXY 0. 1.\nRenderToTexture\nFragment texture.frag\n"
                         "Program Shown uUnit 5\nQuadXY 0. 1.\n");
    expect_clean(*document);
    textures_.emplace(caps.es);
    memory_.tab = ui::Tab::tools;
    memory_.open.emplace("Textures");
    EXPECT_EQ(drag(*document, "textures"), 0U);
    ASSERT_NE(textures_->facts(), nullptr);
    EXPECT_GE(textures_->facts()->drawn, 80U) << "it changes with the value";
    EXPECT_EQ(textures_->facts()->read, 0U);
    // Closed, it draws and holds nothing.
    memory_.open.clear();
    for (int i = 0; i < 3; ++i) frame(*document, std::span<const Event>{});
    EXPECT_EQ(textures_->facts(), nullptr);
}

}  // namespace
}  // namespace snell::test
