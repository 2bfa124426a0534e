// Changes of the scene's own text: numbers of cells, slices and texels, filters and encodings.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "parser/read/syntax.h"
#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/accuracy/found/texts/texts.h"

namespace snell::accuracy::texts {

namespace {

constexpr std::size_t most_scene_changes = 200;
constexpr int fewest_slices = 3, most_parts = 2048, smallest_noise = 8, fewest_texels = 8;

// A number of a shape's statement, with the value that a missing one has.
struct Field {
    double value = 0;
    bool count = false;  // whole
    bool round = false;  // of straight parts of something round
};

std::vector<Field> fields_of(const Shape& shape) {
    std::vector<Field> fields;
    std::visit(
        [&](const auto& one) {
            for_each_field(one, [&](const auto& value, bool round) {
                using Value = std::decay_t<decltype(value)>;
                if constexpr (std::is_arithmetic_v<Value>)
                    fields.push_back({static_cast<double>(value), std::is_same_v<Value, int>, round});
            });
        },
        shape);
    return fields;
}

// True if the vertex shader certainly hands on only what is linear in the vertex: then no picture depends on the
// number of cells of a flat quad.
bool linear(const glsl::Unit& unit) {
    const auto matrix_or_uniform = [&](std::string_view name) {
        if (name.find("Matrix") != name.npos) return true;
        return ranges::any_of(unit.globals, [&](const glsl::Global& g) {
            return g.name == name &&
                   (g.qualifiers.storage == glsl::Storage::uniform || g.qualifiers.storage == glsl::Storage::constant);
        });
    };
    const auto plain_call = [](std::string_view name) {
        return name == "main" || name == "ftransform" || name.starts_with("vec") || name.starts_with("mat");
    };
    for (const glsl::Function& function : unit.functions)
        for (int k = std::max(function.open, 1); k < function.close; ++k) {
            const std::string_view t = unit.at(k).text, next = unit.at(k + 1).text;
            if (t == "/" || t == "*=" || t == "/=" || t == "?") return false;
            if (next == "(" && unit.at(k).kind == glsl::Kind::identifier && !plain_call(t)) return false;
            if (t != "*") continue;
            const glsl::Token &a = unit.at(k - 1), &b = unit.at(k + 1);
            const auto factor = [&](const glsl::Token& token) {
                return token.kind == glsl::Kind::integer || token.kind == glsl::Kind::real ||
                       matrix_or_uniform(token.text);
            };
            if (!factor(a) && !factor(b)) return false;
        }
    return true;
}

class SceneChanges : OfStatements {
public:
    SceneChanges(const Reading& reading, std::vector<Change>& changes)
        : OfStatements(reading, changes, most_scene_changes) {}

    void run() {
        for (const Draw& draw : scene_.draws)
            if (readable(draw)) change_shape(draw);
        change_noise("Noise2D", scene_.noise2d, TextureTarget::d2, 2, {"Noise2", "uNoise2"});
        change_noise("Noise3D", scene_.noise3d, TextureTarget::d3, 3, {"Noise3", "uNoise3"});
        for (const Pass& pass : scene_.passes) change_texels(pass);
        cull();
        change_filters();
        decode();
    }

private:
    // The edits that give the statement these numbers; nothing where its arguments are not plain numbers.
    std::vector<Edit> with_numbers(const Statement& at, const std::vector<Field>& fields,
                                   const std::vector<double>& wanted) const {
        std::vector<Edit> edits;
        if (at.bracketed || at.arguments.size() > fields.size()) return {};
        std::size_t last = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (wanted[i] != fields[i].value) last = i + 1;
        std::string added;
        for (std::size_t i = 0; i < last; ++i) {
            const std::string text = text_of::number(wanted[i], fields[i].count);
            if (i >= at.arguments.size()) {
                added += " " + text;
                continue;
            }
            if (!read_number(to_.text(at.arguments[i])).usable()) return {};
            if (wanted[i] != fields[i].value) edits.push_back({at.arguments[i], text});
        }
        if (!added.empty()) edits.push_back(after(at.span, added));
        return edits;
    }

    // Multiplies the counts that `chosen` names, by `factor`, and keeps them between what makes sense.
    template <class Chosen>
    void scale(ChangeKind kind, const Statement& at, const std::vector<Field>& fields, double factor, int least,
               const Chosen& chosen) {
        std::vector<double> wanted;
        for (const Field& field : fields) {
            double value = field.value;
            if (chosen(field)) value = std::max(std::round(value * factor), std::min<double>(least, value));
            if (factor > 1 && value > most_parts) return;
            wanted.push_back(value);
        }
        if (auto edits = with_numbers(at, fields, wanted); !edits.empty()) to_.add(kind, at.span, std::move(edits));
    }

    bool cells_matter(const Draw& draw) const {
        if (draw.program == none) return false;
        for (const Shader& shader : shaders_) {
            if (!shader.programs.contains(draw.program)) continue;
            if (shader.unit.stage != Stage::vertex && shader.unit.stage != Stage::fragment) return true;
            if (shader.unit.stage == Stage::vertex && !linear(shader.unit)) return true;
        }
        return false;
    }

    void change_shape(const Draw& draw) {
        const Statement* at = statement(draw.span);
        if (!at) return;
        const std::vector<Field> fields = fields_of(draw.shape);
        if (std::holds_alternative<Quad>(draw.shape)) {
            const auto cells = [](const Field& field) { return field.count; };
            const bool matter = cells_matter(draw);
            for (const double factor : {.75, .5, .25, matter ? .25 : 0})
                scale(ChangeKind::fewer_cells, *at, fields, factor, 1, cells);
            if (!matter) return;
            for (const double factor : {2., 4.}) scale(ChangeKind::finer_cells, *at, fields, factor, 1, cells);
            return;
        }
        const bool slabs = std::holds_alternative<QuadBox>(draw.shape);
        const auto slices = [&](const Field& field) { return field.round || slabs; };
        if (ranges::none_of(fields, slices)) return;
        for (const double factor : {3. / 4, 1. / 2, 1. / 3})
            scale(ChangeKind::fewer_slices, *at, fields, factor, fewest_slices, slices);
        // More quads of a QuadBox are denser, not more exact.
        if (!slabs) scale(ChangeKind::more_slices, *at, fields, 2, fewest_slices, slices);
    }

    // Smaller numbers of texels for a texture's statement, as its edits; none if there is no size that may shrink.
    std::vector<Edit> fewer_texels(const Texture& texture, int part) const {
        std::vector<Edit> edits;
        const Statement* at = statement(texture.span);
        if (!at || !texture.files.empty() || texture.computed != Computed::no) return {};
        for (std::size_t i = 1; i < at->arguments.size(); ++i) {  // the first is the unit
            const Number size = read_number(to_.text(at->arguments[i]));
            if (!size.usable() || size.value / part < fewest_texels) return {};
            edits.push_back({at->arguments[i], text_of::number(std::floor(size.value / part), true)});
        }
        return edits;
    }

    static bool solid(const Draw& draw) {
        return !draw.wire && std::visit([](const auto& shape) { return shape.solid; }, draw.shape);
    }

    bool readable(const Draw& draw) const { return draw.program == none || plan_.programs[draw.program].readable; }

    // Culls each solid alone, and all of them: they have no inside that shows, unless they are transparent, or the eye
    // is in them.
    void cull() {
        if (ranges::any_of(all_, [](const Statement& at) { return at.command == "CullFace"; })) return;
        std::vector<Edit> all;
        std::size_t solids = 0;
        bool culled = false, repeated = false;
        std::set<const Statement*> seen;
        for (const Draw& draw : scene_.draws) {
            const Statement* at = statement(draw.span);
            if (!at) continue;
            repeated = !seen.insert(at).second || repeated;
            const bool cullable = readable(draw) && solid(draw);
            if (cullable != culled) {
                culled = !culled;
                all.push_back(line_before(at->span, culled ? "CullFace back" : "CullFace none"));
            }
            if (!cullable) continue;
            ++solids;
            std::vector<Edit> alone{line_before(at->span, "CullFace back")};
            // Nothing follows the last draw, unless its text is included again.
            if (&draw != &scene_.draws.back() || at->span.file != 0)
                alone.push_back(line_after(at->span, "CullFace none"));
            to_.add(ChangeKind::culled, at->span, std::move(alone));
        }
        // What is drawn twice by one text would need a state before it that is not the same both times.
        if (solids < 2 || repeated) return;
        const Span where = all.front().span;
        to_.add(ChangeKind::culled, where, std::move(all));
    }

    // The textures of one pass keep one size.
    void change_texels(const Pass& pass) {
        for (const int part : {2, 4}) {
            std::vector<Edit> all;
            for (const Index texture : pass.textures) {
                if (texture >= scene_.textures.size()) return;  // there is none on its unit
                const std::vector<Edit> edits = fewer_texels(scene_.textures[texture], part);
                if (edits.empty()) return;
                all.insert(all.end(), edits.begin(), edits.end());
            }
            if (all.empty()) return;
            const Span where = scene_.textures[pass.textures.front()].span;
            to_.add(ChangeKind::fewer_texels, where, std::move(all));
        }
    }

    void change_noise(std::string_view command, int size, TextureTarget target, int unit,
                      std::initializer_list<std::string_view> names) {
        const auto own = [&](const Texture& t) { return t.unit == unit && t.target == target; };
        const auto reads = [&](const Shader& shader) {
            return ranges::any_of(shader.unit.globals, [&](const glsl::Global& g) {
                return g.type.base == glsl::Base::sampler && !g.uses.empty() &&
                       std::find(names.begin(), names.end(), g.name) != names.end();
            });
        };
        if (ranges::none_of(shaders_, reads) || ranges::any_of(scene_.textures, own) || all_.empty()) return;
        const auto found =
            std::find_if(all_.rbegin(), all_.rend(), [&](const Statement& s) { return s.command == command; });
        for (const int part : {2, 4}) {
            const int smaller = size / part;
            if (smaller < smallest_noise) continue;
            const std::string number = std::to_string(smaller);
            if (found == all_.rend()) {
                insert_line(ChangeKind::smaller_noise, all_.front().span, std::string(command) + " " + number);
                continue;
            }
            const Edit edit =
                found->arguments.empty() ? after(found->span, " " + number) : Edit{found->arguments[0], number};
            to_.add(ChangeKind::smaller_noise, found->span, {edit});
        }
    }

    static Edit line_before(Span statement, std::string_view line) {
        return before(statement, std::string(line) + "\n");
    }
    // Behind the lines of the statement, of which the last may have nothing.
    Edit line_after(Span statement, const std::string& line) const {
        const std::string_view all = to_.sources().text(statement.file);
        const std::size_t end = end_of_lines(all, statement.end);
        if (end == all.size()) return insertion(statement, static_cast<std::uint32_t>(end), "\n" + line);
        const std::size_t next = end + (all.substr(end, 2) == "\r\n" ? 2 : 1);
        return insertion(statement, static_cast<std::uint32_t>(next), line + "\n");
    }
    void insert_line(ChangeKind kind, Span at, std::string_view line) {
        const Edit edit = line_before(at, line);
        to_.add(kind, edit.span, {edit});
    }

    void change_filters() {
        bool said = false, there = false;
        const Texture* first = nullptr;  // from a file
        for (Index i = 0; i < scene_.textures.size(); ++i) {
            const Texture& texture = scene_.textures[i];
            const bool from_file = !texture.files.empty() && is_there(scene_, i, files_);
            there = there || from_file || texture.files.empty();
            if (!first && from_file && texture.target != TextureTarget::d1) first = &texture;
        }
        if (!there) return;
        for (const Statement& at : all_) {
            if (at.command != "Filter") continue;
            said = true;
            if (at.arguments.empty()) {
                to_.add(ChangeKind::less_filtered, at.span, {after(at.span, " nearest")});
                to_.add(ChangeKind::filtered, at.span, {after(at.span, " mipmap")});
                continue;
            }
            constexpr std::array<std::string_view, 4> modes{"nearest", "linear", "mipmap", "anisotropic"};
            const auto mode = std::find(modes.begin(), modes.end(), to_.text(at.arguments[0]));
            if (mode == modes.end()) continue;
            // An anisotropic filter is no better than mipmaps where a surface faces the eye, and has a second argument.
            for (auto other = modes.begin(); other != modes.end() - 1; ++other)
                if (other != mode)
                    to_.add(
                        other < mode ? ChangeKind::less_filtered : ChangeKind::filtered, at.span,
                        {{{at.span.file, at.arguments.front().begin, at.arguments.back().end}, std::string(*other)}});
        }
        if (said || !first) return;
        if (const Statement* at = statement(first->span)) {
            insert_line(ChangeKind::less_filtered, at->span, "Filter nearest");
            insert_line(ChangeKind::filtered, at->span, "Filter mipmap");
        }
    }

    // Files of floats hold light already, others hold no colours.
    static bool holds_colours(const Texture& texture) {
        if (texture.files.empty() || (texture.target != TextureTarget::d2 && texture.target != TextureTarget::cube))
            return false;
        constexpr std::string_view no_colours[] = {".hdr",   ".exr",  ".tex",  "normal", "bump", "height",
                                                   "displa", "rough", "noise", "depth",  "mask"};
        return ranges::none_of(texture.files, [&](const FileName& file) {
            const std::string name = lowered(file.name.substr(file.name.find_last_of('/') + 1));
            return ranges::any_of(no_colours, [&](std::string_view word) { return name.find(word) != name.npos; });
        });
    }

    void decode() {
        const auto says = [](const Texture& t) { return t.encoding.has_value(); };
        const auto output = [](const Statement& s) { return s.command == "Output"; };
        if (ranges::any_of(scene_.textures, says) || ranges::any_of(all_, output)) return;
        std::vector<Edit> edits;
        Span where;
        bool averaged = false, there = false;
        for (Index i = 0; i < scene_.textures.size(); ++i) {
            const Texture& texture = scene_.textures[i];
            averaged = averaged || texture.computed != Computed::no;
            const Statement* at = statement(texture.span);
            // Arguments behind the files would come before the word.
            if (!at || !holds_colours(texture) || at->arguments.size() != texture.files.size() + 1) continue;
            if (edits.empty()) where = at->span;
            there = there || is_there(scene_, i, files_);
            edits.push_back(after(at->span, " srgb"));
        }
        if (!there) return;
        edits.push_back(line_before(all_.front().span, "Output srgb"));
        to_.add(ChangeKind::decoded, where, std::move(edits), averaged ? "encoded-light" : "");
    }
};

}  // namespace

}  // namespace snell::accuracy::texts

namespace snell::accuracy {

void add_scene_changes(const Reading& reading, std::vector<Change>& changes) {
    texts::SceneChanges(reading, changes).run();
}

}  // namespace snell::accuracy
