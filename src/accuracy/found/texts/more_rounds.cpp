// Loops that go round more often.
#include <algorithm>
#include <cctype>

#include "parser/text/ranges.h"
#include "src/accuracy/found/texts/physics.h"
#include "src/glsl/read/words.h"

namespace snell::accuracy::texts {

namespace {

using Kind = Tree::Kind;

constexpr int most_rounds = 4096;  // that a loop is given: drivers end long ones

// Numbers of a function that follow the number of a loop's rounds, or the size of its steps.
class Followers {
public:
    // `bound`: what is changed is the number of rounds; otherwise it is the step.
    Followers(const glsl::Unit& unit, const Body& body, const Loop& loop, bool bound)
        : u_(unit), body_(body), loop_(loop), bound_(bound), counting_{loop.counter} {
        for (const Piece& piece : body.pieces) {
            if (!within(piece)) continue;
            if (piece.kind == Piece::Kind::declaration) {
                inside_.insert(piece.name);
                if (counts(piece.value)) counting_.insert(piece.name);
            }
            for_each(piece.value, [&](const Tree& tree) {
                if (tree.is(Kind::assign, "+=") && !inside_.contains(root(tree.parts[0])))
                    sums_.insert(root(tree.parts[0]));
            });
        }
    }

    std::vector<const Tree*> of(double value) const {
        std::vector<const Tree*> found;
        for (const Piece& piece : body_.pieces) {
            Path path;
            look(piece, piece.value, value, path, found);
        }
        return found;
    }

private:
    using Path = std::vector<const Tree*>;  // what a number is in, outermost first; no groups and no constructors

    bool within(const Piece& piece) const { return piece.first >= loop_.first && piece.last <= loop_.last; }
    std::string_view root(const Tree& target) const { return u_.at(target.first).text; }
    static bool constructs(const Tree& tree) { return tree.kind == Kind::call && glsl::builtin_type(tree.text); }
    static bool product(const Tree& tree) { return tree.infix("*") || tree.infix("/"); }
    static const Tree& plain(const Tree& tree) {
        const Tree* inner = &bare(tree);
        while (constructs(*inner) && inner->parts.size() == 1) inner = &bare(inner->parts[0]);
        return *inner;
    }

    // Whether the value is a number of the counter: without calls, which may do anything.
    bool counts(const Tree& tree) const {
        bool counter = false, call = false;
        for_each(tree, [&](const Tree& part) {
            counter = counter || (part.kind == Kind::name && counting_.contains(part.text));
            call = call || (part.kind == Kind::call && !constructs(part)) || part.kind == Kind::index;
        });
        return counter && !call;
    }

    void look(const Piece& piece, const Tree& tree, double value, Path& path, std::vector<const Tree*>& found) const {
        if (tree.kind == Kind::number) {
            if (number_of(tree) == value && (bound_ ? divides(piece, tree, path) : scales(piece, tree, path)))
                found.push_back(&tree);
            return;
        }
        const bool seen = tree.kind != Kind::group && !constructs(tree);
        if (seen) path.push_back(&tree);
        for (const Tree& part : tree.parts) look(piece, part, value, path, found);
        if (seen) path.pop_back();
    }

    // The sum that the value is, or a multiple of it; empty: none.
    std::string_view sum_of(const Tree& tree) const {
        const Tree& t = plain(tree);
        if (t.kind == Kind::name) return sums_.contains(t.text) ? t.text : std::string_view();
        if (t.kind == Kind::select || t.kind == Kind::index) return sum_of(t.parts[0]);
        if (!product(t)) return {};
        const std::string_view left = sum_of(t.parts[0]);
        return !left.empty() || t.infix("/") ? left : sum_of(t.parts[1]);
    }

    // Whether nothing but the loop has stored anything in the sum, up to the piece behind it.
    bool kept(std::string_view sum, const Piece& piece) const {
        if (sum.empty() || piece.first <= loop_.last) return false;
        return ranges::none_of(body_.pieces, [&](const Piece& other) {
            bool stored = false;
            if (other.first > loop_.last && other.first < piece.first)
                for_each(other.value, [&](const Tree& tree) {
                    stored = stored || (tree.kind == Kind::assign && root(tree.parts[0]) == sum);
                });
            return stored;
        });
    }

    // Whether the number, which `path` leads to, is a factor of a sum behind the loop. `from`: of the path's end, what
    // is a product with it.
    bool of_sum(const Piece& piece, const Path& path, std::size_t from) const {
        std::string_view sum;
        for (std::size_t i = from; i < path.size() && sum.empty(); ++i) sum = sum_of(path[i]->parts[0]);
        for (std::size_t i = from; i < path.size() && sum.empty(); ++i)
            if (path[i]->infix("*")) sum = sum_of(path[i]->parts[1]);
        const Tree* stored = from > 0 ? path[from - 1] : nullptr;
        if (sum.empty() && stored && (stored->is(Kind::assign, "*=") || stored->is(Kind::assign, "/=")))
            sum = sum_of(stored->parts[0]);
        return kept(sum, piece);
    }

    // Where the products begin that end the path.
    static std::size_t products(const Path& path) {
        std::size_t from = path.size();
        while (from > 0 && product(*path[from - 1])) --from;
        return from;
    }

    // The number of rounds: it divides the counter, what the loop adds up, or the sum behind it.
    bool divides(const Piece& piece, const Tree& number, const Path& path) const {
        if (path.empty()) return false;
        const Tree& last = *path.back();
        const bool divisor = last.infix("/") && &plain(last.parts[1]) == &number;
        if (!divisor && !last.is(Kind::assign, "/=")) return false;
        const std::size_t from = products(path);
        if (!within(piece)) return of_sum(piece, path, from);
        if (!divisor) return false;
        for (std::size_t i = from; i < path.size(); ++i)
            if (counts(path[i]->parts[0]) || (path[i]->infix("*") && counts(path[i]->parts[1]))) return true;
        return from == 1 && path[0]->is(Kind::assign, "+=") && sums_.contains(root(path[0]->parts[0]));
    }

    // The size of a step: a factor of what each round adds, of an exponent of what it multiplies, or of the sum.
    bool scales(const Piece& piece, const Tree& number, const Path& path) const {
        for (std::size_t i = products(path); i < path.size(); ++i)
            if (path[i]->infix("/") && &plain(path[i]->parts[1]) == &number) return false;
        std::size_t from = products(path);
        if (!within(piece)) return of_sum(piece, path, from);
        if (from > 0 && path[from - 1]->is(Kind::prefix, "-")) --from;
        const bool exponent = from > 0 && (path[from - 1]->call("exp", 1) || path[from - 1]->call("exp2", 1));
        return exponent || (from == 1 && (path[0]->is(Kind::assign, "+=") || path[0]->is(Kind::assign, "-=")));
    }

    const glsl::Unit& u_;
    const Body& body_;
    const Loop& loop_;
    bool bound_;
    std::set<std::string_view> counting_, inside_, sums_;  // variables: of the counter; of the loop's body; added up
};

class Rounds {
public:
    Rounds(const Shader& shader, Collector& to) : s_(shader), u_(shader.unit), to_(to) {}

    void run() {
        for (const Body& body : s_.bodies)
            for (const Loop& loop : body.loops)
                if (u_.at(loop.word).text == "for") more(body, loop);
    }

private:
    // The comparison of the counter, which may be one of several conditions.
    static const Tree& limit(const Loop& loop) {
        const Tree* limit = &bare(loop.condition);
        while (limit->infix("&&")) limit = &bare(limit->parts[0]);
        return *limit;
    }
    bool counts(const Loop& loop) const {
        const Tree& c = limit(loop);
        return (c.infix("<") || c.infix("<=")) && c.parts[0].is(Kind::name, loop.counter) && !loop.counter.empty() &&
               number_of(loop.start).has_value();
    }
    bool by_one(const Tree& step) const {
        return step.is(Kind::postfix, "++") || step.is(Kind::prefix, "++") ||
               (step.is(Kind::assign, "+=") && number_of(step.parts[1]) == 1.);
    }
    // An element of an array may not be there for more rounds.
    bool indexes(const Loop& loop) const {
        for (int k = loop.first; k <= loop.last && k < static_cast<int>(u_.tokens.size()); ++k)
            if (u_.at(k).text == "[")
                for (int j = k + 1; j <= loop.last && u_.at(j).text != "]"; ++j)
                    if (u_.at(j).text == loop.counter) return true;
        return false;
    }

    void more(const Body& body, const Loop& loop) {
        if (!counts(loop) || indexes(loop)) return;
        const Tree& bound = limit(loop).parts[1];
        if (!by_one(loop.step)) {
            if (loop.step.is(Kind::assign, "+=") && u_.at(loop.step.parts[1].first).kind == glsl::Kind::real)
                for (const double factor : {2., 4.}) change(body, loop, loop.step.parts[1], 1 / factor, false);
            return;
        }
        const Tree& value = bare(bound);
        for (const double factor : {2., 4.}) {
            if (value.kind == Kind::number && u_.at(value.first).macro < 0)
                change(body, loop, value, factor, true);
            else if (value.kind == Kind::number)
                change_macro(value, factor);
            else if (const auto constant = constant_of(value))
                change_constant(*constant, factor);
        }
    }

    static bool sensible(double rounds) { return rounds >= 2 && rounds <= most_rounds; }

    // The number, and equal ones of the function that are there because of it.
    void change(const Body& body, const Loop& loop, const Tree& number, double factor, bool bound) {
        const auto value = number_of(number);
        const auto head = span_of(u_, to_, loop.word, loop.close), own = span_of(u_, to_, number);
        if (!value || !head || !own || !(*value > 0)) return;
        const double start = number_of(loop.start).value_or(0);
        if (bound && (*value <= start || !sensible((*value - start) * factor))) return;
        const auto changed = [&](const Tree& leaf) {
            return numeral(*value * factor, u_.at(leaf.first).kind == glsl::Kind::integer);
        };
        Edits edits{{*own, changed(number)}};
        std::vector<Span> more;
        for (const Tree* leaf : Followers(u_, body, loop, bound).of(*value))
            if (const auto place = span_of(u_, to_, *leaf)) {
                edits.push_back({*place, changed(*leaf)});
                more.push_back(*place);
            }
        to_.add(ChangeKind::more_rounds, *head, std::move(edits), {}, more);
    }

    // The tokens of the number that a constant has.
    std::optional<int> constant_of(const Tree& name) const {
        if (name.kind != Kind::name) return std::nullopt;
        if (const Piece* local = declaration_of(s_, name))
            return local->value.kind == Kind::number ? std::optional(local->value.first) : std::nullopt;
        for (const glsl::Global& g : u_.globals)
            if (g.name == name.text && g.qualifiers.storage == glsl::Storage::constant && g.init_first >= 0 &&
                g.init_first == g.init_last && u_.at(g.init_first).kind == glsl::Kind::integer)
                return g.init_first;
        return std::nullopt;
    }

    void change_constant(int token, double factor) {
        const Tree leaf{Kind::number, token, token, u_.at(token).text, {}};
        const auto value = number_of(leaf);
        const auto place = span_of(u_, to_, leaf), name = span_of(u_, to_, token - 2, token);
        if (!value || !place || !name || !sensible(*value * factor)) return;
        to_.add(ChangeKind::more_rounds, *name, {{*place, numeral(*value * factor, true)}});
    }

    // The line that defines the macro.
    void change_macro(const Tree& use, double factor) {
        const glsl::Token& token = u_.at(use.first);
        const FileId file = u_.span(use.first).file;
        const std::string_view text = to_.sources().text(file);
        std::size_t end = token.offset;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_')) ++end;
        const std::string_view name = text.substr(std::min<std::size_t>(token.offset, text.size()), end - token.offset);
        const auto value = number_of(use);
        // The macro gives more than the number, such as a whole loop.
        if (u_.at(use.first - 1).macro == token.macro || u_.at(use.last + 1).macro == token.macro) return;
        if (name.empty() || !value || !sensible(*value * factor)) return;
        for (std::size_t at = text.find("#define"); at != text.npos; at = text.find("#define", at + 1)) {
            const std::size_t word = text.find_first_not_of(" \t", at + 7);
            if (word == text.npos || text.substr(word, name.size()) != name) continue;
            const std::size_t number = text.find_first_not_of(" \t", word + name.size());
            if (number == text.npos || number == word + name.size() ||
                text.substr(number, token.text.size()) != token.text)
                continue;
            const auto begin = static_cast<std::uint32_t>(number),
                       last = begin + static_cast<std::uint32_t>(token.text.size());
            to_.add(ChangeKind::more_rounds, {file, static_cast<std::uint32_t>(at), last},
                    {{{file, begin, last}, numeral(*value * factor, true)}});
            return;
        }
    }

    const Shader& s_;
    const glsl::Unit& u_;
    Collector& to_;
};

}  // namespace

void add_more_rounds(const Shader& shader, Collector& to) { Rounds(shader, to).run(); }

}  // namespace snell::accuracy::texts
