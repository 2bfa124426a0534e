// Colours of a scene, and the edits that change them in the author's style of numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/number.h"
#include "src/language/names/texts.h"
#include "src/language/services.h"

namespace snell::language {

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
