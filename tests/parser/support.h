// What the tests of the parser share.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "parser/read/parse.h"

namespace snell::test {

struct Read {
    Sources sources;
    Parsed parsed;
    const Scene& scene() const { return parsed.scene; }
    const std::vector<Diagnostic>& diagnostics() const { return parsed.diagnostics.items(); }

    // "line:column code" of each diagnostic.
    std::vector<std::string> codes() const {
        std::vector<std::string> out;
        for (const Diagnostic& d : diagnostics()) {
            const Position at = sources.position(d.span.file, d.span.begin);
            out.push_back(std::to_string(at.line) + ":" + std::to_string(at.column) + " " + d.code);
        }
        return out;
    }
    std::string under(Span span) const {
        return std::string(sources.text(span.file).substr(span.begin, span.end - span.begin));
    }
    const Mat4& matrix(std::size_t draw) const { return scene().matrices[scene().draws[draw].matrix]; }
};

inline Read read(std::string text, const IncludeReader& include = {}, const Limits& limits = {}) {
    Read r;
    const FileId file = r.sources.add("scene.glib", std::move(text));
    r.parsed = parse(file, r.sources, include, limits);
    return r;
}

using Codes = std::vector<std::string>;

}  // namespace snell::test
