// Text to Scene. Pure and total: any bytes in, never throws, never prints, opens nothing itself.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "parser/diagnostic.h"
#include "parser/limits.h"
#include "parser/scene.h"
#include "parser/source.h"

namespace snell {

// Gives the text of an included scene, and the name it is known by from then on (which later includes are
// relative to); nothing when it can't be read, and no name when there is no such file.
struct IncludedText {
    std::string name;
    std::string text;
    std::string nearest = {};  // without a name: the file that was probably meant
};
using IncludeReader = std::function<std::optional<IncludedText>(std::string_view from, std::string_view name)>;

struct Parsed {
    Scene scene;
    Diagnostics diagnostics;
};

// `file` is in `sources`; included texts are added there.
Parsed parse(FileId file, Sources& sources, const IncludeReader& include = {}, const Limits& limits = {});

// The stages of the reading as text, for `snell check --dump` and tests.
std::string dump_tokens(FileId file, const Sources& sources);
std::string dump_statements(FileId file, const Sources& sources);
std::string dump_scene(const Scene& scene);

}  // namespace snell
