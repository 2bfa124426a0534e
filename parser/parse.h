// Text to Scene. Pure and total: any bytes in, never throws, never prints, opens nothing itself.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "parser/source.h"

namespace snell {

// Gives the text of an included scene, and the name it is known by from then on (which later includes are
// relative to); nothing when it can't be read.
struct IncludedText {
    std::string name;
    std::string text;
};
using IncludeReader = std::function<std::optional<IncludedText>(std::string_view from, std::string_view name)>;

struct ParseLimits {
    std::size_t text_bytes = 64u << 20;
    std::size_t statements = 4'000'000;
    int include_depth = 16;
    int matrix_stack = 10'000;
    std::size_t diagnostics = 1'000;
};

struct Parsed {
    Scene scene;
    Diagnostics diagnostics;
};

// `file` is in `sources`; included texts are added there.
Parsed parse(FileId file, Sources& sources, const IncludeReader& include = {}, const ParseLimits& limits = {});

// The stages of the reading as text, for `snell check --dump` and tests.
std::string dump_tokens(FileId file, const Sources& sources);
std::string dump_statements(FileId file, const Sources& sources);
std::string dump_scene(const Scene& scene);

}  // namespace snell
