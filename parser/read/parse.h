// Parses text to a Scene. It accepts any bytes, never throws or prints, and opens no files itself.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/limits.h"
#include "parser/text/source.h"

namespace snell {

// Returns the text of an included scene, and its name, which later includes are relative to; nothing if it cannot be
// read, and an empty name if there is no such file.
struct IncludedText {
    std::string name;
    std::string text;
    std::string nearest = {};  // without a name: the file that was probably meant
    std::string exact = {};    // the name as the scene should write it, if it writes another one
    std::string why = {};      // without a name: why the file cannot be read, if that is known
};
// Reads the scene `name` that is included by the scene `from`; returns nullopt if it cannot be read.
using IncludeReader = std::function<std::optional<IncludedText>(std::string_view from, std::string_view name)>;

// What is said of a name that leads to a file of another one (file-inexact).
std::string inexact_name(std::string_view name, std::string_view path);
inline constexpr std::string_view inexact_name_help =
    "write the name exactly as on disk: other systems distinguish upper and lower case";

struct Parsed {
    Scene scene;
    Diagnostics diagnostics;
};

// `file` must be in `sources`; included texts are added there.
Parsed parse(FileId file, Sources& sources, const IncludeReader& include = {}, const Limits& limits = {});

// The results of the parser's stages as text, for `snell check --dump` and tests.
std::string dump_tokens(FileId file, const Sources& sources);
std::string dump_statements(FileId file, const Sources& sources);
std::string dump_scene(const Scene& scene);

}  // namespace snell
