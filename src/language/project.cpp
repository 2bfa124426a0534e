#include "src/language/project.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/read/lexer.h"
#include "src/lint/lint.h"
#include "src/plan/locate.h"
#include "src/plan/texts.h"
#include "src/plan/values/controls.h"
#include "src/plan/values/declared.h"

namespace snell::language {

namespace {

std::string normal(std::string_view path) { return std::filesystem::path(path).lexically_normal().string(); }

// What each program is translated with: in the order of the programs, for an OpenGL that has everything.
std::vector<glsl::Options> options_of(const Plan& plan, const glsl::IncludeReader& include) {
    const Scene& scene = plan.scene;
    std::vector<glsl::Options> all(scene.programs.size());
    for (Index i = 0; i < all.size(); ++i) {
        const Program& program = scene.programs[i];
        all[i].target = {450, false, true};
        all[i].geometry_input = program.geometry_input;
        all[i].geometry_output = program.geometry_output;
        all[i].include = include;
        all[i].defines = ladder_defines(std::span(scene.ladders).first(program.ladders), plan.rungs);
        all[i].color_outputs = 0;
    }
    // As for the first draw of each program.
    for (const Pass& pass : scene.passes)
        for (const Item& item : pass.items) {
            if (item.kind != Item::Kind::draw) continue;
            const Draw& draw = scene.draws[item.index];
            if (draw.program == none || all[draw.program].color_outputs > 0) continue;
            all[draw.program].flat_color = scene.rasters[draw.raster].flat;
            all[draw.program].color_outputs =
                pass.kind == Pass::Kind::textures ? std::clamp(static_cast<int>(pass.textures.size()), 1, 8) : 1;
        }
    for (glsl::Options& options : all) options.color_outputs = std::max(options.color_outputs, 1);
    return all;
}

glsl::Translation translate_program(Project& project, Index program, const glsl::Options& options) {
    const PlannedProgram& planned = project.plan.programs[program];
    if (!planned.readable || planned.stages.empty()) return {};
    return glsl::translate(planned.stages, project.sources, options, project.diagnostics);
}

// A member of a structure or of an array, whose type is not known here.
bool is_part(const UniformValue& value, const std::vector<glsl::DeclaredUniform>& declared) {
    return ranges::any_of(declared,
                          [&](const glsl::DeclaredUniform& d) { return d.name == base_name(value.name) && !d.simple; });
}

// Reports values of Program lines that do not fit the uniforms that the shaders declare.
void report_values(Project& project) {
    if (project.alone) return;
    Scene scene;  // what make_controls reads of it
    scene.programs = project.plan.scene.programs;
    std::vector<std::vector<ActiveUniform>> uniforms(scene.programs.size());
    for (Index i = 0; i < scene.programs.size(); ++i) {
        Program& program = scene.programs[i];
        const glsl::Translation& translation = project.translations[i];
        if (!translation.ok) {
            program.uniforms.clear();  // the shaders' errors come first
            continue;
        }
        for (const glsl::DeclaredUniform& declared : translation.declared)
            uniforms[i].push_back(described(program, declared));
        std::erase_if(program.uniforms, [&](const UniformValue& v) { return is_part(v, translation.declared); });
    }
    make_controls(scene, uniforms, project.diagnostics);
}

class Reader {
public:
    Reader(Project& project, const Access& access) : project_(project) {
        project_.files = std::make_unique<Files>(scene_folder(project_.path), access);
        project_.diagnostics = Diagnostics(access.limits);
    }

    void read_scene() {
        if (auto plan = read_plan(project_.path, *project_.files, project_.sources, project_.diagnostics)) {
            project_.plan = std::move(*plan);  // its text is the first source
        } else {
            project_.sources.add(project_.path, "");
            project_.plan.scene.passes.resize(1);
        }
    }

    // A program of one stage, drawn by nothing.
    void read_alone(std::string text, std::optional<Stage> stage) {
        project_.alone = true;
        project_.sources.add("", "");  // of the scene
        const FileId file = project_.sources.add(project_.path, std::move(text));
        const Span whole{file, 0, 0};
        Plan& plan = project_.plan;
        plan.scene.passes.resize(1);
        if (!stage) {
            project_.shaders.push_back({project_.path, file, {}, true});
            return;
        }
        Program program;
        program.name = std::filesystem::path(project_.path).filename().string();
        program.stages[static_cast<std::size_t>(*stage)] = FileName{program.name, whole};
        program.span = whole;
        plan.scene.programs.push_back(std::move(program));
        plan.programs.push_back({0, {{*stage, file, whole}}, true});
    }

    void list_shaders() {
        for (FileId file = 0; file < project_.sources.size(); ++file) know(file);
        for (Index i = 0; i < project_.plan.programs.size(); ++i)
            for (const glsl::StageInput& stage : project_.plan.programs[i].stages) {
                Shader& shader = shader_of(stage.file);
                shader.included = false;
                add(shader.uses, {i, stage.stage});
            }
        // The list grows: what is included includes more.
        for (std::size_t i = 0; i < listed_.size(); ++i) list_included(listed_[i]);
        for (std::size_t changed = 1; changed > 0;) changed = pass_uses_on();
    }

    void translate() {
        const std::vector<glsl::Options> options = options_of(project_.plan, shader_includes(*project_.files));
        for (Index program = 0; program < project_.plan.programs.size(); ++program)
            project_.translations.push_back(translate_program(project_, program, options[program]));
        report_values(project_);
        project_.diagnostics.append(lint::check(project_.plan, project_.sources, shader_includes(*project_.files)));
    }

private:
    static bool add(std::vector<ShaderUse>& uses, ShaderUse use) {
        if (ranges::find(uses, use) != uses.end()) return false;
        uses.push_back(use);
        return true;
    }

    // Remembers which file the source is. Texts of snell's library, and those that were never written, have no file.
    FileId know(FileId file, bool on_disk = true) {
        std::string name(project_.sources.name(file));
        const auto [known, added] = project_.firsts.try_emplace(name, file);
        struct stat status {};
        if (added && on_disk && stat(name.c_str(), &status) == 0)
            known->second = on_disk_.try_emplace({status.st_dev, status.st_ino}, file).first->second;
        return known->second;
    }

    // The shader whose text the source is, in the list.
    Shader& shader_of(FileId source) {
        if (names_.emplace(project_.sources.name(source)).second) listed_.push_back(source);
        const FileId file = project_.first(source);
        const auto found = ranges::find_if(project_.shaders, [&](const Shader& s) { return s.file == file; });
        if (found != project_.shaders.end()) return *found;
        return project_.shaders.emplace_back(Shader{std::string(project_.sources.name(file)), file, {}, true});
    }

    // Under another name, the same file may be next to other files.
    void list_included(FileId file) {
        const glsl::IncludeReader read = shader_includes(*project_.files);
        const std::string name(project_.sources.name(file));
        const auto place = [&](const Shader& shader) {
            return static_cast<std::size_t>(&shader - project_.shaders.data());
        };
        const std::size_t from = place(shader_of(file));
        for (const glsl::IncludeName& include : glsl::included_names(project_.sources.text(file))) {
            auto text = read(name, include.name, include.angle);
            if (!text || text->name.empty()) continue;
            const auto known = project_.firsts.find(text->name);
            Shader& shader = shader_of(known != project_.firsts.end()
                                           ? known->second
                                           : know(project_.sources.add(text->name, text->text), !include.angle));
            if (include.angle) shader.path.clear();
            inclusions_.emplace_back(from, place(shader));
        }
    }

    // An included text is compiled where the text that includes it is. Returns how many uses were new.
    std::size_t pass_uses_on() {
        std::size_t added = 0;
        for (const auto& [from, to] : inclusions_) {
            if (from == to) continue;
            for (const ShaderUse& use : std::vector<ShaderUse>(project_.shaders[from].uses))
                added += add(project_.shaders[to].uses, use) ? 1 : 0;
        }
        return added;
    }

    Project& project_;
    std::vector<FileId> listed_;                                   // texts of shaders, once for each name
    std::set<std::string, std::less<>> names_;                     // of these
    std::map<std::pair<dev_t, ino_t>, FileId> on_disk_;            // the first source of each file
    std::vector<std::pair<std::size_t, std::size_t>> inclusions_;  // from one of the shaders to another
};

// What is said of the other stages, and of the scene, where there are none.
Diagnostics without_others(const Diagnostics& all) {
    Diagnostics kept;
    for (const Diagnostic& diagnostic : all.items())
        if (diagnostic.code != lint::facts(lint::Rule::program_not_drawn).code &&
            diagnostic.code != "input-without-output")
            kept.add(diagnostic);
    return kept;
}

}  // namespace

std::string_view Project::path_of(FileId file) const {
    const std::string_view name = sources.name(file);
    if (file == scene_file) return alone ? std::string_view() : std::string_view(path);
    if (const Shader* shader = shader_of(file)) return shader->path;
    return name.starts_with('<') ? std::string_view() : name;
}

std::optional<FileId> Project::file_of(std::string_view wanted) const {
    const auto found = [&](const auto& same) -> std::optional<FileId> {
        for (FileId file = 0; file < sources.size(); ++file)
            if (const std::string_view name = path_of(file); !name.empty() && same(name)) return first(file);
        return std::nullopt;
    };
    if (const auto exact = found([&](std::string_view name) { return name == wanted; })) return exact;
    std::error_code error;
    if (std::filesystem::exists(wanted, error))
        return found([&](std::string_view name) { return std::filesystem::equivalent(name, wanted, error) && !error; });
    return found([&, tidy = normal(wanted)](std::string_view name) { return normal(name) == tidy; });
}

FileId Project::first(FileId file) const {
    const auto found = firsts.find(sources.name(file));
    return found == firsts.end() ? file : found->second;
}

const Shader* Project::shader_of(FileId file) const {
    const FileId wanted = first(file);
    const auto found = ranges::find_if(shaders, [&](const Shader& s) { return s.file == wanted; });
    return found == shaders.end() ? nullptr : &*found;
}

Project read_project(const std::string& scene_path, const Access& access, Depth depth) {
    Project project;
    project.path = scene_path;
    Reader reader(project, access);
    reader.read_scene();
    reader.list_shaders();
    if (depth == Depth::translated) reader.translate();
    project.diagnostics.sort();
    return project;
}

Project read_shader(const std::string& shader_path, const Access& access, Depth depth) {
    Project project;
    project.path = shader_path;
    Reader reader(project, access);
    std::string error;
    std::string text = project.files->read(shader_path, error).value_or("");
    const std::optional<Stage> stage = stage_of(shader_path, text);
    reader.read_alone(std::move(text), stage);
    reader.list_shaders();
    if (depth == Depth::translated) reader.translate();
    project.diagnostics = without_others(project.diagnostics);
    project.diagnostics.sort();
    return project;
}

namespace {

namespace fs = std::filesystem;

constexpr int levels_above = 3;
constexpr std::size_t most_entries = 10'000;     // of a folder that are looked at
constexpr std::size_t most_scenes = 4'000;       // whose texts are searched for the shader's name
constexpr std::size_t most_others = 100;         // that are read because what they include may name it
constexpr std::uintmax_t most_bytes = 1u << 20;  // of a scene

// The scenes of a folder, sorted; its folders are added to `below`.
std::vector<std::string> scenes_in(const fs::path& folder, std::vector<fs::path>* below) {
    std::vector<std::string> scenes;
    std::error_code error;
    std::size_t seen = 0;
    for (fs::directory_iterator it(folder, error), end; !error && it != end && seen < most_entries;
         it.increment(error), ++seen) {
        std::error_code none;
        if (has_extension(it->path().native(), "glib") && it->is_regular_file(none) &&
            it->file_size(none) <= most_bytes)
            scenes.push_back(it->path().string());
        if (below && it->is_directory(none)) below->push_back(it->path());
    }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

std::vector<std::string> scenes_around(const fs::path& shader) {
    std::vector<std::string> scenes;
    const auto add = [&](const std::vector<std::string>& more) {
        scenes.insert(scenes.end(), more.begin(), more.end());
    };
    std::vector<fs::path> below;
    fs::path folder = shader.parent_path();
    for (int level = 0; level <= levels_above && scenes.size() < most_scenes; ++level) {
        add(scenes_in(folder, level == 0 ? &below : nullptr));
        if (folder == folder.parent_path()) break;
        folder = folder.parent_path();
    }
    std::sort(below.begin(), below.end());
    for (const fs::path& one : below)
        if (scenes.size() < most_scenes) add(scenes_in(one, nullptr));
    if (scenes.size() > most_scenes) scenes.resize(most_scenes);
    return scenes;
}

bool names(const std::string& scene, const std::string& stem) {
    Files files("");
    std::string error;
    const auto text = files.read(scene, error);
    return text && contains(*text, stem);
}

bool belongs(const std::string& scene, const std::string& shader) {
    return read_project(scene, {}, Depth::plan).file_of(shader).has_value();
}

}  // namespace

std::string find_scene(const std::string& shader_path) {
    const std::string stem = fs::path(shader_path).stem().string();
    std::vector<std::string> others;
    for (const std::string& scene : scenes_around(shader_path)) {
        if (names(scene, stem)) {
            if (belongs(scene, shader_path)) return scene;
        } else if (others.size() < most_others) {
            others.push_back(scene);
        }
    }
    for (const std::string& scene : others)
        if (belongs(scene, shader_path)) return scene;
    return {};
}

std::optional<Stage> stage_of(std::string_view path, std::string_view text) {
    for (int i = 0; i < stage_count; ++i) {
        const auto stage = static_cast<Stage>(i);
        for (const std::string_view extension : stage_extensions(stage))
            if (extension != "glsl" && has_extension(path, extension)) return stage;
    }
    const auto has = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
    if (!has("main")) return std::nullopt;
    if (has("EmitVertex")) return Stage::geometry;
    if (has("gl_TessLevelOuter")) return Stage::tess_control;
    if (has("gl_TessCoord")) return Stage::tess_evaluation;
    return has("gl_Position") || has("ftransform") ? Stage::vertex : Stage::fragment;
}

}  // namespace snell::language
