#include <epoxy/gl.h>
#include <unistd.h>

#include "tests/compatibility/cases.h"
#include "tests/pattern.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::oracle {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, Stage>, 5> extensions = {{
    {".vert", Stage::vertex},
    {".tcs", Stage::tess_control},
    {".tes", Stage::tess_evaluation},
    {".geom", Stage::geometry},
    {".frag", Stage::fragment},
}};

std::optional<Stage> stage_of(const fs::path& file) {
    for (const auto& [extension, stage] : extensions)
        if (file.extension() == extension) return stage;
    return std::nullopt;
}

std::vector<fs::path> sorted_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void fill(Files& files, const fs::path& folder, const std::string& plain) {
    if (files.empty()) return;
    files.try_emplace(Stage::vertex, folder / (plain + ".vert"));
    files.try_emplace(Stage::fragment, folder / (plain + ".frag"));
}

std::string word_after(const std::string& text, const std::string& key) {
    const auto found = test::matches(text, key + R"(\s+(\w+))");
    return found.empty() ? std::string() : found[0][1];
}

GLenum input_primitive(const std::string& geometry, const std::string& named) {
    std::string kind = named;
    if (const auto found = test::matches(geometry, R"(layout\s*\(([^)]*)\)\s*in\b)"); !found.empty())
        kind = found[0][1];
    const auto has = [&](const char* word) { return kind.find(word) != std::string::npos; };
    if (has("triangles_adjacency")) return GL_TRIANGLES_ADJACENCY;
    if (has("lines_adjacency")) return GL_LINES_ADJACENCY;
    if (has("lines")) return GL_LINES;
    if (has("points")) return GL_POINTS;
    return GL_TRIANGLES;
}

}  // namespace

std::vector<Case> cases_of_folder(const fs::path& folder) {
    std::map<std::string, Case> found;
    for (const fs::path& file : sorted_files(folder)) {
        const auto stage = stage_of(file);
        fs::path stem = file.stem();
        const bool modern = stem.extension() == ".modern";
        if (modern) stem = stem.stem();
        if (!stage || stem == "plain") continue;
        Case& c = found[stem.string()];
        c.name = stem.string();
        (modern ? c.modern : c.files)[*stage] = file;
    }
    std::vector<Case> cases;
    for (auto& [name, c] : found) {
        fill(c.files, folder, "plain");
        fill(c.modern, folder, "plain.modern");
        cases.push_back(std::move(c));
    }
    return cases;
}

std::vector<Case> cases_of_scene(const fs::path& scene) {
    static const std::map<std::string, Stage> commands = {{"vertex", Stage::vertex},
                                                          {"fragment", Stage::fragment},
                                                          {"geometry", Stage::geometry},
                                                          {"tesscontrol", Stage::tess_control},
                                                          {"tessevaluation", Stage::tess_evaluation}};
    std::vector<Case> cases;
    Files current;
    std::istringstream lines(bytes_of(scene));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string command, argument;
        words >> command >> argument;
        for (char& c : command) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        if (const auto stage = commands.find(command); stage != commands.end()) {
            current.erase(stage->second);
            if (!argument.empty()) current[stage->second] = scene.parent_path() / argument;
        }
        const auto exists = [](const auto& file) { return fs::exists(file.second); };
        if (command != "program" || current.empty() || !std::all_of(current.begin(), current.end(), exists)) continue;
        cases.push_back({scene.stem().string() + "/" + argument, current, {}});
    }
    return cases;
}

std::vector<Case> pairs_of_folder(const fs::path& folder) {
    std::vector<Case> cases;
    std::vector<fs::path> vertex;
    for (const fs::path& file : sorted_files(folder))
        if (file.extension() == ".vert") vertex.push_back(file);
    for (const fs::path& file : sorted_files(folder)) {
        if (file.extension() != ".frag") continue;
        fs::path partner = file;
        partner.replace_extension(".vert");
        if (!fs::exists(partner) && vertex.size() == 1) partner = vertex.front();
        if (!fs::exists(partner)) continue;
        cases.push_back({folder.filename().string() + "/" + file.stem().string(),
                         {{Stage::vertex, partner}, {Stage::fragment, file}},
                         {}});
    }
    return cases;
}

Texts texts(const Files& files) {
    Texts result;
    for (const auto& [stage, file] : files) result[stage] = bytes_of(file);
    return result;
}

Needs needs(const Texts& texts) {
    Needs n;
    std::string all;
    for (const auto& [stage, text] : texts) all += text + "\n";
    const auto says = [&](const char* word) { return all.find(word) != std::string::npos; };
    n.geometry_input = word_after(all, "GeometryInput");
    n.geometry_output = word_after(all, "GeometryOutput");
    n.primitive = says("// draw: points") ? GL_POINTS : GL_TRIANGLES;
    if (texts.contains(Stage::geometry)) n.primitive = input_primitive(texts.at(Stage::geometry), n.geometry_input);
    if (texts.contains(Stage::tess_evaluation)) {
        n.primitive = GL_PATCHES;
        if (says("vertices = 4")) n.patch_vertices = 4;
    }
    n.targets = says("// draw: four targets") ? 4 : 1;
    n.two_sided = says("// draw: two-sided");
    return n;
}

Translated translated(const Case& which, const glsl::Target& target) {
    Translated result;
    Sources sources;
    const Needs n = needs(texts(which.files));
    glsl::Options options;
    options.target = target;
    options.geometry_input = n.geometry_input;
    options.geometry_output = n.geometry_output;
    options.include = [](std::string_view from, std::string_view name, bool angle) -> std::optional<glsl::IncludeText> {
        const fs::path file = fs::path(from).parent_path() / name;
        if (angle || !fs::exists(file)) return std::nullopt;
        return glsl::IncludeText{file.string(), bytes_of(file)};
    };
    const FileId scene = sources.add(which.name, which.name);
    std::vector<glsl::StageInput> stages;
    for (const auto& [stage, file] : which.files)
        stages.push_back({stage, sources.add(file.string(), bytes_of(file)), Span{scene, 0, 1}});
    result.translation = glsl::translate(stages, sources, options, result.diagnostics);
    result.ok = result.translation.ok;
    result.messages = render(result.diagnostics, sources);
    for (const glsl::StageOutput& stage : result.translation.stages) result.texts[stage.stage] = stage.text;
    return result;
}

fs::path kept_texts() { return fs::temp_directory_path() / ("snell-oracle-" + std::to_string(getuid())); }

fs::path write_texts(const std::string& name, const Texts& texts, const fs::path& folder) {
    std::string flat = name;
    std::replace(flat.begin(), flat.end(), '/', '-');
    fs::create_directories(folder);
    for (const auto& [stage, text] : texts)
        for (const auto& [extension, of] : extensions)
            if (of == stage) std::ofstream(folder / (flat + std::string(extension)), std::ios::binary) << text;
    return folder / flat;
}

}  // namespace snell::oracle
