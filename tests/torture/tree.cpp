#include "tests/torture/tree.h"
#include "tests/pattern.h"
#include "tests/scratch.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace snell::torture {
namespace {

namespace fs = std::filesystem;

bool is_one_of(const std::string& extension, const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), extension) != list.end();
}
bool is_scene(const fs::path& file) { return is_one_of(file.extension(), {".glib", ".inc"}); }
bool is_shader(const fs::path& file) {
    return is_one_of(file.extension(), {".vert", ".frag", ".geom", ".tcs", ".tes", ".glsl"});
}
bool is_text(const fs::path& file) { return is_scene(file) || is_shader(file) || file.extension() == ".obj"; }
Language language_of(const std::string& file) { return is_scene(file) ? Language::scene : Language::shader; }

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// What stands between blanks and quotation marks.
std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    std::string name;
    for (const char c : text + " ") {
        if (!std::isspace(static_cast<unsigned char>(c)) && c != '"' && c != '<' && c != '>') {
            name += c;
            continue;
        }
        if (!name.empty()) names.push_back(name);
        name.clear();
    }
    return names;
}

// All that a file names, and what that names.
void follow(const fs::path& folder, const std::string& file, Subject& subject) {
    std::vector<std::string>& known = is_text(file) ? subject.texts : subject.bytes;
    if (std::find(known.begin(), known.end(), file) != known.end()) return;
    known.push_back(file);
    if (!is_text(file) || fs::path(file).extension() == ".obj") return;
    for (const std::string& name : names_in(bytes_of(folder / file))) {
        const fs::path named = (fs::path(file).parent_path() / name).lexically_normal();
        std::error_code error;
        if (named.has_extension() && fs::is_regular_file(folder / named, error)) follow(folder, named, subject);
    }
}

std::vector<Subject> subjects_in(const fs::path& folder, const std::vector<std::string>& parts) {
    std::vector<Subject> subjects;
    for (const std::string& part : parts)
        for (const fs::path& file : files_below(folder / part)) {
            if (file.extension() != ".glib") continue;
            Subject subject;
            subject.scene = file.lexically_relative(folder);
            follow(folder, subject.scene, subject);
            subjects.push_back(std::move(subject));
        }
    return subjects;
}

// "uA 1. uB [.5 .5 .5]" for what the text declares.
std::string values_for(const std::string& text) {
    const std::map<std::string, std::string> values{
        {"float", "<0. .5 1.>"},   {"int", "1"},       {"bool", "<true>"},  {"vec2", "[.5 .5]"}, {"vec3", "[.5 .5 .5]"},
        {"vec4", "{.5 .5 .5 1.}"}, {"sampler2D", "5"}, {"samplerCube", "6"}};
    std::string said;
    for (const auto& declared : test::matches(text, R"(uniform\s+(\w+)\s+(\w+))"))
        if (const auto value = values.find(declared[1]); value != values.end())
            said += " " + declared[2] + " " + value->second;
    return said;
}

// A scene around the programs of tests/glsl: NAME.vert, NAME.frag …; plain.vert and plain.frag fill what NAME lacks.
void write_scenes(const fs::path& folder) {
    std::map<std::string, std::map<std::string, std::string>> programs;  // by name, then by extension
    for (const fs::path& file : files_below(folder))
        if (file.extension() != ".glsl") programs[file.stem()][file.extension()] = file.filename();
    const std::vector<std::pair<std::string, std::string>> stages{{"Vertex", ".vert"},
                                                                  {"TessControl", ".tcs"},
                                                                  {"TessEvaluation", ".tes"},
                                                                  {"Geometry", ".geom"},
                                                                  {"Fragment", ".frag"}};
    for (auto& [name, files] : programs) {
        files.try_emplace(".vert", "plain.vert");
        files.try_emplace(".frag", "plain.frag");
        std::string scene =
            "Perspective 50\nLookAt 0 0 4 0 0 0 0 1 0\nNoise2D 16\nNoise3D 16\nTexture2D 5 ../cases/files/rainbow.bmp\n"
            "CubeMap 6";
        for (int face = 0; face < 6; ++face) scene += " ../cases/files/letter.bmp";
        std::string values;
        scene += "\n";
        for (const auto& [command, extension] : stages)
            if (const auto file = files.find(extension); file != files.end()) {
                scene += command + " " + file->second + "\n";
                values += values_for(bytes_of(folder / file->second));
            }
        const std::string mesh = files.contains(".tcs") || files.contains(".tes") ? "ObjPatch" : "Obj";
        scene += "Program P" + values + "\n" + mesh + " ../cases/files/ring.obj\n";
        write_file(folder / (name + ".glib"), scene);
    }
}

void choose_options(Mutant& mutant, Random& random) {
    std::vector<std::string>& options = mutant.options;
    const auto add = [&](std::initializer_list<std::string> words) { options.insert(options.end(), words); };
    // One in eight is drawn at the scene's own size, with the limits of every day.
    const bool plain = below(random, 8) == 0;
    if (!plain) add({"--size", choose(random, std::vector<std::string>{"64x64", "97x61", "1x1", "200x150"})});
    if (!plain && below(random, 2) == 0)
        add({"--limit", "vertices=500000", "--limit", "texture-bytes=67108864", "--limit", "sub-quads=100000",
             "--limit", "noise-3d=128", "--limit", "draws=20000"});
    mutant.timeout = plain ? 20 : 8;
    add({"--timeout", plain ? "20" : "8"});
    if (below(random, 4) == 0) add({"--grade"});
    if (below(random, 8) == 0) add({"--samples", "4"});
    if (below(random, 8) == 0) add({"--time", choose(random, std::vector<std::string>{"1.5", "-1", "1e30"})});
    if (below(random, 8) == 0) add({"--count-non-finite"});
    if (below(random, 8) == 0) add({"--transparent"});
    if (below(random, 8) == 0) add({"--axes"});
    if (below(random, 12) == 0) add({"--tile", "64"});
    if (below(random, 12) == 0) mutant.output = "o.exr";
    if (below(random, 12) == 0) add({"--context", choose(random, std::vector<std::string>{"3.3", "4.1", "es3.2"})});
}

}  // namespace

void write_file(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

void copy_tree(const std::string& root, const std::string& folder) {
    for (const char* part : {"scenes", "tests/cases", "tests/odd", "tests/bad", "tests/glsl"}) {
        fs::create_directories(fs::path(folder) / part);
        fs::copy(fs::path(root) / part, fs::path(folder) / part, fs::copy_options::recursive);
    }
    write_scenes(fs::path(folder) / "tests/glsl");
}

Tree read_tree(const std::string& folder) {
    Tree tree;
    tree.kinds = {subjects_in(folder, {"scenes"}), subjects_in(folder, {"tests/cases"}),
                  subjects_in(folder, {"tests/odd", "tests/bad"}), subjects_in(folder, {"tests/glsl"})};
    for (const fs::path& file : files_below(folder))
        if (is_scene(file) || is_shader(file)) learn(tree.dictionary, language_of(file), bytes_of(file));
    return tree;
}

Mutant make_mutant(const Tree& tree, const std::string& folder, std::uint32_t seed, std::uint32_t number) {
    std::seed_seq sequence{seed, number};
    Random random(sequence);
    const Subject& subject = choose(random, choose(random, tree.kinds));
    Mutant mutant{.scene = subject.scene};
    choose_options(mutant, random);
    // Mostly once, seldom often.
    std::size_t left = 1;
    while (left < 30 && below(random, 2) == 0) ++left;
    for (; left > 0; --left) {
        const bool bytes = !subject.bytes.empty() && below(random, 12) == 0;
        const bool scene = below(random, 3) == 0;
        const std::string& file = bytes   ? choose(random, subject.bytes)
                                  : scene ? subject.scene
                                          : choose(random, subject.texts);
        auto change =
            std::find_if(mutant.changes.begin(), mutant.changes.end(), [&](const Change& c) { return c.file == file; });
        if (change == mutant.changes.end())
            change = mutant.changes.insert(change, {file, bytes_of(folder + "/" + file)});
        mutant.how += "; " + file + ": " + damage(change->text, language_of(file), tree.dictionary, random);
    }
    mutant.how.erase(0, 2);
    return mutant;
}

}  // namespace snell::torture
