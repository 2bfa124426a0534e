// What holds for every text: shared by the fuzzer, the replay of its corpus, and the test on random bytes.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "parser/read/parse.h"
#include "tests/oracle/scene/print.h"

namespace snell::fuzz {

inline bool inside(Span span, const Sources& sources) {
    return span.file < sources.size() && span.begin <= span.end && span.end <= sources.text(span.file).size();
}

// Near the end of the range of floats, the parts of a transformation may leave it where the whole does not.
inline bool printable_matrices(const Scene& scene) {
    constexpr double large = 1e37;
    return std::all_of(scene.matrices.begin(), scene.matrices.end(), [](const Mat4& m) {
        return std::all_of(m.begin(), m.end(), [](double x) { return std::abs(x) <= large; });
    });
}

// Empty when all is well, else what is wrong.
inline std::string check(const std::string& text) {
    Sources sources;
    const FileId file = sources.add("fuzz.glib", text);
    const Parsed parsed = parse(file, sources);
    for (const Diagnostic& d : parsed.diagnostics.items()) {
        if (!inside(d.span, sources)) return "a span outside of the text: " + d.code;
        for (const Note& note : d.notes)
            if (!inside(note.span, sources)) return "a note outside of the text: " + d.code;
        if (d.code.empty() || d.message.empty()) return "a diagnostic without words";
    }
    for (const char c : render(parsed.diagnostics, sources))
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n') return "a control character in the diagnostics";
    for (const Draw& d : parsed.scene.draws)
        if (!inside(d.span, sources)) return "a draw outside of the text";
    for (const Program& p : parsed.scene.programs)
        for (const UniformValue& u : p.uniforms) {
            if (u.values.size() != u.value_spans.size() || u.values.empty()) return "a uniform with spans missing";
            for (const Span span : u.value_spans)
                if (!inside(span, sources)) return "a value outside of the text";
            for (const double value : u.values)
                if (!std::isfinite(value)) return "a value that is not finite";
        }
    dump_tokens(file, sources);
    dump_statements(file, sources);
    dump_scene(parsed.scene);
    if (!printable_matrices(parsed.scene)) return {};
    Sources again;
    const std::string printed = print_scene(parsed.scene);
    const std::string d = difference(parsed.scene, parse(again.add("printed.glib", printed), again).scene);
    return d.empty() ? d : "reads back different: " + d + "\n" + printed;
}

}  // namespace snell::fuzz
