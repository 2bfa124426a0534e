// docs/variables.md: the names that shaders find set, from the tables of src/glsl.
#include <algorithm>
#include <vector>

#include "src/glsl/glsl.h"
#include "src/glsl/read/words.h"
#include "tools/docs/generate.h"

namespace snell::docs {

// snell_ModelViewMatrix is written gl_ModelViewMatrix, and its own name is the translator's.
std::string written(std::string_view name) {
    if (!name.starts_with("snell_")) return std::string(name);
    std::string gl = "gl_" + std::string(name.substr(6));
    const glsl::LegacyName* const legacy = glsl::legacy_name(gl);
    if (!legacy || legacy->kind == glsl::LegacyKind::core) return {};
    return legacy->size > 0 ? gl + "[" + std::to_string(legacy->size) + "]" : gl;
}

namespace {

void add_name(std::string& names, const std::string& name) {
    if (!name.empty()) names += (names.empty() ? "`" : " `") + name + "`";
}

template <typename Facts>
std::string row(const std::string& names, const Facts& facts) {
    if (names.empty()) return {};
    return "| " + names + " | " + std::string(facts.type) + " | " + std::string(facts.space) + " | " +
           std::string(facts.range) + " | " + std::string(facts.doc) + " |\n";
}

std::string uniforms() {
    std::string out;
    for (const glsl::SystemFacts& facts : glsl::system_facts()) {
        std::string names;
        for (const glsl::SystemName& name : glsl::system_names())
            if (name.system == facts.system) add_name(names, written(name.name));
        out += row(names, facts);
    }
    return out;
}

std::string attributes() {
    std::string out;
    for (const glsl::AttributeFacts& facts : glsl::attribute_facts()) {
        std::string names;
        for (const glsl::AttributeName& name : glsl::attribute_names())
            if (name.attribute == facts.attribute) add_name(names, written(name.name));
        out += row(names, facts);
    }
    return out;
}

std::string numbers(const std::vector<double>& values) {
    std::string out;
    for (const double value : values) {
        std::string text = std::to_string(value);
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
        out += (out.empty() ? "" : " ") + text;
    }
    return out;
}

// One row for all elements of an array: "[0]: 1 1 1 1; others: 0 0 0 1" where the first differs.
std::string fixed_function() {
    struct Row {
        std::string name;
        std::vector<double> first, others;
    };
    std::vector<Row> rows;
    for (const glsl::UniformDefault& uniform : glsl::fixed_function_defaults()) {
        std::string name = "gl_" + uniform.name.substr(6);
        const std::size_t open = name.find('[');
        if (open != std::string::npos) name.replace(open + 1, name.find(']') - open - 1, "n");
        const auto known = std::ranges::find(rows, name, &Row::name);
        if (known == rows.end())
            rows.push_back({name, uniform.values, uniform.values});
        else
            known->others = uniform.values;
    }
    std::string out;
    for (const Row& r : rows) {
        const std::string type = r.first.size() == 1 ? "float" : "vec" + std::to_string(r.first.size());
        out += "| `" + r.name + "` | " + type + " | " + numbers(r.first) +
               (r.first == r.others ? "" : " for n = 0, otherwise " + numbers(r.others)) + " |\n";
    }
    return out;
}

}  // namespace

std::string variables() {
    const std::string header = "| name | type | space | range | value |\n|---|---|---|---|---|\n";
    return "# The variables that snell sets\n\nA shader can read these variables without a value in the scene. Names "
           "in "
           "one row mean the same. Declare names that\ndo not begin with `gl_` as `uniform` or as vertex input of the "
           "type in the table; a uniform of another type is not set.\nThe names of gstap.h (`uModelViewMatrix`, "
           "`aVertex` "
           "…) need no declaration. If the scene gives a uniform a value, that\nvalue is used. Written by snell_docs "
           "from "
           "the tables in src/glsl/names.cpp.\n\n"
           "Spaces: **model** is that of the shape, **world** follows after the transformations of the scene, **eye** "
           "after `LookAt`,\nand **clip** after the projection. Matrices multiply column vectors from the left: "
           "`matrix * "
           "vector`.\n\n## Uniforms\n\n" +
           header + uniforms() +
           "\n## Vertex inputs\n\nOther names are recognised by their parts ([glsl.md](glsl.md#vertex-inputs)). "
           "`gl_MultiTexCoord1` to `gl_MultiTexCoord7`\nare 0.\n\n" +
           header + attributes() +
           "\n## Lights, materials and fog\n\nThe built-in uniforms of the compatibility profile have the initial "
           "values "
           "of the OpenGL specification; n is 0 to 7.\nPositions and planes of lights are in eye space, colours are "
           "red, "
           "green, blue and alpha.\n\n| name | type | value |\n|---|---|---|\n" +
           fixed_function();
}

}  // namespace snell::docs
