// Lints of the scene, and what the scene says about the shaders of each program.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/tree.h"
#include "src/glsl/read/words.h"
#include "src/lint/walker.h"

namespace snell::lint {
namespace {

using glsl::Base;
using glsl::Global;
using glsl::Storage;
using glsl::Unit;

constexpr std::string_view texture_words[] = {"Texture1D", "Texture2D", "Texture3D", "CubeMap"};

// Degrees that a camera turns the eye away from looking along -Z with Y up.
double turn_of(const Camera& camera) {
    const glm::dmat4 m = view_matrix(camera);
    const double cosine = (m[0][0] + m[1][1] + m[2][2] - 1) / 2;
    return std::acos(std::clamp(cosine, -1., 1.)) * 180 / 3.14159265358979;
}

// Degrees by which float rounding may turn the difference of a position and the eye's, at the distance of what the
// camera looks at. Each of both is rounded by half a unit of its last place.
double far_turn_of(const Camera& camera) {
    if (!camera.look_at) return 0;
    const auto& [eye, center, up] = *camera.look_at;
    double distance = 0, largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        distance = std::hypot(distance, eye[i] - center[i]);
        largest = std::max(largest, std::abs(eye[i]));
    }
    return distance > 0 ? std::atan(largest * 0x1p-23 / distance) * 180 / 3.14159265358979 : 0;
}

struct Sampler {
    const Unit* unit;
    const Global* global;
    TextureTarget target;
    const UniformValue* set;  // by the scene
    int texture_unit;
};

class Checker {
public:
    Checker(const Plan& plan, Sources& sources, const glsl::IncludeReader& include)
        : plan_(plan), scene_(plan.scene), sources_(sources) {
        options_.include = [this, &include](std::string_view from, std::string_view name, bool angle) {
            auto text = include ? include(from, name, angle) : std::nullopt;
            if (text && angle) library_.insert(text->name);
            return text;
        };
    }

    Diagnostics run() {
        for (Index i = 0; i < scene_.programs.size(); ++i) {
            check_drawn(i);
            check_program(i);
        }
        check_light();
        found_.sort();
        return std::move(found_);
    }

private:
    static bool draws_with(const Draw& draw, Index program) { return draw.program == program; }

    Diagnostic* report(Rule rule, Span span, std::string message) {
        const RuleFacts& row = facts(rule);
        // A shader may belong to several programs, and a function be called from several places.
        if (!said_.emplace(row.rule, std::string(sources_.name(span.file)), span.begin).second) return nullptr;
        Diagnostic d;
        d.severity = row.severity;
        d.code = row.code;
        d.span = span;
        d.message = std::move(message);
        d.help = fmt::format("{} ({})", row.instead, more(row));
        return &found_.add(std::move(d));
    }

    void check_drawn(Index index) {
        const auto draws = [&](const Draw& d) { return draws_with(d, index); };
        if (std::any_of(scene_.draws.begin(), scene_.draws.end(), draws)) return;
        const Program& program = scene_.programs[index];
        report(Rule::program_not_drawn, program.span,
               fmt::format("nothing is drawn with program '{}': no geometry follows it", program.name));
    }

    // Means of encoded numbers are not those of light. Formats of floats hold light.
    void check_light() {
        const auto holds_light = [](const FileName& file) {
            const std::string_view name = file.name;
            return name.ends_with(".hdr") || name.ends_with(".exr") || name.ends_with(".HDR") || name.ends_with(".EXR");
        };
        for (const Texture& texture : scene_.textures) {
            if (texture.computed == Computed::no) continue;
            const Texture& source = scene_.textures[texture.source];
            if (source.encoding || source.files.empty() || ranges::any_of(source.files, holds_light)) continue;
            Diagnostic* d = report(Rule::encoded_light, texture.span,
                                   "this is the mean of the pictures' numbers, which are not proportional to light");
            if (d) d->notes.push_back({source.span, "the pictures"});
        }
    }

    Surroundings surroundings(Index index) const {
        Surroundings around;
        for (const UniformValue& u : scene_.programs[index].uniforms) {
            Surroundings::Uniform entry;
            entry.span = u.span;
            if (u.kind == UniformValue::Kind::range && u.values.size() == 3) {
                entry.range = between(std::min(u.values[0], u.values[2]), std::max(u.values[0], u.values[2]));
                entry.current = u.values[1];
            } else if (!u.values.empty()) {
                const auto [lo, hi] = std::minmax_element(u.values.begin(), u.values.end());
                entry.range = between(*lo, *hi);
                if (u.values.size() == 1) entry.current = u.values[0];
            }
            around.uniforms.insert_or_assign(u.name, entry);
        }
        for (const Pass& pass : scene_.passes)
            for (const Item& item : pass.items) {
                if (item.kind != Item::Kind::draw) continue;
                const Draw& draw = scene_.draws[item.index];
                if (!draws_with(draw, index)) continue;
                around.eye_turn = std::max(around.eye_turn, turn_of(scene_.cameras[draw.camera]));
                if (pass.kind != Pass::Kind::cube)
                    around.far_turn = std::max(around.far_turn, far_turn_of(scene_.cameras[draw.camera]));
                around.cube_faces = around.cube_faces || pass.kind == Pass::Kind::cube;
            }
        return around;
    }

    void check_program(Index index) {
        const PlannedProgram& planned = plan_.programs[index];
        if (!planned.readable || planned.stages.empty()) return;
        const Program& program = scene_.programs[index];
        options_.defines = ladder_defines(
            std::span(scene_.ladders).first(std::min(program.ladders, scene_.ladders.size())), plan_.rungs);
        std::vector<Unit> units(planned.stages.size());
        std::vector<glsl::Tree> trees(units.size());
        for (std::size_t i = 0; i < units.size(); ++i) {
            units[i].stage = planned.stages[i].stage;
            units[i].reference = planned.stages[i].reference;
            Diagnostics unheard;  // compiling says it
            glsl::preprocess(units[i], planned.stages[i].file, sources_, options_, unheard);
            units[i].tree = &trees[i];
            glsl::Parser(units[i], options_.target, unheard).run();
        }
        std::stable_sort(units.begin(), units.end(), [](const Unit& a, const Unit& b) { return a.stage < b.stage; });
        Surroundings around = surroundings(index);
        check_samplers(index, units, around);
        check_position(units);
        check_point_size(index, units);
        std::optional<Varyings> given;
        for (const Unit& unit : units) {
            check_shadows(unit);
            for (const Ladder& ladder :
                 std::span(scene_.ladders).first(std::min(program.ladders, scene_.ladders.size())))
                check_rungs(unit, ladder);
            if (unit.stage != Stage::vertex && unit.stage != Stage::fragment) {
                given.reset();
                continue;
            }
            Walker walker(unit, around, given ? &*given : nullptr,
                          [&](Rule rule, int first, int last, std::string message, std::vector<Note> notes) {
                              report_tokens(unit, rule, first, last, std::move(message), std::move(notes));
                          });
            given = walker.run();
        }
    }

    // Other stages behind it may place what it gives them.
    void check_position(const std::vector<Unit>& units) {
        const auto places = [](const Unit& unit) {
            return unit.stage != Stage::vertex && unit.stage != Stage::fragment;
        };
        if (units.front().stage != Stage::vertex || ranges::any_of(units, places)) return;
        const Unit& unit = units.front();
        if (ranges::count(unit.tokens, std::string_view("gl_Position"), &glsl::Token::text) > 0) return;
        for (const glsl::Function& function : unit.functions)
            if (function.name == "main" && function.open >= 0)
                report_tokens(unit, Rule::position_not_written, function.name_token, function.name_token,
                              "this vertex shader never writes gl_Position, so that nothing certain is drawn with it",
                              {});
    }

    // Whether the last stage before rasterization makes points of what is drawn.
    bool makes_points(const Unit& last, const Program& program, const Draw& draw) const {
        const auto says = [&](Storage storage, std::string_view primitive) {
            return ranges::any_of(last.layouts, [&](const glsl::StageLayout& l) {
                return l.qualifiers.storage == storage &&
                       ranges::count(l.qualifiers.layout, primitive, &glsl::LayoutItem::name) > 0;
            });
        };
        if (last.stage == Stage::geometry)
            return says(Storage::out, "points") ||
                   (lowered(program.geometry_output) == "gl_points" && !says(Storage::out, "line_strip") &&
                    !says(Storage::out, "triangle_strip"));
        if (last.stage == Stage::tess_evaluation) return says(Storage::in, "point_mode");
        if (const auto* list = std::get_if<VertexList>(&draw.shape))
            return scene_.vertex_lists[list->list].topology == Topology::points;
        return std::holds_alternative<PointCloud>(draw.shape);
    }

    // Where a draw of the same program takes it, it has an effect.
    void check_point_size(Index index, const std::vector<Unit>& units) {
        const auto behind =
            std::find_if(units.begin(), units.end(), [](const Unit& unit) { return unit.stage == Stage::fragment; });
        if (behind == units.begin()) return;
        const Unit& last = *std::prev(behind);
        const Draw* points = nullptr;
        for (const Draw& draw : scene_.draws) {
            if (!draws_with(draw, index) || !makes_points(last, scene_.programs[index], draw)) continue;
            if (scene_.rasters[draw.raster].point_size_mode) return;
            if (!points) points = &draw;
        }
        if (!points || !last.legacy_written.contains("gl_PointSize")) return;
        for (int k = 1; k < static_cast<int>(last.tokens.size()); ++k)
            if (last.at(k).text == "gl_PointSize" && last.at(k - 1).text != ".")
                return report_tokens(last, Rule::point_size_unused, k, k,
                                     "this has no effect: the scene draws these points without PointSizeMode 1",
                                     {{points->span, "the points"}});
    }

    void report_tokens(const Unit& unit, Rule rule, int first, int last, std::string message, std::vector<Note> notes) {
        Span span = unit.span(first);
        const Span end = unit.span(last);
        if (end.file == span.file && end.end > span.end) span.end = end.end;
        if (library_.contains(std::string(sources_.name(span.file)))) return;
        Diagnostic* d = report(rule, span, std::move(message));
        if (d) d->notes = std::move(notes);
    }

    // A local of a uniform's name, in any function; parameters are left alone.
    void check_shadows(const Unit& unit) {
        for (const glsl::Function& f : unit.functions)
            for (int k = f.open + 1; f.open >= 0 && k < f.close; ++k) {
                const glsl::Token &type = unit.at(k - 1), &name = unit.at(k), &after = unit.at(k + 1);
                const bool declares =
                    glsl::builtin_type(type.text) && name.kind == glsl::Kind::identifier &&
                    (after.text == "=" || after.text == ";" || after.text == "," || after.text == "[");
                if (!declares) continue;
                const auto is_it = [&](const Global& g) {
                    return g.name == name.text && g.qualifiers.storage == Storage::uniform;
                };
                const auto uniform = std::find_if(unit.globals.begin(), unit.globals.end(), is_it);
                if (uniform == unit.globals.end() || library_.contains(std::string(sources_.name(unit.span(k).file))))
                    continue;
                Diagnostic* d = report(Rule::shadowed_uniform, unit.span(k),
                                       fmt::format("this variable hides the uniform '{}'", name.text));
                if (d)
                    d->notes.push_back({unit.span(uniform->name_token), "the uniform, which has no effect behind it"});
            }
    }

    // The ladder's name for a number that is meant to be the rung's own. It may be compared with the rungs' names and
    // their places, choose an element or a case, and be handed on to where it is compared with them.
    void check_rungs(const Unit& unit, const Ladder& ladder) {
        const auto is_place = [&](const std::string& rung) {
            return rung == std::to_string(&rung - ladder.rungs.data());
        };
        if (!ladder.numeric() || ranges::all_of(ladder.rungs, is_place)) return;
        const auto size = static_cast<int>(unit.tokens.size());
        const auto text = [&](int k) { return k < 0 || k >= size ? std::string_view() : unit.at(k).text; };
        const auto written = [&](int k) {
            const bool macro = k >= 0 && k < size && unit.at(k).macro >= 0;
            return macro ? unit.invocations[static_cast<std::size_t>(unit.at(k).macro)] : text(k);
        };
        const auto names_rung = [&](int k) {
            const std::string_view name = written(k);
            return name.starts_with(ladder.name + "_") &&
                   ranges::count(ladder.rungs, name.substr(ladder.name.size() + 1)) > 0;
        };
        const auto is_sum = [&](int k) {
            return std::string_view("+-*/%").find(text(k).substr(0, 1)) != std::string_view::npos && !text(k).empty();
        };
        const auto is_own = [&](int k) { return written(k) == ladder.name; };
        const auto compared = [&](int k, const auto& with) {
            return (glsl::compares(text(k + 1)) && with(k + 2)) || (glsl::compares(text(k - 1)) && with(k - 2));
        };
        bool handed_on = false;  // the names of rungs are compared with something else
        for (int k = 0; k < size; ++k) handed_on = handed_on || (names_rung(k) && !compared(k, is_own));
        const auto is_place_number = [&](int k) {
            return unit.at(k).kind == glsl::Kind::integer && !is_sum(k - 1) &&
                   std::atof(std::string(text(k)).c_str()) < static_cast<double>(ladder.rungs.size());
        };
        for (int k = 0; k < size; ++k) {
            if (!is_own(k)) continue;
            const bool type_before = glsl::builtin_type(text(k - 2)) || glsl::builtin_type(text(k - 3));
            const bool chooses = (text(k - 1) == "[" && text(k + 1) == "]" && !type_before) || text(k - 2) == "switch";
            const bool copied = (text(k - 1) == "=" || text(k - 1) == "(" || text(k - 1) == ",") &&
                                (text(k + 1) == ";" || text(k + 1) == "," || text(k + 1) == ")") &&
                                !glsl::builtin_type(text(k - 2));
            if (compared(k, names_rung) || compared(k, is_place_number) || chooses || (copied && handed_on)) continue;
            Span span = unit.span(k);
            if (library_.contains(std::string(sources_.name(span.file)))) continue;
            span.end = span.begin + static_cast<std::uint32_t>(ladder.name.size());
            const std::size_t rung = plan_.rungs[static_cast<std::size_t>(&ladder - scene_.ladders.data())];
            Diagnostic* d = report(Rule::rung_number, span,
                                   fmt::format("'{}' is the index of the rung, {}, and not its number, {}", ladder.name,
                                               rung, ladder.rungs[rung]));
            if (d) {
                d->help = fmt::format("use {}_VALUE ({})", ladder.name, more(facts(Rule::rung_number)));
                d->notes.push_back({ladder.name_span, "the ladder"});
            }
        }
    }

    std::vector<Sampler> samplers(const Program& program, const std::vector<Unit>& units) const {
        std::vector<Sampler> found;
        for (const Unit& unit : units)
            for (const Global& g : unit.globals) {
                if (g.type.base != Base::sampler || g.type.dims > 0 || g.uses.empty()) continue;
                const auto target = sampler_target(g.name, g.type.name);
                const auto known = [&](const Sampler& s) { return s.global->name == g.name; };
                const bool noise = g.name == "Noise2" || g.name == "Noise3";  // where nothing stands, snell's own
                if (!target || noise || std::any_of(found.begin(), found.end(), known)) continue;
                const auto set = std::find_if(program.uniforms.begin(), program.uniforms.end(),
                                              [&](const UniformValue& u) { return u.name == g.name; });
                Sampler sampler{&unit, &g, *target, set == program.uniforms.end() ? nullptr : &*set, 0};
                for (const glsl::LayoutItem& item : g.qualifiers.layout)
                    if (item.name == "binding") sampler.texture_unit = std::atoi(item.value.c_str());
                if (sampler.set && !sampler.set->values.empty())
                    sampler.texture_unit =
                        static_cast<int>(sampler.set->values[sampler.set->kind == UniformValue::Kind::range ? 1 : 0]);
                found.push_back(sampler);
            }
        return found;
    }

    void check_samplers(Index index, const std::vector<Unit>& units, Surroundings& around) {
        const std::vector<Sampler> all = samplers(scene_.programs[index], units);
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (const Draw& draw : scene_.draws)
                if (draws_with(draw, index)) check_kind(all[i], draw, around);
            for (std::size_t j = 0; j < i; ++j)
                // Of samplers that the scene leaves alone, nothing is known to be meant.
                if ((all[i].set || all[j].set) && all[i].texture_unit == all[j].texture_unit &&
                    all[i].target != all[j].target) {
                    report_sharing(all[i], all[j]);
                    break;
                }
        }
    }

    static Span place(const Sampler& s) { return s.set ? s.set->span : s.unit->span(s.global->name_token); }

    void report_sharing(const Sampler& a, const Sampler& b) {
        Diagnostic* d = report(Rule::samplers_share_unit, place(a),
                               fmt::format("'{}' ({}) and '{}' ({}) are both on unit {}", a.global->name,
                                           a.global->type.name, b.global->name, b.global->type.name, a.texture_unit));
        if (d) d->notes.push_back({place(b), "the other one"});
    }

    void check_kind(const Sampler& s, const Draw& draw, Surroundings& around) {
        const Index wanted = find_texture(scene_, draw, s.texture_unit, s.target);
        if (wanted != none) {
            const Filter::Mode mode = scene_.textures[wanted].filter.mode;
            if (mode == Filter::Mode::mipmap || mode == Filter::Mode::anisotropic)
                around.mipmapped.insert(std::string(s.global->name));
            return;
        }
        if (!s.set) return;
        for (int other = 0; other < texture_target_count; ++other) {
            const auto target = static_cast<TextureTarget>(other);
            const Index there = find_texture(scene_, draw, s.texture_unit, target);
            if (there == none) continue;
            Diagnostic* d = report(
                Rule::sampler_kind, place(s),
                fmt::format("'{}' is {} {}, but unit {} holds a {}", s.global->name, article(s.global->type.name),
                            s.global->type.name, s.texture_unit, texture_words[other]));
            if (d) d->notes.push_back({scene_.textures[there].span, "the texture"});
            return;
        }
    }

    const Plan& plan_;
    const Scene& scene_;
    Sources& sources_;
    glsl::Options options_;
    std::set<std::string> library_;  // names of texts that are not the user's
    std::set<std::tuple<Rule, std::string, std::uint32_t>> said_;
    Diagnostics found_;
};

}  // namespace

Diagnostics check(const Plan& plan, Sources& sources, const glsl::IncludeReader& include) {
    return Checker(plan, sources, include).run();
}

}  // namespace snell::lint
