#include "src/runtime/resources/instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "src/runtime/resources/uniforms.h"

namespace snell::runtime {

namespace {

using glsl::System;

constexpr std::size_t most_instances = 256;

// A model transformation changes these.
bool of_the_model(System system) {
    switch (system) {
        case System::model_view:
        case System::model_view_projection:
        case System::normal_matrix:
        case System::model_view_inverse:
        case System::model_view_projection_inverse:
        case System::model_view_transpose:
        case System::model_view_projection_transpose:
        case System::model_view_inverse_transpose:
        case System::model_view_projection_inverse_transpose:
        case System::model:
        case System::model_inverse:
        case System::model_normal_matrix:
        case System::model_viewer:
        case System::normal_scale:
            return true;
        default:
            return false;
    }
}

bool names(std::string_view text, std::string_view word) {
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !letter(text[at - 1])) && (end == text.size() || !letter(text[end]))) return true;
    }
    return false;
}

std::string declaration(const glsl::SystemName& name) {
    return fmt::format("\nuniform {} {};\n", name.type, name.name);
}

}  // namespace

InstancedText instanced_text(const glsl::Translation& translation, std::size_t block_bytes) {
    InstancedText result;
    if (translation.stages.size() != 2 || translation.stages[0].stage != Stage::vertex ||
        translation.stages[1].stage != Stage::fragment || !translation.renamed.empty())
        return {};
    std::string text = translation.stages[0].text;
    if (names(text, "gl_InstanceID")) return {};
    std::string block;
    std::size_t first = std::string::npos, bytes = 0;
    for (const glsl::SystemName& name : glsl::system_names()) {
        if (!of_the_model(name.system)) continue;
        if (names(translation.stages[1].text, name.name)) return {};
        if (!names(text, name.name)) continue;
        const std::string declared = declaration(name);
        const std::size_t at = text.find(declared);
        const int columns = name.type == "mat4" ? 4 : name.type == "mat3" ? 3 : 0;
        if (!name.legacy || at == std::string::npos || columns == 0) return {};
        first = std::min(first, at);
        bytes += static_cast<std::size_t>(columns) * 4 * sizeof(float);
        result.matrices.push_back({name.system, columns});
        block += fmt::format(" {} {}At[{{0}}];", name.type, name.name);
        text.replace(at, declared.size(), fmt::format("\n#define {0} {0}At[gl_InstanceID]\n", name.name));
    }
    if (result.matrices.empty()) return {};
    result.capacity = std::min(most_instances, block_bytes / bytes);
    text.insert(first, "\nlayout(std140) uniform snell_Instances {" +
                           fmt::format(fmt::runtime(block), result.capacity) + " };");
    result.text = std::move(text);
    return result;
}

// Each matrix has its own array.
void instance_values(const Instancing& instancing, const std::vector<DrawContext>& contexts,
                     std::vector<float>& values) {
    std::vector<float>& value = instancing.program->scratch;
    values.clear();
    for (const InstanceMatrix& matrix : instancing.matrices) {
        const auto columns = static_cast<std::size_t>(matrix.columns);
        const std::size_t begin = values.size();
        values.resize(begin + columns * 4 * instancing.capacity, 0.0F);
        for (std::size_t i = 0; i < contexts.size(); ++i) {
            value.clear();
            append_system(value, matrix.system, contexts[i]);
            for (std::size_t column = 0; column < columns; ++column)
                std::copy_n(value.begin() + static_cast<std::ptrdiff_t>(column * columns), columns,
                            values.begin() + static_cast<std::ptrdiff_t>(begin + (i * columns + column) * 4));
        }
    }
}

}  // namespace snell::runtime
