// The uniforms that the translator finds used, against the driver's lists of active uniforms: for every program of
// every scene, for the small programs of the dialects, and for each of their stages alone.
#include "src/gl/program.h"
#include "src/plan/texts.h"
#include "tests/harness/harness.h"
#include "tests/settled/writer.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

struct Tally {
    int programs = 0, used = 0, active = 0;  // of the simple uniforms
    std::string wrong, idle;
};

class Uses : public GlTest {
protected:
    void judge(const std::vector<glsl::StageInput>& stages, Sources& sources, Files& files, const Program* program,
               const std::string& where) {
        glsl::Options options;
        options.target = {caps.glsl, caps.es, caps.fp64};
        options.include = shader_includes(files);
        if (program)
            options.geometry_input = program->geometry_input, options.geometry_output = program->geometry_output;
        Diagnostics diagnostics;
        const glsl::Translation t = glsl::translate(stages, sources, options, diagnostics);
        std::string text;
        for (const glsl::StageOutput& stage : t.stages) text += stage.text;
        if (!t.ok || t.declared.empty() || !seen.insert(text).second) return;
        std::vector<gl::Shader> shaders;
        std::vector<const gl::Shader*> parts;
        constexpr GLenum kinds[] = {GL_VERTEX_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER,
                                    GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER};
        for (const glsl::StageOutput& stage : t.stages)
            shaders.push_back(gl::compile(kinds[static_cast<std::size_t>(stage.stage)], stage.text).shader);
        for (const gl::Shader& shader : shaders) parts.push_back(&shader);
        if (std::ranges::any_of(shaders, [](const gl::Shader& s) { return !s; })) return;
        const gl::Linked linked = gl::link(parts, {});
        if (linked.program) compare(t, linked.program, where);
    }

    void compare(const glsl::Translation& t, const gl::Program& program, const std::string& where) {
        std::set<std::string> active;
        for (const gl::Uniform& u : gl::active_uniforms(program.get(), caps.program_interface_query)) {
            const auto renamed = std::ranges::find(t.renamed, u.name, &glsl::RenamedUniform::shader_name);
            active.insert(renamed == t.renamed.end() ? u.name : renamed->name);
        }
        ++tally.programs;
        for (const glsl::DeclaredUniform& d : t.declared) {
            const bool found = std::ranges::any_of(active, [&](const std::string& name) {
                return name == d.name || name.starts_with(d.name + ".") || name.starts_with(d.name + "[");
            });
            if (found && !d.used) tally.wrong += where + ": " + d.name + " is active, but no code that runs names it\n";
            if (!d.simple || !d.used) continue;
            ++tally.used;
            tally.active += found ? 1 : 0;
            if (!found) tally.idle += where + ": " + d.name + " is inactive\n";
        }
    }

    void judge_scenes(const std::string& root) {
        for (const auto& entry : fs::recursive_directory_iterator(root)) {
            if (entry.path().extension() != ".glib") continue;
            const std::string path = entry.path().string();
            Files files(scene_folder(path));
            Sources sources;
            Diagnostics diagnostics;
            const auto plan = read_plan(path, files, sources, diagnostics);
            if (!plan) continue;
            for (const PlannedProgram& p : plan->programs)
                if (p.readable && !p.stages.empty())
                    judge(p.stages, sources, files, &plan->scene.programs[p.program], path);
        }
    }

    // Shaders of one name are a program, and each is one by itself.
    void judge_shaders(const std::string& folder) {
        constexpr std::pair<std::string_view, Stage> stages[] = {{".vert", Stage::vertex}, {".frag", Stage::fragment}};
        std::map<std::string, std::vector<std::pair<Stage, std::string>>> programs;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            for (const auto& [extension, stage] : stages)
                if (entry.path().extension() == extension) {
                    fs::path stem = entry.path();
                    programs[stem.replace_extension().string()].emplace_back(stage, entry.path().string());
                    programs[entry.path().string()].emplace_back(stage, entry.path().string());
                }
        for (const auto& [name, texts] : programs) {
            Files files(folder);
            Sources sources;
            std::vector<glsl::StageInput> inputs;
            for (const auto& [stage, path] : texts) {
                std::string error;
                inputs.push_back({stage, sources.add(path, *files.read(path, error)), {}});
            }
            judge(inputs, sources, files, nullptr, name);
        }
    }

    // Optimisers drop what changes nothing, such as terms that are multiplied by 0.
    void expect_right(int percent) {
        EXPECT_EQ(tally.wrong, "");
        std::printf("%d programs, %d of %d simple uniforms that are used are active\n", tally.programs, tally.active,
                    tally.used);
        EXPECT_GE(tally.active * 100, tally.used * percent) << tally.idle;
        if (std::getenv("SNELL_IDLE")) std::printf("%s", tally.idle.c_str());
        complaints.clear();  // of texts that are wrong on purpose
    }

    Tally tally;
    std::set<std::string> seen;
};

TEST_F(Uses, OfScenesAreTheDrivers) {
    for (const char* root : {"scenes", "tests/cases", "tests/odd"}) judge_scenes(root);
    expect_right(95);
}

TEST_F(Uses, OfSmallProgramsAreTheDrivers) {
    for (const char* root : {"tests/glsl", "scenes", "../shared/corpus"})
        if (fs::exists(root)) judge_shaders(root);
    expect_right(60);
}

// Full of what optimisers fold: zeros, ones, constant conditions, values that nothing reads.
std::string random_fragment(unsigned seed) {
    std::mt19937 random(seed);
    return "#version 330 compatibility\nuniform sampler2D uPicture;\nin vec2 vST;\n" + random_shader::declared() +
           std::string(random_shader::functions) + "void main() {\nfloat vK = vST.x;\nvec3 live = vec3(vST, -1.);\n" +
           std::string(random_shader::variables) + random_shader::Writer(random).statements() +
           "gl_FragColor = vec4(a, b, c, v.x + v.y);\n}\n";
}

TEST_F(Uses, OfRandomProgramsAreTheDrivers) {
    const char* campaign = std::getenv("SNELL_USES");  // how many programs
    const unsigned programs = campaign ? static_cast<unsigned>(std::atoi(campaign)) : 60;
    for (unsigned n = 0; n < programs; ++n) {
        Files files("");
        Sources sources;
        const std::string vertex =
                              "#version 330 compatibility\nout vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; "
                              "gl_Position = ftransform(); }\n",
                          text = random_fragment(n);
        const std::vector<glsl::StageInput> stages = {{Stage::vertex, sources.add("a.vert", vertex), {}},
                                                      {Stage::fragment, sources.add("a.frag", text), {}}};
        const std::size_t before = tally.wrong.size();
        judge(stages, sources, files, nullptr, std::to_string(n));
        if (tally.wrong.size() > before) tally.wrong += text;
    }
    expect_right(50);
}

}  // namespace
}  // namespace snell::test
