// Ladders: methods to choose from when programs are compiled.
#include "parser/commands/handlers.h"
#include "parser/read/builder.h"
#include "parser/read/match.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell {
namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }
bool name_part(char c) { return digit(c) || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool whole_number(std::string_view text) { return ranges::all_of(text, digit); }

// This is an identifier of the preprocessor, which reserves two underscores in a row.
bool identifier(std::string_view text) {
    return !text.empty() && ranges::all_of(text, name_part) && !digit(text.front());
}

// These words are common in shaders, or reserved by GLSL.
bool reserved(std::string_view name) {
    constexpr std::string_view words[] = {"attribute", "bool",    "break",   "case",          "centroid",  "const",
                                          "continue",  "default", "defined", "discard",       "do",        "double",
                                          "else",      "false",   "flat",    "float",         "for",       "highp",
                                          "if",        "in",      "inout",   "int",           "invariant", "layout",
                                          "lowp",      "main",    "mediump", "noperspective", "out",       "patch",
                                          "precision", "return",  "sample",  "smooth",        "struct",    "subroutine",
                                          "switch",    "true",    "uint",    "uniform",       "varying",   "void",
                                          "while"};
    constexpr std::string_view types[] = {"vec", "ivec", "uvec", "bvec", "dvec", "mat", "dmat"};
    const auto is_type = [&](std::string_view type) {
        return name.size() > type.size() && name.starts_with(type) && digit(name[type.size()]);
    };
    return ranges::find(words, name) != std::end(words) || ranges::any_of(types, is_type) ||
           name.starts_with("sampler") || name.starts_with("gl_") || name.starts_with("GL_") ||
           name.starts_with("snell_") || name.find("__") != std::string_view::npos;
}

std::string shown(std::string_view text) { return "'" + std::string(text.substr(0, 60)) + "'"; }

bool usable_name(std::string_view name, Span span, Collector& report) {
    if (!identifier(name)) {
        report.error("ladder-name", span, shown(name) + " cannot be a macro in a shader",
                     "a ladder's name has letters, digits and underscores, and no digit at its beginning");
        return false;
    }
    if (!reserved(name) && name.back() != '_') return true;
    report.error("ladder-name", span, shown(name) + " is a word that GLSL keeps for itself", "choose another name");
    return false;
}

// Reads the rungs of one statement.
class Rungs {
public:
    Rungs(Ladder& ladder, const Arguments& arguments, Collector& report)
        : ladder_(ladder), lexer_(arguments.lexer()), report_(report) {
        bool open = false;
        for (const Token& token : arguments.tokens().subspan(2)) {
            if (token.kind == TokenKind::open) open = true;
            if (token.kind == TokenKind::close) open = false;
            if (token.kind != TokenKind::word && token.kind != TokenKind::text) continue;
            const std::size_t place = add(token);
            if (open && place < ladder_.rungs.size()) mark(place);
        }
        if (marked_ < ladder_.rungs.size()) ladder_.current = marked_;
    }

private:
    // Returns the rung's index, or the number of rungs if the rung cannot be used.
    std::size_t add(const Token& token) {
        const std::string_view rung = lexer_.text(token);
        const Span span = lexer_.span(token);
        const bool good =
            ranges::all_of(rung, name_part) && !rung.starts_with('_') && rung.find("__") == std::string_view::npos;
        if (!good) {
            report_.error("ladder-rung", span, shown(rung) + " cannot be part of a macro's name",
                          "a rung is a word of letters, digits and underscores, or a whole number");
            return ladder_.rungs.size();
        }
        const auto same = ranges::find(ladder_.rungs, rung);
        if (same != ladder_.rungs.end()) {
            const auto place = static_cast<std::size_t>(same - ladder_.rungs.begin());
            report_.error("repeated-rung", span, "ladder '" + ladder_.name + "' has the rung " + shown(rung) + " twice")
                .notes.push_back({ladder_.rung_spans[place], "first given here"});
            return place;
        }
        ladder_.rungs.emplace_back(rung);
        ladder_.rung_spans.push_back(span);
        return ladder_.rungs.size() - 1;
    }

    void mark(std::size_t place) {
        if (marked_ < ladder_.rungs.size() && marked_ != place) {
            report_
                .error("two-current-rungs", ladder_.rung_spans[place],
                       "two rungs of ladder '" + ladder_.name + "' are marked as the current one: the first is")
                .notes.push_back({ladder_.rung_spans[marked_], "first marked here"});
            return;
        }
        marked_ = place;
    }

    Ladder& ladder_;
    const Lexer& lexer_;
    Collector& report_;
    std::size_t marked_ = static_cast<std::size_t>(-1);
};

// The macros of a ladder.
std::vector<std::string> macros(const Ladder& ladder) {
    std::vector<std::string> names{ladder.name};
    for (const std::string& rung : ladder.rungs) names.push_back(ladder.name + "_" + rung);
    if (ladder.numeric()) names.push_back(ladder.name + "_VALUE");
    return names;
}

// `Ladder A B_C` and `Ladder A_B C` would both define A_B_C.
bool macros_differ(const Ladder& ladder, const std::vector<Ladder>& others, Collector& report) {
    const std::vector<std::string> mine = macros(ladder);
    for (const Ladder& other : others) {
        if (other.name == ladder.name) continue;
        for (const std::string& name : macros(other)) {
            if (ranges::find(mine, name) == mine.end()) continue;
            report
                .error("ladder-clash", ladder.name_span,
                       "this ladder and '" + other.name + "' both define " + snell::shown(name), "choose another name")
                .notes.push_back({other.name_span, "the other ladder"});
            return false;
        }
    }
    return true;
}

}  // namespace

bool Ladder::numeric() const { return ranges::all_of(rungs, whole_number); }

void handle::ladder(Builder& b, const Arguments& a) {
    Ladder ladder;
    ladder.name = a.text(0);
    ladder.span = a.span();
    ladder.name_span = a.span(0);
    if (!usable_name(ladder.name, ladder.name_span, b.report())) return;
    Rungs(ladder, a, b.report());
    if (ladder.rungs.empty()) {
        b.report().error("ladder-without-rungs", a.span(), "ladder '" + ladder.name + "' has no rung to choose",
                         "usage: Ladder NAME rung rung ...");
        return;
    }
    std::vector<Ladder>& ladders = b.scene().ladders;
    if (!macros_differ(ladder, ladders, b.report())) return;
    const auto same = ranges::find(ladders, ladder.name, &Ladder::name);
    if (same == ladders.end()) {
        ladders.push_back(std::move(ladder));
        return;
    }
    b.report()
        .warning("repeated-ladder", ladder.name_span,
                 "ladder '" + ladder.name + "' is given twice: the last one holds, for every program")
        .notes.push_back({same->name_span, "first given here"});
    *same = std::move(ladder);
}

}  // namespace snell

namespace snell::handle {

// Shaders and programs, and what has nothing to do with drawing.
namespace {

void stage(Builder& b, const Arguments& a, Stage stage) {
    auto& current = b.stages[static_cast<std::size_t>(stage)];
    current.reset();
    if (a.given(0)) current = FileName{file_name(a.text(0)), a.span(0), b.from};
}

std::string to_utf8(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const utf8::Char c = utf8::decode(text, i);
        utf8::append(out, c.code);
        i += c.length;
    }
    return out;
}

}  // namespace

void vertex(Builder& b, const Arguments& a) { stage(b, a, Stage::vertex); }
void tess_control(Builder& b, const Arguments& a) { stage(b, a, Stage::tess_control); }
void tess_evaluation(Builder& b, const Arguments& a) { stage(b, a, Stage::tess_evaluation); }
void geometry(Builder& b, const Arguments& a) { stage(b, a, Stage::geometry); }
void fragment(Builder& b, const Arguments& a) { stage(b, a, Stage::fragment); }

void geometry_input(Builder& b, const Arguments& a) { b.geometry_input = a.text(0); }
void geometry_output(Builder& b, const Arguments& a) { b.geometry_output = a.text(0); }

void program(Builder& b, const Arguments& a) {
    if (a.tokens().size() == 1) return b.no_program();
    UniformList list = read_uniforms(a.tokens().subspan(1), a.lexer(), b.report(), b.limits(), true);
    Program program;
    program.name = std::move(list.program);
    program.uniforms = std::move(list.uniforms);
    program.span = a.span();
    b.begin_program(std::move(program));
}

void gstap(Builder& b, const Arguments&) { b.scene().gstap = true; }

void timer(Builder& b, const Arguments& a) {
    if (a.number(0) > 0) {
        b.scene().timer_period = a.number(0);
        return;
    }
    b.report().error("period-out-of-range", a.span(0), "a period is longer than 0 seconds: it is left as it was");
}

void message_box(Builder& b, const Arguments& a) {
    std::string_view text = a.text(0);
    const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    if (quoted) text = text.substr(1, text.size() - 2);
    if (const std::uint64_t most = b.limits().message_bytes; text.size() > most) {
        b.report().error("message-too-long", a.span(), "only the first " + std::to_string(most) + " bytes are shown",
                         limit_help(b.limits(), &Limits::message_bytes));
        text = text.substr(0, most);
    }
    b.scene().messages.push_back({to_utf8(text), a.span()});
}

void verbose(Builder& b, const Arguments&) { b.scene().verbose = true; }

void include(Builder& b, const Arguments& a) {
    if (b.include) b.include(a.text(0), a.span(), a.span(0));
}

}  // namespace snell::handle
