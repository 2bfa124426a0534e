#include "src/runtime/resources/effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <set>

#include "parser/text/number.h"
#include "parser/text/ranges.h"

namespace snell::runtime {

namespace {

constexpr std::size_t most_values = 64, most_sliders = 16;

// Calls `number` for every number in the text, without its sign.
template <class Function>
void each_number(std::string_view text, const Function& number) {
    const auto digit = [&](std::size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
    const auto in_name = [](char c) {
        return c == '_' || c == '.' || std::isalnum(static_cast<unsigned char>(c)) != 0;
    };
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (!digit(at) && !(text[at] == '.' && digit(at + 1))) continue;
        if (at > 0 && in_name(text[at - 1])) continue;
        double value = 0;
        const auto end = read_real(text.data() + at, text.data() + text.size(), value).ptr;
        at = std::max(at, static_cast<std::size_t>(end - text.data()) - 1);
        number(value);
    }
}

// What drivers make of one program. They write the program's name and hashes of its text into their code, too: all are
// linked into one program here, and bytes that a mere comment changes are ignored.
class Code {
public:
    explicit Code(const LinkRequest& request) : request_(request) {}
    bool same(const Control& slider, const Patience& patience);

private:
    // Empty if there is none.
    std::string with(const glsl::Translation& translation);
    glsl::Translation translated(const Control& slider, double value) const;
    static bool may_be_same(const std::string& a, const std::string& b);
    // The bytes of `code` that depend on comments. Empty: these are so many that the others may tell nothing.
    std::vector<bool> remarks_in(const std::string& code, const glsl::Translation& translation);

    const LinkRequest& request_;
    gl::Program program_{glCreateProgram()};
    int links_ = 0;
    // Code that the driver kept from an earlier run would have the name of that run's program.
    std::int64_t run_ = std::chrono::steady_clock::now().time_since_epoch().count();
};

glsl::Translation Code::translated(const Control& slider, double value) const {
    Diagnostics unheard;  // that of the program itself was heard
    LinkRequest one = request_;
    one.constant = glsl::Settled{slider.name, {value}};
    return translate(one, unheard);
}

std::string Code::with(const glsl::Translation& translation) {
    if (!translation.ok || translation.settled.empty()) return {};
    std::vector<gl::Compiled> compiled;
    std::vector<const gl::Shader*> shaders;
    const std::string remark = fmt::format("\n// {} {}\n", run_, links_++);
    for (const glsl::StageOutput& stage : translation.stages) {
        compiled.push_back(gl::compile(gl_stage(stage.stage), stage.text + remark));
        if (!compiled.back().shader) return {};
    }
    for (const gl::Compiled& one : compiled) shaders.push_back(&one.shader);
    return gl::binary_of(program_, shaders);
}

// By comments alone, few bytes change.
bool Code::may_be_same(const std::string& a, const std::string& b) {
    if (a.empty() || a.size() != b.size()) return false;
    std::size_t other = 0;
    for (std::size_t at = 0; at < a.size(); ++at) other += a[at] != b[at] ? 1 : 0;
    return other * 16 <= a.size();
}

std::vector<bool> Code::remarks_in(const std::string& code, const glsl::Translation& translation) {
    std::vector<bool> remarks(code.size(), false);
    for (int i = 0; i < 3; ++i) {  // a byte of a hash may stay the same by chance
        const std::string other = with(translation);
        if (!may_be_same(code, other)) return {};
        for (std::size_t at = 0; at < code.size(); ++at)
            if (code[at] != other[at]) remarks[at] = true;
    }
    return remarks;
}

bool Code::same(const Control& slider, const Patience& patience) {
    const glsl::Translation first = translated(slider, slider.min);
    std::string text;
    for (const glsl::StageOutput& stage : first.stages) text += stage.text;
    const std::vector<double> values = telling_values(slider, text);
    if (values.empty()) return false;
    const std::string code = with(first);
    std::vector<bool> remarks;
    return std::all_of(values.begin() + 1, values.end(), [&](double value) {
        if (patience.ended()) return false;
        const std::string other = with(translated(slider, value));
        if (!may_be_same(code, other)) return false;
        if (remarks.empty()) remarks = remarks_in(code, first);
        if (remarks.empty()) return false;
        for (std::size_t at = 0; at < code.size(); ++at)
            if (code[at] != other[at] && !remarks[at]) return false;
        return true;
    });
}

}  // namespace

std::vector<double> telling_values(const Control& slider, std::string_view text) {
    if (slider.type == ValueType::bool_) return {0, 1};
    std::set<double> values{slider.min, slider.max};
    if (slider.type == ValueType::int_ || slider.type == ValueType::uint_) {
        if (slider.max - slider.min >= most_values) return {};
        for (double value = slider.min; value < slider.max; ++value) values.insert(value);
    } else {
        for (int i = 1; i < 8; ++i) values.insert(slider.min + (slider.max - slider.min) * i / 8);
        each_number(text, [&](double number) {
            for (const double value : {number, -number})
                if (value > slider.min && value < slider.max) values.insert(value);
        });
        const std::vector<double> ends(values.begin(), values.end());
        for (std::size_t i = 1; i < ends.size(); ++i) values.insert(ends[i - 1] / 2 + ends[i] / 2);
        if (values.size() > most_values) return {};
    }
    std::vector<double> ordered(values.begin(), values.end());
    std::rotate(ordered.begin() + 1, ordered.end() - 1, ordered.end());
    return ordered;
}

std::vector<const Control*> without_effect(const LinkRequest& request, std::vector<const Control*> sliders,
                                           const Patience& patience) {
    if (sliders.empty() || patience.ended() || !gl::gives_binaries()) return {};
    Diagnostics unheard;
    LinkRequest general = request;
    general.settle = [](const auto&) { return std::vector<glsl::Settled>(); };
    const glsl::Translation translation = translate(general, unheard);
    std::erase_if(sliders, [&](const Control* slider) {
        const auto declared = ranges::find(translation.declared, slider->name, &glsl::DeclaredUniform::name);
        return declared == translation.declared.end() || declared->use == glsl::DeclaredUniform::Use::sure;
    });
    if (sliders.empty() || sliders.size() > most_sliders) return {};
    Code code(request);
    std::erase_if(sliders, [&](const Control* slider) { return !code.same(*slider, patience); });
    return sliders;
}

}  // namespace snell::runtime
