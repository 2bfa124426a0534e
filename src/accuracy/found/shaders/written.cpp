#include "src/accuracy/found/shaders/written.h"

#include "parser/text/ranges.h"
#include "src/glsl/read/words.h"

namespace snell::accuracy {

namespace {

// A function's tokens, read backwards and statement by statement.
class Statements {
public:
    Statements(const glsl::Unit& unit, const glsl::Function& function) : u_(unit), f_(function) {}

    bool written(std::string_view name, int token) const {
        bool other_case = false;  // of a switch
        for (int k = token - 1; k > f_.open; --k) {
            const std::string_view t = text(k);
            if (t == "}" || t == ")" || t == "]") k = opening(k);
            if (t == "{") other_case = false;
            if (t == "case" || t == "default") other_case = true;
            if (t != name) continue;
            const int first = start(k);
            const bool declares = declared(k, first);
            const bool writes = (declares || k == first || text(k - 1) == ",") && !conditional(first) && assigned(k);
            if (declares) return writes && !other_case;
            if (writes && !other_case) return true;
        }
        if (const int k = parameter(name); k >= 0) return !only_out(k);
        return ranges::any_of(u_.globals, [&](const glsl::Global& g) { return g.name == name && g.init_first >= 0; });
    }

    // Whether a statement before the token writes all of the variable, on some path.
    bool perhaps_written(std::string_view name, int token) const {
        for (int k = f_.open + 1; k < token; ++k)
            if (text(k) == name && text(k + 1) == "=" && text(k - 1) != ".") return true;
        return false;
    }

private:
    std::string_view text(int k) const { return u_.at(k).text; }

    int opening(int close) const {
        int depth = 0;
        for (int k = close; k > f_.open; --k) {
            const std::string_view t = text(k);
            if (t == "}" || t == ")" || t == "]") ++depth;
            if (t == "{" || t == "(" || t == "[") --depth;
            if (depth == 0) return k;
        }
        return f_.open + 1;
    }
    int behind(int open) const {
        int depth = 0;
        for (int k = open; k < f_.close; ++k) {
            const std::string_view t = text(k);
            if (t == "{" || t == "(" || t == "[") ++depth;
            if (t == "}" || t == ")" || t == "]") --depth;
            if (depth == 0) return k + 1;
        }
        return f_.close;
    }

    // The first token of the statement that the token is in, behind labels.
    int start(int token) const {
        int first = token;
        while (first - 1 > f_.open) {
            const std::string_view t = text(first - 1);
            if (t == ";" || t == "{" || t == "}") break;
            first = t == ")" || t == "]" ? opening(first - 1) : first - 1;
        }
        while (first < token && (text(first) == "case" || text(first) == "default")) {
            while (first < token && text(first) != ":") ++first;
            if (first < token) ++first;
        }
        return first;
    }

    bool conditional(int first) const {
        constexpr std::string_view words[] = {"if", "else", "for", "while", "do", "switch"};
        return ranges::find(words, text(first)) != std::end(words);
    }

    bool declared(int name, int first) const {
        while (first < name && glsl::is_qualifier(text(first))) ++first;
        if (u_.at(first).kind != glsl::Kind::identifier || glsl::is_statement_word(text(first))) return false;
        int next = first + 1;
        while (next < f_.close && text(next) == "[") next = behind(next);
        if (next >= f_.close || u_.at(next).kind != glsl::Kind::identifier || next > name) return false;
        return name == next || text(name - 1) == ",";
    }

    // Elements are not all of an array, but its initialiser is.
    bool assigned(int name) const {
        int next = name + 1;
        if (declared(name, start(name)))
            while (next < f_.close && text(next) == "[") next = behind(next);
        return next < f_.close && text(next) == "=";
    }

    int parameter(std::string_view name) const {
        for (int k = f_.open - 1; k > f_.name_token; --k)
            if (text(k) == name) return k;
        return -1;
    }
    bool only_out(int name) const {
        for (int k = name; k > f_.name_token && text(k) != ","; --k)
            if (text(k) == "out") return true;
        return false;
    }

    const glsl::Unit& u_;
    const glsl::Function& f_;
};

}  // namespace

bool surely_written(const glsl::Unit& unit, const glsl::Function& function, std::string_view name, int token) {
    return Statements(unit, function).written(name, token);
}

bool can_go(const glsl::Unit& unit, const glsl::Function& function, int first, bool updates) {
    const Statements statements(unit, function);
    const std::string_view name = unit.at(first).text;
    return statements.written(name, first) || (updates && statements.perhaps_written(name, first));
}

}  // namespace snell::accuracy
