#include "src/plan/values/declared.h"

#include <algorithm>

#include "parser/text/ranges.h"

namespace snell {

namespace {

bool scene_sets(const Program& program, std::string_view name) {
    return ranges::any_of(program.uniforms, [&](const UniformValue& u) { return u.name == name; });
}

bool sampler_of_snell(std::string_view name, std::string_view type) {
    return name == "Noise2" || name == "Noise3" ||
           (type == "sampler2D" && ranges::count(glsl::mesh_samplers, name) > 0);
}

}  // namespace

TypeFacts type_facts(std::string_view type) {
    if (type.find("sampler") != std::string_view::npos) return {ValueType::sampler, 1};
    const char last = type.empty() ? '1' : type.back();
    const int digit = last >= '2' && last <= '4' ? last - '0' : 1;
    if (type.starts_with("mat") && type.size() > 3) return {ValueType::matrix, (type[3] - '0') * digit};
    switch (type.empty() ? 'f' : type[0]) {
        case 'i':
            return {ValueType::int_, digit};
        case 'u':
            return {ValueType::uint_, digit};
        case 'b':
            return {ValueType::bool_, digit};
        case 'd':
            return {ValueType::double_, digit};
        default:
            return {ValueType::float_, digit};
    }
}

const glsl::SystemName* find_system(const std::vector<glsl::SystemName>& names, std::string_view name,
                                    std::string_view type, const Program& program) {
    for (const glsl::SystemName& candidate : names)
        if (candidate.name == name && candidate.type == type && (candidate.legacy || !scene_sets(program, name)))
            return &candidate;
    return nullptr;
}

bool set_by_snell(const Program& program, std::string_view name, std::string_view type) {
    if (type_facts(type).type == ValueType::sampler) return sampler_of_snell(name, type) && !scene_sets(program, name);
    return name.starts_with("snell_") || find_system(glsl::system_names(), name, type, program) != nullptr;
}

ActiveUniform described(const Program& program, const glsl::DeclaredUniform& declared) {
    const TypeFacts facts = type_facts(declared.glsl_type);
    ActiveUniform uniform;
    uniform.name = declared.name;
    uniform.glsl_type = declared.glsl_type;
    uniform.type = facts.type;
    uniform.components = facts.components;
    uniform.array_size = std::max(declared.array_size, 1);
    uniform.system = set_by_snell(program, declared.name, declared.glsl_type);
    uniform.initial = declared.initial;
    uniform.initial.resize(static_cast<std::size_t>(uniform.components) * static_cast<std::size_t>(uniform.array_size));
    return uniform;
}

}  // namespace snell
