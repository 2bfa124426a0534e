// Submissions of a class, made for a test, and what `snell grade` says of them.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace snell::test {

class GradeTest : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        if (!IsSkipped()) scene("reference");
    }
    // A whole submission in that folder.
    void scene(const std::string& where, const std::string& fragment = paint, const std::string& text = ball,
               const std::string& name = "ball.glib") const {
        folder.write(where + "/" + name, text);
        folder.write(where + "/ball.vert", vertex);
        folder.write(where + "/ball.frag", fragment);
    }
    // More files than any folder may hold: names of one, which are made in a sixth of the time.
    void write_too_many(const std::string& where) const {
        folder.write(where + "/0", "");
        for (int i = 1; i < 20'001; ++i)
            std::filesystem::create_hard_link(at(where + "/0"), at(where + "/" + std::to_string(i)));
    }
    Outcome grade(const std::string& arguments) const { return snell("grade " + arguments, "", folder.path()); }
    // What was judged before is asked of the program as it is in its file: copies of this process are another one.
    Outcome grade_by(const std::string& program) const {
        return run("cd '" + folder.path() + "' && " + program + " grade r.toml s -o out");
    }
    Outcome python(const std::string& program) const {
        folder.write("make.py", program);
        return run("cd '" + folder.path() + "' && python3 make.py");
    }
    nlohmann::json results(const std::string& report = "out") const {
        return nlohmann::json::parse(bytes_of(at(report + "/results.json")), nullptr, false);
    }
    // Of the submission with that name; null if there is none.
    nlohmann::json result(const std::string& name, const std::string& report = "out") const {
        const nlohmann::json all = results(report);
        if (!all.is_object()) return {};
        for (const auto& one : all["submissions"])
            if (one["name"] == name) return one;
        return {};
    }
    std::string page(const std::string& name, const std::string& report = "out") const {
        const nlohmann::json one = result(name, report);
        return one.is_null() ? "" : bytes_of(at(report + "/" + one["folder"].get<std::string>() + "/index.html"));
    }

    static std::string with(std::string text, const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
        return text;
    }

    static inline const std::string ball =
        "##OpenGL GLIB\nPerspective 60\nLookAt 0 0 3  0 0 0  0 1 0\nVertex ball.vert\nFragment ball.frag\n"
        "Program Ball uKd <0. .7 1.> uRed <0. .9 1.> uSide <-1. .3 1.>\nSphere 1\n";
    static inline const std::string vertex =
        "#version 330 compatibility\nout vec3 vN;\nvoid main() { vN = normalize(gl_NormalMatrix * gl_Normal); "
        "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n";
    static inline const std::string paint =
        "#version 330 compatibility\nuniform float uKd, uRed, uSide;\nin vec3 vN;\nvoid main() {\n"
        "  vec3 n = normalize(vN);\n  float d = max(dot(n, normalize(vec3(uSide, 0., 1.))), 0.);\n"
        "  gl_FragColor = vec4(vec3(uRed, .2, .1) * (.1 + uKd * d), 1.);\n}\n";
    static inline const std::string head =
        "title = \"Balls\"\nreference = \"reference/ball.glib\"\nsize = \"64x48\"\ntimeout = 10\n";
};

}  // namespace snell::test
