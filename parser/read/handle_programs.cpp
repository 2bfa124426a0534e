// Shaders and programs, and what has nothing to do with drawing.
#include "parser/commands/handlers.h"
#include "parser/read/builder.h"
#include "parser/read/match.h"
#include "parser/read/uniforms.h"
#include "parser/text/utf8.h"

namespace snell::handle {
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
