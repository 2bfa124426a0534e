// The outline of a scene or a shader.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "parser/commands/commands.h"
#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/language/names/links.h"
#include "src/language/services.h"

namespace snell::language {

namespace {

bool begins_pass(const Command& command) { return command.name.starts_with("RenderTo"); }

bool binds_texture(const Command& command) {
    return command.name.starts_with("Texture") || command.name == "CubeMap" || command.name == "Irradiance" ||
           command.name == "Prefilter";
}

bool draws(const Command& command) {
    return command.group == "Geometry" && command.name != "NumPatchVertices" &&
           (!command.name.starts_with("gl") || command.name == "glBegin");
}

using Kind = ShaderDeclaration::Kind;

class SceneSymbols {
public:
    explicit SceneSymbols(const Statements& statements) : s_(statements) {}

    std::vector<Symbol> run() {
        for (const SceneStatement& statement : s_.items) {
            add(statement);
            end_ = s_.span(statement).end;
        }
        close_pass();
        return std::move(all_);
    }

private:
    std::string_view argument(const SceneStatement& statement, std::size_t i) const {
        return i < statement.count ? s_.word(s_.tokens[statement.first + i]) : std::string_view();
    }
    // What follows the command, in one line.
    std::string arguments(const SceneStatement& statement) const {
        std::string text;
        for (std::uint32_t i = 1; i < statement.count && text.size() < 60; ++i) {
            const Token& token = s_.tokens[statement.first + i];
            if (i > 1 && !token.glued) text += ' ';
            text += s_.word(token);
        }
        return text;
    }

    Symbol symbol(const SceneStatement& statement, Symbol::Kind kind, std::string name, std::string detail) const {
        return {kind, std::move(name), std::move(detail), s_.span(statement), s_.span(s_.tokens[statement.first])};
    }

    void add(const SceneStatement& statement) {
        if (statement.command == nullptr) return;
        const std::string_view name = statement.command->name;
        if (begins_pass(*statement.command)) return pass(statement);
        if (name == "Program") return program(statement);
        if (name == "Ladder") return put(ladder(statement));
        if (name == "glEnd") return end_list(statement);
        if (binds_texture(*statement.command))
            return put(symbol(statement, Symbol::Kind::texture, std::string(name), arguments(statement)));
        if (name == "Include")
            return put(symbol(statement, Symbol::Kind::include, arguments(statement), std::string(name)));
        if (draws(*statement.command))
            return put(symbol(statement, Symbol::Kind::draw, std::string(name), arguments(statement)));
    }

    std::vector<Symbol>& level() {
        if (program_) return program_->children;
        return pass_ ? pass_->children : all_;
    }
    void put(Symbol symbol) { level().push_back(std::move(symbol)); }

    void pass(const SceneStatement& statement) {
        close_pass();
        const bool window = statement.count == 1;
        pass_ = symbol(statement, Symbol::Kind::pass, window ? "Window" : std::string(statement.command->name),
                       arguments(statement));
    }

    void program(const SceneStatement& statement) {
        close_program();
        std::string name(argument(statement, 1));
        if (statement.count > 1 && s_.tokens[statement.first + 1].kind == TokenKind::text)
            name = without_quotes(name, !s_.tokens[statement.first + 1].unclosed);
        Symbol made = symbol(statement, Symbol::Kind::program, name.empty() ? "built-in" : name, "Program");
        if (statement.count > 1) made.name_span = s_.span(s_.tokens[statement.first + 1]);
        for (const WrittenUniform& one : written_uniforms(s_, statement)) {
            const std::uint32_t end = std::max(one.value_end, one.name_span.end);
            const bool valued = one.value_end > one.value_begin;
            const std::string_view value =
                valued ? s_.text.substr(one.value_begin, one.value_end - one.value_begin) : std::string_view();
            made.children.push_back({Symbol::Kind::uniform, std::string(one.name), std::string(value.substr(0, 60)),
                                     Span{s_.file, one.name_span.begin, end}, one.name_span});
        }
        program_ = std::move(made);
    }

    Symbol ladder(const SceneStatement& statement) const {
        Symbol made = symbol(statement, Symbol::Kind::ladder, std::string(argument(statement, 1)), "Ladder");
        for (std::uint32_t i = 1; i < statement.count; ++i) {
            const Token& token = s_.tokens[statement.first + i];
            if (token.kind != TokenKind::word) continue;
            if (i == 1) {
                made.name_span = s_.span(token);
                continue;
            }
            made.children.push_back(
                {Symbol::Kind::rung, std::string(s_.word(token)), {}, s_.span(token), s_.span(token)});
        }
        if (made.name.empty()) made.name = "Ladder";
        return made;
    }

    void end_list(const SceneStatement& statement) {
        std::vector<Symbol>& here = level();
        if (!here.empty() && here.back().name == "glBegin") here.back().span.end = s_.span(statement).end;
    }

    void close_program() {
        if (!program_) return;
        program_->span.end = std::max(program_->span.end, end_);
        Symbol done = *std::exchange(program_, std::nullopt);
        put(std::move(done));
    }
    void close_pass() {
        close_program();
        if (!pass_) return;
        pass_->span.end = std::max(pass_->span.end, end_);
        all_.push_back(*std::exchange(pass_, std::nullopt));
    }

    const Statements& s_;
    std::vector<Symbol> all_;
    std::optional<Symbol> pass_, program_;
    std::uint32_t end_ = 0;  // of the statement before
};

Symbol::Kind symbol_kind(Kind kind) {
    using enum Symbol::Kind;
    // In the order of ShaderDeclaration::Kind.
    constexpr std::array kinds{uniform,  variable, variable,  variable, variable,  constant,
                               variable, function, structure, member,   structure, macro};
    return kinds[static_cast<std::size_t>(kind)];
}

std::vector<Symbol> shader_symbols(const Outline& outline) {
    std::vector<const ShaderDeclaration*> order;
    for (const ShaderDeclaration& d : outline.declarations)
        if (!d.local) order.push_back(&d);
    ranges::stable_sort(order, [](const auto* a, const auto* b) { return a->token < b->token; });
    std::vector<Symbol> all;
    for (const ShaderDeclaration* d : order) {
        std::string detail(d->type);
        if (d->kind == Kind::function)
            detail += "(" +
                      std::string(outline.text.substr(d->parameters_begin, d->parameters_end - d->parameters_begin)) +
                      ")";
        Symbol made{symbol_kind(d->kind), std::string(d->name), std::move(detail), Span{outline.file, d->begin, d->end},
                    outline.span(*d)};
        const bool inside = !all.empty() && made.span.begin >= all.back().span.begin &&
                            made.span.end <= all.back().span.end && all.back().kind == Symbol::Kind::structure;
        (inside ? all.back().children : all).push_back(std::move(made));
    }
    return all;
}

}  // namespace

std::vector<Symbol> symbols(const Project& project, FileId file) {
    Texts texts(project);
    return texts.is_scene(file) ? SceneSymbols(texts.statements(file)).run() : shader_symbols(texts.outline(file));
}

// Colours of a scene, and the edits that change them in the author's style of numbers.

namespace {

struct Numbers {
    std::vector<const Token*> tokens;
    std::vector<double> values;
};

// The numbers from token `at` on, up to what is none.
Numbers numbers_from(const Statements& s, std::span<const Token> tokens, std::size_t at) {
    Numbers found;
    for (; at < tokens.size() && found.tokens.size() < 4; ++at) {
        if (tokens[at].kind == TokenKind::comma) continue;
        if (tokens[at].kind != TokenKind::word) break;
        const Number number = read_number(s.word(tokens[at]));
        if (!number.usable()) break;
        found.tokens.push_back(&tokens[at]);
        found.values.push_back(number.value);
    }
    return found;
}

void add(const Statements& s, const Numbers& numbers, std::vector<Color>& found) {
    if (numbers.tokens.size() < 3) return;
    Color color{{s.file, numbers.tokens.front()->begin, numbers.tokens.back()->end}, {0, 0, 0, 1}};
    for (std::size_t i = 0; i < numbers.values.size(); ++i) color.rgba[i] = std::clamp(numbers.values[i], 0., 1.);
    found.push_back(color);
}

bool colored(std::string_view command) { return command == "Background" || command == "Color" || command == "glColor"; }

// With as many decimals as the number has that it replaces, and at least the three that tell 1/255 apart.
std::string styled(double value, std::string_view old) {
    const std::size_t point = old.find('.');
    const std::size_t written = point == std::string_view::npos ? 0 : old.size() - point - 1;
    const std::size_t decimals = std::clamp<std::size_t>(written, 3, 9);
    std::string text = fmt::format("{:.{}f}", value, decimals);
    while (text.back() == '0' && text.size() - text.find('.') - 1 > std::min(written, decimals)) text.pop_back();
    if (text.back() == '.' && point == std::string_view::npos) text.pop_back();
    const bool bare = old.starts_with('.') || (point == std::string_view::npos);
    if (text.starts_with("0.") && text.size() > 2 && bare) text.erase(0, 1);
    return text;
}

}  // namespace

std::vector<Color> colors(const Project& project, FileId file) {
    Texts texts(project);
    std::vector<Color> found;
    if (!texts.is_scene(file)) return found;
    const Statements& s = texts.statements(file);
    for (const SceneStatement& statement : s.items) {
        const std::span<const Token> tokens = s.tokens_of(statement);
        if (statement.command != nullptr && colored(statement.command->name)) {
            const bool bracket = tokens.size() > 1 && tokens[1].kind == TokenKind::open;
            add(s, numbers_from(s, tokens, bracket ? 2 : 1), found);
        } else if (statement.command == nullptr || statement.command->takes(ArgumentKind::uniforms)) {
            for (std::size_t i = 0; i < tokens.size(); ++i)
                if (tokens[i].kind == TokenKind::open && s.word(tokens[i]) == "{")
                    add(s, numbers_from(s, tokens, i + 1), found);
        }
    }
    return found;
}

std::vector<Edit> color_edits(const Project& project, const Span& span, const std::array<double, 4>& rgba) {
    Texts texts(project);
    std::vector<Edit> edits;
    if (!texts.is_scene(span.file)) return edits;
    const Statements& s = texts.statements(span.file);
    const SceneStatement* statement = s.at_statement(span.begin);
    const Token* first = s.at(span.begin);
    if (statement == nullptr || first == nullptr) return edits;
    const std::span<const Token> tokens = s.tokens_of(*statement);
    const auto at = static_cast<std::size_t>(
        std::find_if(tokens.begin(), tokens.end(), [&](const Token& t) { return t.begin >= span.begin; }) -
        tokens.begin());
    const Numbers numbers = numbers_from(s, tokens, at);
    if (numbers.tokens.size() < 3 || numbers.tokens.back()->end != span.end) return edits;
    constexpr double step = .5 / 255;  // editors know a colour by its bytes
    for (std::size_t i = 0; i < numbers.tokens.size(); ++i) {
        const double value = std::clamp(rgba[i], 0., 1.);
        if (std::abs(value - numbers.values[i]) < step) continue;
        edits.push_back({s.span(*numbers.tokens[i]), styled(value, s.word(*numbers.tokens[i]))});
    }
    if (numbers.tokens.size() == 3 && rgba[3] < 1 - step) {
        const bool bracket = s.word(tokens[at > 0 ? at - 1 : 0]) == "[";  // which has no place for it
        const std::uint32_t end = numbers.tokens.back()->end;
        if (!bracket)
            edits.push_back({{s.file, end, end}, " " + styled(std::max(rgba[3], 0.), s.word(*numbers.tokens.back()))});
    }
    return edits;
}

}  // namespace snell::language
