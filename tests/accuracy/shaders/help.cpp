#include "tests/accuracy/shaders/help.h"
#include "parser/read/parse.h"
#include "src/accuracy/found/shaders/shader.h"
#include "src/plan/texts.h"

namespace snell::accuracy::test {

Found::Found(const std::string& path) : files(std::make_unique<Files>(std::filesystem::path(path).parent_path())) {
    std::string error;
    const FileId id = sources.add(path, files->read(path, error).value_or(""));
    const auto included = [&](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        const std::string at = files->resolve_beside(from, name, {"glib"}).path;
        auto text = files->read(at, error);
        return text ? std::optional(IncludedText{at, *text}) : std::nullopt;
    };
    Parsed parsed = parse(id, sources, included);
    diagnostics.append(parsed.diagnostics);
    plan = make_plan(std::move(parsed.scene), *files, sources, diagnostics);
    add_shader_changes(Reading(plan, *files, sources), changes);
}

std::vector<const Change*> Found::of(ChangeKind kind) const {
    std::vector<const Change*> found;
    for (const Change& change : changes)
        if (change.kind == kind) found.push_back(&change);
    return found;
}

std::vector<std::string> Found::lines(ChangeKind kind) const {
    std::vector<std::string> found;
    for (const Change* change : of(kind)) found.push_back(change->before + " → " + change->after);
    return found;
}

std::string Found::changed(const Change& change, std::string_view file) const {
    const std::array<const Change*, 1> one{&change};
    for (const auto& [name, text] : changed_texts(one, sources))
        if (name.ends_with(file)) return text;
    return {};
}

const Change* Found::find(ChangeKind kind, std::string_view before, std::string_view after) const {
    for (const Change* change : of(kind))
        if (change->before.find(before) != std::string::npos && change->after.find(after) != std::string::npos)
            return change;
    return nullptr;
}

Found& FoundShaders::scene(std::string_view text, const std::vector<File>& files) {
    for (const File& file : files) folder_.write(file.name, file.text);
    found_ = std::make_unique<Found>(folder_.write("scene.glib", text));
    EXPECT_FALSE(found_->diagnostics.has_errors()) << render(found_->diagnostics, found_->sources);
    return *found_;
}

Found& FoundShaders::shaders(std::string_view fragment, std::string_view values, std::string_view state,
                             const std::vector<File>& more) {
    std::vector<File> files = more;
    files.push_back(
        {"a.vert",
         "varying vec3 vN, vP;\nvarying vec2 vST;\nvoid main() {\n    vN = gl_Normal;\n    vP = gl_Vertex.xyz;\n"
         "    vST = gl_MultiTexCoord0.st;\n    gl_Position = ftransform();\n}\n"});
    files.push_back({"a.frag", std::string(fragment)});
    return scene(
        std::string(state) + "\nVertex a.vert\nFragment a.frag\nProgram A " + std::string(values) + "\nSphere 1.\n",
        files);
}

std::string translation_errors(const Found& found, const std::vector<const Change*>& changes) {
    Access access;
    access.instead = std::make_shared<const std::map<std::string, std::string>>(changed_texts(changes, found.sources));
    Files files(found.files->folder(), access);
    Sources sources;
    Diagnostics diagnostics;
    const Plan plan = make_plan(found.plan.scene, files, sources, diagnostics);
    for (const PlannedProgram& planned : plan.programs) {
        const Program& program = plan.scene.programs[planned.program];
        if (!planned.readable || planned.stages.empty()) continue;
        glsl::Options options;
        options.target = {450, false, true};
        options.include = shader_includes(files);
        options.geometry_input = program.geometry_input;
        options.geometry_output = program.geometry_output;
        options.defines = ladder_defines(
            std::span(plan.scene.ladders).first(std::min(program.ladders, plan.scene.ladders.size())), plan.rungs);
        glsl::translate(planned.stages, sources, options, diagnostics);
    }
    return diagnostics.has_errors() ? render(diagnostics, sources) : std::string();
}

}  // namespace snell::accuracy::test
