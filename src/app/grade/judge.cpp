#include "src/app/grade/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/timing.h"
#include "src/app/grade/rubric/table.h"
#include "src/app/grade/similarity.h"
#include "src/app/grade/submissions.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/picture/picture.h"
#include "src/content/files.h"
#include "src/content/image/image.h"
#include "src/content/replace.h"
#include "src/gl/target.h"
#include "src/lint/lint.h"
#include "src/plan/setup.h"
#include "src/plan/texts.h"
#include "src/runtime/inspect.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;
using accuracy::Picture;
using Kind = RubricItem::Kind;

std::string shown_as(const Shown& shown) {
    const std::string label = shown.label();
    return label.empty() ? "its picture" : fmt::format("the picture '{}'", label);
}

bool needs_pictures(const RubricItem& item) {
    return item.judges(Kind::picture) || item.judges(Kind::counters) || item.judges(Kind::time);
}

class Judging {
public:
    explicit Judging(const ToJudge& work) : work_(work), rubric_(*work.rubric), deadline_(rubric_.timeout) {
        record_ = unjudged(rubric_, "judging ended before");
        record_.problem.clear();
        record_.key = work.key;
    }

    Exit run() {
        deadline_.begin("reading the submission");
        if (!enter()) return keep();
        if (!work_.reference.empty()) reference_ = read_record(work_.reference, rubric_);
        context_ = headless_context("");
        if (!context_) return exit_graphics;
        caps_ = gl::query_caps();
        if (!open()) return keep();
        keep();  // what follows may end the process
        draw_pictures();
        judge_items();
        return keep();
    }

private:
    Exit keep() {
        const std::string wrong = write_record(work_.output, record_);
        return wrong.empty() ? exit_fine : complain(exit_input, "cannot write the record: " + wrong);
    }

    bool fail(const std::string& why) {
        std::vector<std::string> notes = std::move(record_.notes);
        record_ = unjudged(rubric_, why);
        record_.notes = std::move(notes);
        record_.key = work_.key;
        return false;
    }

    void unpack_into(const std::string& archive, const std::string& folder) {
        std::error_code error;
        fs::create_directories(folder, error);
        const Unpacked unpacked = unpack(archive, folder);
        const std::string name = utf8::printable(fs::path(archive).filename().string());
        for (const std::string& note : unpacked.notes) record_.notes.push_back(fmt::format("{}: {}", name, note));
        if (!unpacked.error.empty())
            broken_ +=
                fmt::format("{}{} was not unpacked to its end: {}", broken_.empty() ? "" : "; ", name, unpacked.error);
    }

    // Finds the scene, and makes the submission's folder the working directory.
    bool enter() {
        std::error_code error;
        const fs::path unpacked = fs::path(work_.unpacked) / "all", inner = fs::path(work_.unpacked) / "archives";
        access_.limits = work_.limits;
        access_.allow = rubric_.shared;
        FoundScene found;
        if (fs::is_regular_file(work_.path, error) && !is_archive(work_.path)) {
            found.folder = fs::path(work_.path).parent_path().string();
            found.scene = fs::path(work_.path).filename().string();
        } else {
            std::string folder = work_.path;
            if (fs::is_regular_file(work_.path, error)) unpack_into(work_.path, folder = unpacked.string());
            found = scene_in({folder});
            // Learning platforms put an archive into a folder with the student's name. Each is a folder of its name.
            constexpr std::size_t most = 4;
            const std::vector<std::string> archives = found.archives;
            if (archives.size() > most)
                record_.notes.push_back(fmt::format("only {} of {} archives are unpacked", most, archives.size()));
            for (std::size_t i = 0; i < std::min(archives.size(), most); ++i)
                unpack_into(archives[i], (inner / fs::path(archives[i]).lexically_relative(folder)).string());
            if (!archives.empty()) found = scene_in({folder, inner.string()});
        }
        if (!found.several.empty())
            found.error += fmt::format("; the rubric settles it by a line below [scenes]: {} = {}",
                                       toml_text(work_.name), toml_text(found.several.front()));
        if (!found.error.empty()) return fail(broken_.empty() ? found.error : broken_ + "; " + found.error);
        if (!found.reason.empty()) record_.notes.push_back(found.reason);
        if (!broken_.empty()) record_.notes.push_back(broken_);
        fs::current_path(found.folder, error);
        if (error) return fail("cannot read its folder: " + error.message());
        record_.scene = found.scene;
        access_.confine = fs::current_path(error).string();
        if (work_.path == rubric_.reference) access_.confine.reset();  // the lecturer's own
        return true;
    }

    FoundScene scene_in(const std::vector<std::string>& folders) const {
        const auto uniforms = [&](const std::string& folder, const std::string& name) {
            const std::string path = (fs::path(folder) / name).string();
            Access access = access_;
            access.confine = folder;
            Files files(scene_folder(path), access);
            Sources sources;
            Diagnostics unheard(access.limits);
            const auto parsed = parse_document(path, files, sources, unheard);
            return parsed ? uniforms_of(parsed->scene, rubric_) : std::set<std::string>();
        };
        return find_scene(folders,
                          {rubric_.scene, fs::path(rubric_.reference).filename().string(), work_.scene, uniforms});
    }

    bool open() {
        const auto planned = [this](const Plan& plan, Document& document) {
            Diagnostics found = lint::check(plan, document.sources, shader_includes(*document.files));
            for (Diagnostic diagnostic : found.items()) {
                if (lint::never_ends(diagnostic)) {
                    diagnostic.severity = Severity::error;
                    leave_out(plan, document.sources, diagnostic.span.file);
                }
                document.diagnostics.add(std::move(diagnostic));
            }
            Files reader(document.files->folder(), access_);
            for (const PlannedProgram& program : plan.programs) {
                for (const auto& [path, text] : shader_texts(program, document.sources, reader))
                    add_prints(record_, path, text);
            }
        };
        document_ = open_document(record_.scene, caps_, nullptr, planned, {}, access_);
        // Whether the driver or snell asks for what is too much depends on what else was asked for.
        const bool refused =
            ranges::count(document_->diagnostics.items(), "out-of-graphics-memory", &Diagnostic::code) > 0;
        if (refused && std::isfinite(address_space())) out_of_memory();
        const bool sliders = std::any_of(rubric_.items.begin(), rubric_.items.end(), [](const RubricItem& item) {
            return ranges::any_of(item.parts(), [](const RubricItem* part) {
                return part->kind == Kind::no_lints && ranges::count(part->names, "slider-without-effect") > 0;
            });
        });
        if (sliders) add_idle_sliders(*document_, std::min(rubric_.timeout / 10, 2.));
        record_.messages = render(document_->diagnostics, document_->sources);
        record_.errors = document_->diagnostics.errors();
        record_.warnings = document_->diagnostics.warnings();
        find_first_error();
        if (!document_->runtime) {
            const std::string messages = record_.messages;
            fail("its scene cannot be read" + (first_error_.empty() ? "" : ": " + first_error_));
            record_.messages = messages;
            return false;
        }
        commands_ = used_commands(record_.scene, access_);
        judge_items();
        return true;
    }

    // A shader that never ends counts as one with an error: nothing is drawn with it.
    void leave_out(const Plan& plan, const Sources& sources, FileId file) {
        const auto reads = [&](Index program) {
            return ranges::any_of(plan.programs[program].stages, [&](const glsl::StageInput& stage) {
                return sources.name(stage.file) == sources.name(file);
            });
        };
        bool named = false;  // otherwise a shader includes it
        for (Index program = 0; program < plan.programs.size(); ++program) named = named || reads(program);
        endless_.resize(plan.scene.draws.size());
        for (std::size_t draw = 0; draw < endless_.size(); ++draw)
            endless_[draw] = endless_[draw] || !named || reads(plan.scene.draws[draw].program);
    }

    // What an error takes out of the scene, so that items are not fulfilled by what is not there.
    void find_first_error() {
        const Diagnostic* const error = first_error(document_->diagnostics);
        if (!error) return;
        const Finding finding = describe(*error, document_->sources);
        const std::string place = place_text(finding);
        first_error_ = (place.empty() ? "" : place + ": ") + finding.message;
        if (!document_->runtime) return;
        left_out_ = !endless_.empty();
        unread_ =
            left_out_ || ranges::any_of(document_->runtime->active_uniforms(), &std::vector<ActiveUniform>::empty);
        for (const Explanation::Paid& paid : document_->runtime->explain().paid)
            if (paid.kind == Explanation::Kind::pass)
                left_out_ = left_out_ || ranges::count(document_->scene().passes[paid.pass].items, Item::Kind::draw,
                                                       &Item::kind) > static_cast<std::ptrdiff_t>(paid.draws.size());
    }

    void draw_pictures() {
        pictures_.resize(rubric_.pictures.size());
        Runtime& runtime = *document_->runtime;
        const gl::Target target =
            gl::make_target(rubric_.width, rubric_.height, rubric_.samples, runtime.display_pixels());
        if (target.framebuffer) draw_nothing(target);
        for (std::size_t i = 0; i < pictures_.size(); ++i) {
            if (!target.framebuffer) pictures_[i].wrong = "this OpenGL gives no picture of this size";
            if (target.framebuffer) draw(i, target);
        }
        drawn_ = static_cast<bool>(target.framebuffer);
        if (target.framebuffer && (rubric_.judges(Kind::time))) measure_time(target);
    }

    void draw(std::size_t index, const gl::Target& target) {
        const Shown& shown = rubric_.pictures[index];
        Controls controls = document_->controls;
        Diagnostics wrong;
        for (const std::string& set : shown.sets)
            set_control(controls, document_->scene(), with_aliases(set, rubric_, *document_), wrong);
        if (wrong.has_errors()) {
            const Diagnostic& first = wrong.items().front();
            pictures_[index].wrong = first.message + (first.help.empty() ? "" : " (" + first.help + ")");
            return;
        }
        View view;
        parse_view(shown.view, view);
        deadline_.begin(shown_as(shown));
        Frame frame{.time = shown.time, .view = view, .controls = controls, .hidden = &endless_};
        const content::Image image = image_of(frame, target);
        if (index == 0) counters_ = document_->runtime->counters();
        pictures_[index].picture = accuracy::displayed_picture(image, false);
        record_.drawn[index] = fmt::format("picture-{}.png", index);
        write(record_.drawn[index], content::encode_png(image));
        frame.standing = true;
        deadline_.begin("looking for NaN in " + shown_as(shown));
        find_covered(index, frame, target);
    }

    content::Image image_of(const Frame& frame, const gl::Target& target) {
        return draw_picture(*document_->runtime, frame, target, {.width = rubric_.width, .height = rubric_.height}, {});
    }

    // What pictures show where nothing is drawn: the scene's background, and the one that tells what has its colour.
    void draw_nothing(const gl::Target& target) {
        for (std::size_t c = 0; c < 3; ++c) other_background_[c] = document_->scene().background[c] < .5 ? 1 : 0;
        const std::vector<bool> all(document_->scene().draws.size(), true);
        const View view;
        Frame frame{.view = view, .controls = document_->controls, .hidden = &all};
        deadline_.begin("the background");
        background_ = accuracy::displayed_picture(image_of(frame, target), false);
        frame.background = other_background_;
        other_ = accuracy::displayed_picture(image_of(frame, target), false);
    }

    // A pixel is seen if it is another one than the background. It is covered if it is seen, or stays when the
    // background is another one. NaN is neither.
    void find_covered(std::size_t index, Frame frame, const gl::Target& target) {
        constexpr auto step = static_cast<float>(accuracy::one_step);
        const Shown& shown = rubric_.pictures[index];
        accuracy::Region& covered = pictures_[index].covered =
            accuracy::where_different(*pictures_[index].picture, background_, step);
        FloatPicture floats;
        std::vector<float> rgba;
        std::vector<std::size_t> undefined;
        if (floats.resize(rubric_.width, rubric_.height)) floats.draw(*document_->runtime, frame, rgba);
        for (std::size_t i = 0; 4 * i < rgba.size(); ++i)
            if (flag_of(std::span<const float, 4>(&rgba[4 * i], 4)) == Flag::nan) undefined.push_back(i);
        if (!rgba.empty()) pictures_[index].infinite = count_flags(rgba)[Flag::infinite];
        if (!undefined.empty())
            pictures_[index].wrong =
                fmt::format("{} of {} {} NaN, whose colour is undefined", counted(undefined.size(), "pixel"),
                            shown_as(shown), undefined.size() == 1 ? "is" : "are");
        for (const std::size_t i : undefined) covered[i] = 0;
        seen_ += accuracy::count(covered);
        if (accuracy::count(covered) < covered.size()) {
            frame.background = other_background_;
            const Picture picture = accuracy::displayed_picture(image_of(frame, target), false);
            const accuracy::Region stays = accuracy::where_different(picture, other_, step);
            for (std::size_t i = 0; i < covered.size(); ++i) covered[i] |= stays[i];
            for (const std::size_t i : undefined) covered[i] = 0;
        }
        const auto share = [&](const accuracy::Region& region) {
            return static_cast<double>(accuracy::count(region)) / static_cast<double>(region.size());
        };
        record_.covered[index] = share(covered);
        accuracy::Region shape = shape_of(*pictures_[index].picture, covered);
        for (const std::size_t i : undefined) shape[i] = 0;
        record_.shaped[index] = share(shape);
        pictures_[index].has_area = has_area(shape);
    }

    // What stands out of a picture: the pixels that have another colour than most, or are covered where most are not.
    // A picture that has one colour shows nothing, whichever it is.
    accuracy::Region shape_of(const Picture& picture, const accuracy::Region& covered) const {
        using Look = std::array<int, 5>;
        const auto look = [&](std::size_t i) {
            Look one{covered[i] ? 1 : 0};
            for (std::size_t c = 0; c < 4; ++c)
                one[c + 1] = static_cast<int>(std::lround(255 * std::clamp(picture.rgba[4 * i + c], 0.F, 1.F)));
            return one;
        };
        std::map<Look, std::size_t> counts;
        for (std::size_t i = 0; i < covered.size(); ++i) ++counts[look(i)];
        const Look most = ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })->first;
        accuracy::Region shape(covered.size(), 0);
        for (std::size_t i = 0; i < covered.size(); ++i) {
            const Look one = look(i);
            bool other = one[0] != most[0];
            for (std::size_t c = 1; c < 5; ++c) other = other || std::abs(one[c] - most[c]) > 1;
            shape[i] = other ? 1 : 0;
        }
        return shape;
    }

    // Whether a pixel and all that are around it are in the region: points and lines have none.
    bool has_area(const accuracy::Region& region) const {
        const auto width = static_cast<std::size_t>(rubric_.width), height = static_cast<std::size_t>(rubric_.height);
        for (std::size_t y = 1; y + 1 < height; ++y)
            for (std::size_t x = 1; x + 1 < width; ++x) {
                bool all = true;
                for (std::size_t k = 0; k < 9; ++k) all = all && region[(y + k / 3 - 1) * width + x + k % 3 - 1];
                if (all) return true;
            }
        return false;
    }

    void write(const std::string& name, const std::string& bytes) {
        const std::string wrong = content::replace_file((fs::path(work_.output) / name).string(), bytes);
        if (!wrong.empty()) record_.notes.push_back(fmt::format("'{}' cannot be written: {}", name, wrong));
    }

    void measure_time(const gl::Target& target) {
        // Some systems count a processor's time in steps of 10 ms, so single frames are not timed.
        constexpr double enough = 150;
        const View view;
        const accuracy::FrameClock clock(caps_.software);
        const accuracy::Times times = clock.sample(
            [&] {
                deadline_.begin("a frame whose time is measured");
                image_of({.view = view, .controls = document_->controls, .hidden = &endless_}, target);
            },
            enough);
        record_.milliseconds = chosen(times, clock.plain());
    }

    // The reference's own picture, which is copied so that the folder can be handed back.
    std::optional<Picture> reference_picture(std::size_t index) {
        if (work_.reference.empty()) return pictures_[index].picture;
        const std::string name = fmt::format("picture-{}.png", index);
        const std::string bytes = content::whole_file((fs::path(work_.reference) / name).string());
        const auto decoded = content::decode_image(name, bytes);
        if (!decoded.image) return std::nullopt;
        write(fmt::format("reference-{}.png", index), bytes);
        return accuracy::displayed_picture(*decoded.image, false);
    }

    // Why an item earns nothing, whatever it judges: nothing earns nothing, and what an error took away fulfils
    // nothing; or "".
    std::string barred(const RubricItem& item) const {
        if (drawn_ && !item.deducts && all_empty()) return nothing(seen_ > 0) + " is seen in any of its pictures";
        if (item.kind == Kind::no_lints && unread_) return "not all shaders can be read";
        if (item.kind == Kind::uniforms && !endless_.empty()) return "not all shaders can be read";
        if (!needs_pictures(item)) return {};
        const bool relation = item.kind == Kind::picture, against = relation && item.expect == Expect::reference;
        for (const std::size_t index : {item.picture, against ? item.picture : item.than}) {
            if (!pictures_[index].wrong.empty() && (relation || !drawn_)) return pictures_[index].wrong;
            const std::size_t of_reference = against ? item.than : index;
            if (is_empty(index, of_reference) || (relation && is_plain(index, of_reference)))
                return nothing(record_.covered[index] > 0) + " is seen in " + shown_as(rubric_.pictures[index]);
        }
        const bool same = relation && (item.expect == Expect::same || item.expect == Expect::mirrored);
        if (same && !first_error_.empty()) return "with an error, it proves nothing that pictures are alike";
        if (left_out_ && (!relation || against || item.expect == Expect::finite)) return "the error leaves out a draw";
        return same ? unused(item) : "";
    }

    static std::string nothing(bool hardly) { return hardly ? "hardly anything" : "nothing"; }

    // Points and lines are as good as nothing if they are far less than what the reference's picture covers. A small
    // thing with an area is something.
    bool is_empty(std::size_t picture, std::size_t of_reference) const {
        if (work_.path == rubric_.reference) return false;
        const double own = record_.covered[picture];
        if (reference_.covered.empty()) return own == 0;
        return own < reference_.covered[of_reference] / 50 && (own == 0 || !pictures_[picture].has_area);
    }

    // The same of what stands out, where the whole picture may be covered: a single colour is as good as nothing.
    bool is_plain(std::size_t picture, std::size_t of_reference) const {
        return work_.path != rubric_.reference && !reference_.shaped.empty() && !pictures_[picture].has_area &&
               record_.shaped[picture] < reference_.shaped[of_reference] / 50;
    }

    bool all_empty() const {
        std::size_t empty = 0;
        for (std::size_t i = 0; i < pictures_.size(); ++i) empty += record_.covered[i] == 0 || is_empty(i, i);
        return seen_ == 0 || empty == pictures_.size();
    }

    // That a uniform does not matter is no merit if nothing reads it.
    std::string unused(const RubricItem& item) const {
        for (const std::size_t index : {item.picture, item.than})
            for (const std::string& set : rubric_.pictures[index].sets) {
                const std::string own = with_aliases(set, rubric_, *document_);
                const std::string name = own.substr(0, own.find('='));
                const auto reads = [&](const snell::Control& control) {
                    return control.active && (control.name == name || name.ends_with("." + control.name));
                };
                if (ranges::none_of(document_->controls.items, reads))
                    return fmt::format("no shader uses '{}', so that it can't matter", name);
            }
        return {};
    }

    Judged judge_picture(const RubricItem& item) {
        const Picture& picture = *pictures_[item.picture].picture;
        if (item.expect == Expect::finite) return judge_finite(item);
        const bool against = item.expect == Expect::reference;
        const auto other = against ? reference_picture(item.than) : pictures_[item.than].picture;
        if (!other) return {0, false, "the reference has no such picture"};
        const Picture compared = item.expect == Expect::mirrored ? accuracy::mirrored(*other) : *other;
        const accuracy::PictureDifference difference =
            accuracy::picture_difference(picture, compared, accuracy::one_step, against);
        if (against) {
            record_.maps[item.map] = fmt::format("map-{}.png", item.map);
            write(record_.maps[item.map],
                  content::encode_png(accuracy::map_image(difference.map, picture.width, picture.height)));
        }
        accuracy::Region covered = pictures_[item.picture].covered;
        for (std::size_t i = 0; i < covered.size() && !against; ++i) covered[i] |= pictures_[item.than].covered[i];
        const auto share = static_cast<double>(accuracy::count(covered)) / static_cast<double>(covered.size());
        return judge_relation(item, picture, compared, difference, share);
    }

    // A picture with NaN does not come here.
    Judged judge_finite(const RubricItem& item) const {
        const std::optional<std::size_t> infinite = pictures_[item.picture].infinite;
        if (!infinite) return {0, false, "this OpenGL does not tell which pixels are finite"};
        return {0, *infinite == 0,
                *infinite == 0
                    ? "no pixel is NaN or infinite"
                    : fmt::format("{} {} infinite", counted(*infinite, "pixel"), *infinite == 1 ? "is" : "are")};
    }

    Judged judge_time(const RubricItem& item) const {
        const double reference = work_.reference.empty() ? record_.milliseconds : work_.reference_milliseconds;
        if (record_.milliseconds == 0 || reference == 0) return {0, false, "there is no time to compare"};
        const double ratio = record_.milliseconds / reference;
        return {0, ratio <= item.ratio,
                fmt::format("a frame takes {:.3g} ms, {:.3g} times the reference's {:.3g} ms; allowed: {:.3g} times",
                            record_.milliseconds, ratio, reference, item.ratio)};
    }

    // Of alternatives, the best. The cause first.
    Judged judge_item(const RubricItem& item) {
        Judged best;
        bool caused = false;
        for (const RubricItem* part : item.parts()) {
            Judged judged = judge_part(*part, caused);
            if (judged.passed) return judged;
            best.points = std::max(best.points, judged.points);
            best.why += (best.why.empty() ? "" : "; or: ") + judged.why;
        }
        if (caused && !first_error_.empty()) best.why = first_error_ + "; " + best.why;
        return best;
    }

    // `caused`: it may have failed because of an error.
    Judged judge_part(const RubricItem& item, bool& caused) {
        const std::string bar = barred(item);
        Judged judged{0, false, bar};
        if (bar.empty()) {
            judged = item.kind == Kind::picture    ? judge_picture(item)
                     : item.kind == Kind::counters ? judge_counters(item, counters_)
                     : item.kind == Kind::time     ? judge_time(item)
                     : item.kind == Kind::named    ? judge_name(item)
                     : item.kind == Kind::except   ? judge_list(item)
                                                   : judge_text(item, rubric_, *document_, commands_);
            if (needs_pictures(item)) judged.points = judged.passed ? item.points : 0;
        }
        const bool own = item.kind == Kind::forbids || item.kind == Kind::no_lints || item.kind == Kind::named ||
                         item.kind == Kind::except;  // so with or without one
        caused = caused || !bar.empty() || !own;
        return judged;
    }

    Judged judge_name(const RubricItem& item) const {
        const std::string name = fs::path(record_.scene).filename().string();
        const bool right = fits_pattern(name, item.names.front());
        return {right ? item.points : 0, right,
                fmt::format("the scene is called {}{}", utf8::printable(name),
                            right ? "" : fmt::format(", not {}", item.names.front()))};
    }

    Judged judge_list(const RubricItem& item) const {
        const bool listed = !work_.name.empty() && ranges::any_of(item.names, [&](const std::string& pattern) {
            return fits_pattern(work_.name, pattern, true);
        });
        return {listed ? 0 : item.points, !listed,
                listed ? "it is on the rubric's list" : "it is not on the rubric's list"};
    }

    // Before pictures are drawn, which may end the process: what needs none.
    void judge_items() {
        for (std::size_t i = 0; i < rubric_.items.size(); ++i) {
            if (needs_pictures(rubric_.items[i]) && pictures_.empty()) continue;
            deadline_.begin(fmt::format("judging '{}'", rubric_.items[i].name));
            record_.items[i] = judge_item(rubric_.items[i]);
            if (rubric_.items[i].deducts) record_.items[i].points -= rubric_.items[i].points;
        }
    }

    // A picture of the rubric.
    struct Drawn {
        std::optional<Picture> picture;
        std::string wrong;  // why there is none, or it does not count
        accuracy::Region covered;
        std::optional<std::size_t> infinite;  // pixels; nullopt: not known
        bool has_area = false;                // what stands out of it
    };

    const ToJudge& work_;
    const Rubric& rubric_;
    Deadline deadline_;
    Access access_;
    Record record_;
    std::string broken_;  // why archives were not unpacked to their ends
    std::unique_ptr<HeadlessContext> context_;
    gl::Caps caps_;
    std::unique_ptr<Document> document_;
    std::vector<Drawn> pictures_;
    Picture background_, other_;
    Vec4 other_background_{0, 0, 0, 1};
    std::size_t seen_ = 0;  // pixels, in all pictures
    bool drawn_ = false;
    Counters counters_;
    Record reference_;  // if there is one, and this is not it
    UsedCommands commands_;
    std::string first_error_;                 // with its place; "": there is none
    bool unread_ = false, left_out_ = false;  // by an error: a shader, a draw of what the window shows
    std::vector<bool> endless_;               // by Scene::draws: those of shaders that never end; empty: there are none
};

}  // namespace

Exit judge(const ToJudge& work) { return Judging(work).run(); }

namespace {

using accuracy::PictureDifference;

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

Judged light(const RubricItem& item, const Picture& picture, const Picture& other) {
    const double now = accuracy::mean_light(picture), before = accuracy::mean_light(other);
    const bool darker = item.expect == Expect::darker;
    Judged judged;
    judged.passed =
        darker ? now <= before * (1 - item.by) && now < before : now >= before * (1 + item.by) && now > before;
    const double change = before > 0 ? now / before - 1 : 0;
    judged.why = fmt::format("its mean light is {:.4g}, against {:.4g}", now, before);
    if (before > 0 && now != before)
        judged.why += fmt::format(": {} {}", percent(std::abs(change)), change < 0 ? "less" : "more");
    if (!judged.passed)
        judged.why += fmt::format("; expected: at least {} {}", percent(item.by), darker ? "less" : "more");
    return judged;
}

Judged changed(const RubricItem& item, double share, double covered) {
    Judged judged;
    const bool same = item.expect != Expect::different;
    if (!same && covered > 0) share = std::min(1., share / covered);
    judged.passed = same ? share <= item.by : share >= item.by && share > 0;
    judged.why = fmt::format("{} of the pixels{} differ", percent(share), same ? "" : " that are drawn on");
    if (!judged.passed) judged.why += fmt::format("; expected: at {} {}", same ? "most" : "least", percent(item.by));
    return judged;
}

void hold(Judged& judged, std::string_view what, double value, const std::optional<double>& limit,
          std::string_view unit) {
    if (!limit) return;
    const bool good = value <= *limit;
    judged.passed = judged.passed && good;
    judged.why += fmt::format("{}{} {:.4g}{}, at most {:.4g}{}{}", judged.why.empty() ? "" : "; ", what, value, unit,
                              *limit, unit, good ? "" : " allowed");
}

Judged near_reference(const RubricItem& item, const PictureDifference& difference) {
    Judged judged{0, true, {}};
    hold(judged, "RMSE", difference.error.display.rmse, item.max_rmse, "");
    hold(judged, "FLIP", difference.flip, item.max_flip, "");
    hold(judged, "different pixels", 100 * difference.share, item.max_pixels, " %");
    judged.why = "distance to the reference: " + judged.why;
    return judged;
}

}  // namespace

Judged judge_relation(const RubricItem& item, const Picture& picture, const Picture& other,
                      const PictureDifference& difference, double covered) {
    if (item.expect == Expect::reference) return near_reference(item, difference);
    const bool alike = item.expect == Expect::same || item.expect == Expect::mirrored;
    if (alike && accuracy::uniform(picture) && accuracy::uniform(other))
        return {0, false, "all pixels of both pictures have one colour, so that nothing is the same"};
    if (item.expect == Expect::darker || item.expect == Expect::brighter) return light(item, picture, other);
    return changed(item, difference.share, covered);
}

}  // namespace snell::app
