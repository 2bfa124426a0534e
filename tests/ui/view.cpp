// The view panel, the mouse and the keys that hold the view, judged by what becomes of it.
#include <cmath>
#include <fstream>
#include <sstream>

#include "src/plan/plan.h"
#include "src/plan/view.h"
#include "src/ui/kit/kit.h"
#include "src/ui/shell.h"
#include "tests/scratch.h"
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

class ViewPanel : public UiTest {
protected:
    ViewPanel() {
        scene_.cameras[0].look_at = {{Vec3{0, 0, 4}, Vec3{0, 0, 0}, Vec3{0, 1, 0}}};
        scene_.matrices.push_back({2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 0, 0, 1});
        Draw draw;
        draw.shape = Sphere{};
        draw.matrix = draw.camera = 0;
        scene_.draws.push_back(draw);
        Pass pass;
        pass.items.push_back({Item::Kind::draw, 0});
        scene_.passes.push_back(pass);
        memory_.open.insert("View");
        memory_.tab = Tab::tools;
    }
    void drag(double dx, double dy, MouseButton which = MouseButton::left, Modifiers modifiers = {}) {
        frame({move(300, 300)});
        frame({button(true, which, modifiers), move(300 + dx, 300 + dy)});
        frame({button(false, which)});
        // As a keyboard does: else the modifiers stay.
        frame({key(Key::other, false)});
    }
    // Where the object's origin is on the screen, in points.
    glm::dvec2 object_at() {
        const Camera& camera = scene_.cameras[0];
        const glm::dmat4 from_world = view_matrix(camera), seen = view_.eye.matrix() * from_world;
        glm::dmat4 model(1);
        model[3] = {1, 0, 0, 1};
        const auto object = view_.objects.find(0);
        if (object != view_.objects.end()) model = placed_by(object->second, from_world, model);
        const glm::dvec3 pivot(seen[3]), eye(seen * model[3]);
        const glm::dvec4 turned = view_.scene.matrix() * glm::dvec4(eye - pivot, 1);
        const double shorter = std::min(memory_.scene.width, memory_.scene.height);
        const Lens lens = lens_of(camera, view_.projection, seen);
        const glm::dvec4 clip =
            projection_matrix(lens.camera, 1) * lens.shift * glm::dvec4(glm::dvec3(turned) + pivot, 1);
        return {clip.x / clip.w * shorter / 2, -clip.y / clip.w * shorter / 2};
    }
    // Only the translation matters here: about an origin of its own all else leaves it.
    static glm::dmat4 placed_by(const Transformation& t, const glm::dmat4& view, glm::dmat4 model) {
        model[3] += glm::inverse(view) * glm::dvec4(t.x, t.y, t.z, 0);
        return model;
    }
};

TEST_F(ViewPanel, NumbersGoToWhatIsHeld) {
    frame();
    const auto enter = [&](const std::string& field, const std::string& text) {
        click(place("view." + field), MouseButton::left, .5, {.ctrl = true});
        type(text);
    };
    enter("rotate_x", "30");
    enter("z", "-1.5");
    click(place("hold.Eye"));
    enter("rotate_z", "12");
    enter("scale", "0");
    click(place("hold.Texture"));
    enter("x", ".25");
    EXPECT_EQ(view_.scene.rotate_x, 30);
    EXPECT_EQ(view_.scene.z, -1.5);
    EXPECT_EQ(view_.eye.rotate_z, 12);
    EXPECT_EQ(view_.eye.scale, 1e-3) << "never nothing";
    EXPECT_EQ(view_.texture.x, .25);
    click(place("hold.Object"));
    EXPECT_EQ(memory_.hold.held, Held::texture) << "nothing is picked";
    click(place("reset held"));
    EXPECT_EQ(view_.texture, Transformation{});
    EXPECT_EQ(view_.scene.rotate_x, 30);
    view_.axes = true;
    choose("view", "reset view");
    View fresh;
    fresh.axes = true;
    EXPECT_EQ(view_, fresh) << "all but the axes";
}

TEST_F(ViewPanel, NumbersSayWhatTheyAre) {
    for (const auto& [name, unit] :
         {std::pair("rotate_x", "degrees"), {"rotate_y", "degrees"}, {"z", "units"}, {"scale", "as in the scene"}}) {
        const Rect at = place(std::string("view.") + name);
        frame({move(at.x + at.width / 2, at.y + at.height / 2)});
        frame({}, 1);
        frame({}, 1);
        EXPECT_TRUE(kit().tip.shown && kit().tip.text.find(unit) != std::string::npos) << name << kit().tip.text;
    }
}

TEST_F(ViewPanel, ARightClickOnANumberGivesItsFirstValueBack) {
    view_.scene.rotate_y = 40;
    click(place("view.rotate_y"), MouseButton::right);
    EXPECT_EQ(view_.scene.rotate_y, 0);
}

TEST_F(ViewPanel, ProjectionAndBackgroundAreTheScenesUntilChosen) {
    choose("view", "perspective");
    EXPECT_EQ(view_.projection, Projection::ortho);
    choose("view", "perspective");
    EXPECT_EQ(view_.projection, Projection::scene) << "the scene's own is no choice";
    scene_.cameras[0].perspective = false;
    choose("view", "perspective");
    EXPECT_EQ(view_.projection, Projection::perspective);
    frame();
    EXPECT_FALSE(view_.background) << "shown and not chosen";
    click(place("background"), MouseButton::left, .75);
    ASSERT_TRUE(view_.background);
    EXPECT_NEAR(*view_.background, .75, .03);
    click(place("background"), MouseButton::right);
    EXPECT_FALSE(view_.background);
}

TEST_F(ViewPanel, GesturesOfOneFingerDoWhatThreeButtonsDo) {
    frame();
    drag(0, -30, MouseButton::middle);
    const double scaled = view_.scene.scale;
    EXPECT_GT(scaled, 1);
    reset_view(view_);
    drag(0, -30, MouseButton::left, {.ctrl = true});
    EXPECT_NEAR(view_.scene.scale, scaled, 1e-12);
    reset_view(view_);
    drag(20, 0, MouseButton::right);
    const double moved = view_.scene.x;
    EXPECT_GT(moved, 0);
    reset_view(view_);
    drag(20, 0, MouseButton::left, {.shift = true});
    EXPECT_NEAR(view_.scene.x, moved, 1e-12);
    EXPECT_EQ(view_.scene.rotate_y, 0);
    reset_view(view_);
    drag(0, 20, MouseButton::left, {.shift = true, .ctrl = true});
    EXPECT_NEAR(view_.scene.z, moved, 1e-12) << "down is towards you, as far as it is to the right";
    EXPECT_EQ(view_.scene.scale, 1);
    EXPECT_EQ(view_.scene.y, 0);
}

TEST_F(ViewPanel, ADragMovesWhatIsInFrontWithTheMouseHoweverTheSceneIsTurned) {
    frame();
    for (const Vec3 from : {Vec3{0, 0, 4}, {0, 3, 3}, {2, -3, 1}})
        for (const double tilted : {0., 130., -170.}) {
            Camera& camera = scene_.cameras[0];
            camera.look_at = {{from, Vec3{0, 0, 0}, Vec3{0, 1, 0}}};
            reset_view(view_);
            view_.scene.rotate_y = 90;
            view_.scene.rotate_x = tilted;
            const glm::dmat4 view = view_matrix(camera), before = about_origin(view_.scene, camera, view);
            // The point of the scene that is nearest to the eye now.
            const glm::dvec4 front = glm::inverse(before) * glm::dvec4(glm::dvec3(view[3]) + glm::dvec3(0, 0, 1), 1);
            const auto seen = [&] {
                return glm::dvec3(about_origin(view_.scene, camera, view) * front) - glm::dvec3(view[3]);
            };
            drag(8, 0);
            EXPECT_GT(seen().x, 0) << tilted;
            drag(-8, 0);
            EXPECT_NEAR(seen().x, 0, 1e-12);
            drag(0, 8);
            EXPECT_LT(seen().y, 0);
            EXPECT_NEAR(seen().x, 0, 1e-12) << "it does not roll";
        }
}

TEST_F(ViewPanel, ADragThatEndsWhereItBeganChangesNothing) {
    for (const Vec3 from : {Vec3{0, 1, 5}, {0, 5, 0}, {0, -5, 0}}) {
        scene_.cameras[0].look_at = {{from, Vec3{0, 0, 0}, Vec3{0, 1, 0}}};
        reset_view(view_);
        frame({move(300, 200)});
        frame({button(true)});
        frame({move(300, 560)});
        EXPECT_NE(view_.scene.rotate_x, 0);
        frame({move(400, 560)});
        EXPECT_EQ(view_.scene.rotate_y, 50);
        frame({move(400, 200)});
        frame({move(300, 200)});
        frame({button(false)});
        EXPECT_EQ(view_.scene, Transformation{});
    }
}

TEST_F(ViewPanel, AnObjectStaysUnderTheMouseThatMovesIt) {
    frame();
    hold_object(memory_.hold, 0);
    view_.scene.rotate_y = 25;
    view_.scene.rotate_x = -10;
    view_.scene.scale = 1.4;
    view_.eye.rotate_y = 8;
    for (const Projection projection : {Projection::scene, Projection::ortho}) {
        view_.projection = projection;
        view_.objects.clear();
        const glm::dvec2 before = object_at();
        drag(37, -21, MouseButton::right);
        const glm::dvec2 after = object_at();
        EXPECT_NEAR(after.x - before.x, 37, .5);
        EXPECT_NEAR(after.y - before.y, -21, .5);
    }
    EXPECT_EQ(view_.scene.x, 0) << "the scene stays";
    drag(30, 0);
    EXPECT_GT(view_.objects[0].rotate_y, 0);
    EXPECT_EQ(view_.scene.rotate_y, 25);
    click(place("reset held"));
    EXPECT_TRUE(view_.objects.empty()) << "what is as it was is not in the view";
}

TEST_F(ViewPanel, ATexturesPictureFollowsTheMouse) {
    memory_.hold.held = Held::texture;
    frame();
    drag(20, 0, MouseButton::right);
    EXPECT_LT(view_.texture.x, 0) << "coordinates run against the picture";
    drag(20, 0);
    EXPECT_GT(view_.texture.rotate_z, 0) << "in its plane";
    EXPECT_EQ(view_.texture.rotate_y, 0);
    frame({move(300, 300), wheel(1)});
    EXPECT_LT(view_.texture.scale, 1);
}

TEST_F(ViewPanel, AClickAsksForAnObjectOnlyWhilePicking) {
    frame({move(300, 200)});
    frame({button(true)});
    frame({button(false)});
    EXPECT_FALSE(requests_.pick);
    frame({key(Key::p, true)});
    frame({key(Key::p, false)});
    EXPECT_TRUE(memory_.hold.picking);
    frame({button(true)});
    EXPECT_FALSE(requests_.pick) << "a drag may follow";
    frame({move(301, 201)});
    frame({button(false)});
    ASSERT_TRUE(requests_.pick);
    EXPECT_EQ(requests_.pick->x, 301 - memory_.scene.x);
    EXPECT_EQ(requests_.pick->y, 201 - memory_.scene.y);
    EXPECT_EQ(view_.scene, Transformation{}) << "a click turns nothing";
    frame({button(true), move(340, 240), button(false)});
    EXPECT_FALSE(requests_.pick) << "that was a drag";
    EXPECT_NE(view_.scene, Transformation{});
    const Rect panel = place("reload");
    frame({move(panel.x + 3, panel.y + 3), button(true), button(false)});
    EXPECT_FALSE(requests_.pick) << "nor is the panel a place to pick";
}

TEST_F(ViewPanel, EscapeLetsGoAndThenPicksNoMore) {
    memory_.hold.picking = true;
    hold_object(memory_.hold, 0);
    facts_.object = "Sphere, line 3";
    EXPECT_TRUE(has("object"));
    const auto escape = [&] {
        frame({key(Key::escape, true)});
        frame({key(Key::escape, false)});
    };
    escape();
    EXPECT_EQ(memory_.hold.object, none);
    EXPECT_EQ(memory_.hold.held, Held::scene);
    EXPECT_TRUE(memory_.hold.picking);
    escape();
    EXPECT_FALSE(memory_.hold.picking);
}

TEST_F(ViewPanel, FitsAtEverySizeOfLetters) {
    hold_object(memory_.hold, 0);
    facts_.object = "ObjPatch a_file_with_a_long_name_that_no_panel_is_wide_enough_for.obj, line 12345";
    for (const float scale : {1.F, 2.F})
        for (const float width : {640.F, 1024.F, 1280.F}) {
            screen_ = {width, 768, 1, scale};
            for (const char* name :
                 {"background", "hold.Scene", "hold.Texture", "object", "view.rotate_z", "view.z", "reset held"}) {
                const Rect at = place(name);
                EXPECT_LE(at.x + at.width, width) << name << ' ' << scale;
                EXPECT_GE(at.x, memory_.scene.width) << name;
            }
        }
}

TEST_F(ViewPanel, F1ListsWhatThePageLists) {
    frame({key(Key::f1, true)});
    frame({key(Key::f1, false)});
    EXPECT_TRUE(has("close keys"));
    frame({key(Key::escape, true)});
    frame({key(Key::escape, false)});
    EXPECT_FALSE(has("close keys"));
    const std::string page = bytes_of("docs/window.md");
    for (const KeyRow& row : key_rows())
        EXPECT_NE(page.find("| " + std::string(row.keys) + " | " + row.what + " |"), std::string::npos)
            << "docs/window.md lacks | " << row.keys << " | " << row.what << " |";
}

}  // namespace
}  // namespace snell::ui
