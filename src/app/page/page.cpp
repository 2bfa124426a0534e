#include "src/app/page/page.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/headless.h"
#include "src/app/open/quality.h"
#include "src/app/open/warnings.h"
#include "src/app/open/write_copy.h"
#include "src/app/picture/outputs.h"
#include "src/content/files.h"
#include "src/content/image/image.h"
#include "src/content/table.h"
#include "src/content/text_forms.h"
#include "src/plan/plan.h"
#include "src/plan/setup.h"
#include "src/plan/texts.h"

namespace snell::app {

namespace {

std::optional<gl::Caps> current_caps(std::unique_ptr<HeadlessContext>& context, const std::string& request) {
    if (!context) context = headless_context(request);
    if (!context || !context->make_current()) return std::nullopt;
    return gl::query_caps();
}

}  // namespace

std::optional<gl::Caps> PageContexts::web() {
    const auto caps = current_caps(web_, "es3.0");
    return caps ? std::optional(web_caps(*caps)) : std::nullopt;
}

std::optional<gl::Caps> PageContexts::native() { return current_caps(native_, ""); }

gl::Caps web_caps(gl::Caps caps) {
    caps.version = "WebGL 2";
    gl::leave_stages(caps);
    caps.fp64 = caps.program_interface_query = false;
    caps.max_line_width = 1;
    return caps;
}

OpenedScene opened_scene(const std::string& scene, const Start& start, const gl::Caps& caps, const Access& access) {
    OpenedScene opened;
    Diagnostics problems;
    const auto choose = [&](const Scene& read, Rungs& rungs) {
        choose_rungs(scene, {start.quality, start.ladders, {}}, access, read, rungs, problems);
    };
    // A browser has nobody who ends a picture that takes too long.
    const auto planned = [](const Plan& plan, Document& read) { read.diagnostics.append(too_many_rounds(plan, read)); };
    opened.document = open_document(scene, caps, choose, planned, {}, access);
    Document& document = *opened.document;
    if (document.runtime) {
        document.controls.rungs = document.runtime->rungs();
        for (const std::string& set : start.sets) set_control(document.controls, document.scene(), set, problems);
    }
    parse_view(start.view, opened.view);
    problems.append(document.diagnostics);
    Diagnostics shown;
    for (const Diagnostic& diagnostic : problems.items())
        if (diagnostic.severity != Severity::note) shown.add(diagnostic);
    opened.text = snell::render(shown, document.sources);
    const Diagnostic* const error = first_error(problems);
    opened.fits = !error;
    if (error) opened.first_error = short_text(*error, document.sources);
    return opened;
}

std::string short_text(const Diagnostic& error, const Sources& sources) {
    if (!error.has_span) return utf8::printable(error.message);
    const Position at = sources.position(error.span.file, error.span.begin);
    const std::string name = std::filesystem::path(sources.name(error.span.file)).filename().string();
    return utf8::printable(fmt::format("{}:{}:{}: {}", name, at.line, at.column, error.message));
}

StartTexts start_texts(const Document& document, const View& view) {
    const Setup changed = changed_setup(document.scene(), document.controls);
    return {set_arguments(document.scene(), document.controls), arguments_of(changed, ladder_option), view_text(view)};
}

namespace {

using Json = nlohmann::ordered_json;

std::string title_for(const std::string& scene, const std::string& title) {
    return utf8::printable(title.empty() ? std::filesystem::path(scene).stem().string() : title);
}

// `texts`: what differs from the scene's text.
Json scene_json(const std::string& scene, const std::string& title, const std::string& link, const StartTexts& texts) {
    Json json{{"scene", scene}, {"title", title}, {"values", texts.values}, {"rungs", texts.rungs}};
    json["view"] = texts.view;
    json["link"] = link;
    return json;
}

std::vector<std::pair<std::string, std::size_t>> sizes_of(const std::vector<PackedFile>& files) {
    std::vector<std::pair<std::string, std::size_t>> sizes;
    for (const PackedFile& file : files)
        if (!file.decoded) sizes.emplace_back(file.name, file.bytes.size());
    return sizes;
}

// What a browser lacks is told apart from what is wrong everywhere.
Exit report_unfit(const PageOptions& options, PageContexts& contexts, const OpenedScene& in_page,
                  const Access& access) {
    const auto caps = contexts.native();
    if (!caps) return exit_graphics;
    const OpenedScene native = opened_scene(options.scene, options.start, *caps, access);
    fmt::print(stderr, "{}", native.fits ? in_page.text : native.text);
    if (!native.fits) return exit_input;
    return complain(exit_input,
                    fmt::format("a browser cannot draw '{}': it has WebGL 2, which lacks what the errors above name",
                                options.scene));
}

void list_files(const PageOptions& options, const PageParts& parts, std::size_t bytes) {
    const std::size_t all = std::accumulate(parts.files.begin(), parts.files.end(), std::size_t{0},
                                            [](std::size_t sum, const auto& file) { return sum + file.second; });
    fmt::print("{}: {}. It redistributes {} {} ({}):\n", utf8::printable(options.output), size_text(bytes),
               parts.files.size(), parts.files.size() == 1 ? "file" : "files", size_text(all));
    for (const auto& [name, size] : parts.files) fmt::print("{:>10}  {}\n", size_text(size), name);
}

// The list must not follow a page in standard output.
bool has_room_for_list(const std::string& output) {
    std::error_code error;
    return std::filesystem::is_regular_file(output, error) &&
           !std::filesystem::equivalent(output, "/dev/stdout", error);
}

// Returns nullopt after it printed why there are none; `status` is then the exit status.
std::optional<PageParts> parts_of_page(const PageOptions& options, const Access& access, Deadline& deadline,
                                       Exit& status) {
    PageContexts contexts;
    const auto caps = contexts.web();
    status = exit_graphics;
    if (!caps) return std::nullopt;
    OpenedScene opened = opened_scene(options.scene, options.start, *caps, access);
    status = exit_input;
    if (opened.document->runtime) {
        const Diagnostics unfit = unfit_statements(*opened.document);
        opened.fits = opened.fits && unfit.empty();
        opened.text += snell::render(unfit, opened.document->sources);
    }
    if (!opened.fits) {
        opened.document.reset();
        status = report_unfit(options, contexts, opened, access);
        return std::nullopt;
    }
    deadline.begin(fmt::format("compiling the rungs of '{}'", options.scene));
    opened.text += unfit_rungs(*opened.document);
    fmt::print(stderr, "{}", opened.text);
    return page_parts(options.scene, options.title, options.link, opened, access);
}

namespace fs = std::filesystem;

// Puts `text` in the place of `mark`, if it occurs once; sets `good` to false otherwise.
void put(std::string& page, std::string_view mark, std::string_view text, bool& good) {
    const std::size_t at = page.find(mark);
    if (at == page.npos || page.find(mark, at + mark.size()) != page.npos)
        good = false;
    else
        page.replace(at, mark.size(), text);
}

std::string element(std::string_view begin, std::string_view text) { return fmt::format("{}{}</script>", begin, text); }

constexpr std::string_view scene_begin = R"(<script type="application/json" id="scene">)";
constexpr std::string_view archive_begin = R"(<script type="text/plain" id="archive">)";
constexpr std::string_view runtime_begin = R"(<script type="text/plain" id="runtime">)";

}  // namespace

std::string size_text(std::uintmax_t bytes) {
    const auto number = static_cast<double>(bytes);
    if (bytes < 1000) return fmt::format("{} B", bytes);
    return number < 1e6 ? fmt::format("{:.0f} kB", number / 1e3) : fmt::format("{:.1f} MB", number / 1e6);
}

Diagnostics unfit_statements(const Document& document) {
    Diagnostics found;
    for (const Draw& draw : document.scene().draws)
        if (std::holds_alternative<ShpFile>(draw.shape))
            found.add_once({Severity::error,
                            "page-shape-file",
                            draw.span,
                            "a page cannot read ESRI shape files",
                            "an .obj file of the same lines can be in a page",
                            {},
                            true});
    return found;
}

std::string unfit_rungs(Document& document) {
    const Scene& scene = document.scene();
    const Rungs begin = document.runtime->rungs();
    std::string text;
    for (std::size_t ladder = 0; ladder < scene.ladders.size(); ++ladder)
        for (std::size_t rung = 0; rung < scene.ladders[ladder].rungs.size(); ++rung) {
            Rungs rungs = begin;
            if (std::exchange(rungs[ladder], rung) == rung) continue;
            document.runtime->choose(rungs);
            const Diagnostic* const error = first_error(document.runtime->ladder_problems());
            if (!error) continue;
            text += fmt::format("snell: warning: with {}={} a browser cannot draw the scene: {}\n",
                                scene.ladders[ladder].name, scene.ladders[ladder].rungs[rung],
                                short_text(*error, document.sources));
        }
    document.runtime->choose(begin);
    return text;
}

PageParts page_parts(const std::string& scene, const std::string& title, const std::string& link,
                     const OpenedScene& opened, const Access& access) {
    const SceneFiles files = scene_files(scene, access);
    PageParts parts{title_for(scene, title), {}, {}, sizes_of(files.files), files.error};
    if (!parts.error.empty()) return parts;
    parts.scene = script_json(scene_json(files.scene, parts.title, link, start_texts(*opened.document, opened.view)));
    parts.archive = content::base64(gzipped(archive(files.files)));
    return parts;
}

Exit make_page(const PageOptions& options) {
    std::string error;
    const std::string page = web_file("page.html", error);
    if (!error.empty()) return complain(exit_input, error);
    Deadline deadline(options.timeout);
    deadline.begin(fmt::format("reading '{}'", options.scene));
    const Access access = access_to(options.scene, options.access, options.grade);
    std::vector<std::string> read = files_read_by(options.scene, access);
    read.push_back(options.scene);
    if (const Exit wrong = check_outputs(std::vector{options.output}, read); wrong != exit_fine) return wrong;
    Exit status = exit_fine;
    const std::optional<PageParts> parts = parts_of_page(options, access, deadline, status);
    if (!parts) return status;
    if (!parts->error.empty()) return complain(exit_input, parts->error);
    deadline.begin("writing the page");
    const auto text = filled_page(page, {parts->title, parts->scene, parts->archive});
    if (!text)
        return complain(exit_input, "the browser's part of snell is of another version",
                        "'./dev web' in the folder of snell's sources builds it again");
    if (!write_output(options.output, *text)) return exit_input;
    if (has_room_for_list(options.output)) list_files(options, *parts, text->size());
    return exit_fine;
}

std::string web_file(const std::string& name, std::string& error) {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
    const bool installed = !fs::exists(program / "../CMakeCache.txt", none);
    fs::path folder = program / (installed ? "../share/snell/web" : "../../web");
    if (const char* own = std::getenv("SNELL_WEB"); own && *own) folder = own;
    const fs::path file = (folder / name).lexically_normal();
    if (fs::is_regular_file(file, none)) return content::whole_file(file.string());
    error = fmt::format(
        "the browser's part of snell is not there: there is no '{}'\n   help: './dev web' in the folder of snell's "
        "sources builds it, before snell is installed",
        utf8::printable(file.string()));
    return {};
}

std::string script_json(const nlohmann::ordered_json& json) {
    std::string safe;
    for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return safe;
}

std::optional<std::string> filled_page(std::string_view page, const PageData& data) {
    std::string text(page);
    bool good = true;
    put(text, "<title>snell</title>", fmt::format("<title>{}</title>", content::escaped(data.title)), good);
    put(text, element(scene_begin, "null"), element(scene_begin, data.scene), good);
    put(text, element(archive_begin, ""), element(archive_begin, data.archive), good);
    return good ? std::optional(std::move(text)) : std::nullopt;
}

bool is_gallery_page(std::string_view page) {
    const auto has = [page](std::string_view part) { return page.find(part) != page.npos; };
    return has(scene_begin) && has(archive_begin) && !has(runtime_begin);
}

namespace {

struct Used {
    std::vector<std::string> paths;
    std::set<std::string> images;
    std::string error;
};

Used used_by(const std::string& scene, Files& files) {
    Sources sources;
    Diagnostics unheard(files.limits());  // these are reported when the scene is opened
    const auto plan = read_plan(scene, files, sources, unheard);
    if (!plan) return {{}, {}, fmt::format("cannot read '{}'", shown_path(scene))};
    Used used{used_files(*plan, sources, files), {}, {}};
    for (Index i = 0; i < plan->scene.textures.size(); ++i)
        for (std::string& path : texture_identity(plan->scene, i, files).files) used.images.insert(std::move(path));
    return used;
}

// The formats that a page decodes, exactly as snell does. Raw textures and TGA have no signature.
bool page_decodes(const std::string& path, std::string_view bytes) {
    using namespace std::string_view_literals;
    for (const std::string_view signature :
         {"\x89PNG"sv, "BM"sv, "\xff\xd8\xff"sv, "GIF8"sv, "8BPS"sv, "#?RADIANCE"sv, "#?RGBE"sv, "P5"sv, "P6"sv})
        if (bytes.starts_with(signature)) return true;
    const auto header = content::read_header(bytes, bytes.size());
    if (header) return header->format == "tex";
    return path.ends_with(".tga") || path.ends_with(".TGA");
}

// Nothing where snell does not decode it either, which a page reports in the same way.
std::optional<PackedFile> decoded(const PackedFile& file, const Limits& limits) {
    const content::ImageLimits most{static_cast<int>(limits.texture_side), limits.texture_bytes};
    const content::ImageResult read = content::decode_image(file.name, file.bytes, most);
    if (!read.image) return std::nullopt;
    const std::vector<std::byte> decoded = content::decoded_file(*read.image);
    return PackedFile{file.name, {reinterpret_cast<const char*>(decoded.data()), decoded.size()}, true};
}

std::string too_much(const std::vector<PackedFile>& files) {
    std::uint64_t bytes = 0;
    for (const PackedFile& file : files) bytes += file.bytes.size();
    if (bytes <= most_page_bytes && files.size() <= most_page_files) return {};
    return fmt::format("the scene reads {} files of {} MB: a page holds at most {} files of {} MB", files.size(),
                       bytes >> 20, most_page_files, most_page_bytes >> 20);
}

std::uint32_t number_at(std::string_view bytes, std::size_t at, int size) {
    std::uint32_t number = 0;
    for (int i = size; i-- > 0;)
        number = number << 8 | static_cast<unsigned char>(bytes[at + static_cast<unsigned>(i)]);
    return number;
}

// The pixels of a BMP image of 24 or 32 bits without compression: where they begin, and bytes of a pixel and of a row.
std::optional<std::array<std::size_t, 3>> bmp_rows(std::string_view bytes) {
    if (bytes.size() < 54 || !bytes.starts_with("BM")) return std::nullopt;
    const std::size_t begin = number_at(bytes, 10, 4), width = number_at(bytes, 18, 4), bits = number_at(bytes, 28, 2);
    const bool plain = (bits == 24 || bits == 32) && number_at(bytes, 30, 4) == 0;
    if (!plain || begin < 54 || begin > bytes.size() || width == 0 || width > bytes.size()) return std::nullopt;
    return std::array{begin, bits / 8, (width * bits + 31) / 32 * 4};
}

// Each byte of the pixels less what its neighbours foretell, as in PNG: that packs into half of the bytes, and
// web/page/archive.ts undoes it.
std::string without_foretold(std::string_view bytes, const std::array<std::size_t, 3>& rows) {
    const auto [begin, pixel, row] = rows;
    std::string rest(bytes);
    for (std::size_t i = begin; i < bytes.size(); ++i) {
        const auto before = [&](std::size_t distance) {
            return i < begin + distance ? 0 : static_cast<int>(static_cast<unsigned char>(bytes[i - distance]));
        };
        const int left = before(pixel), above = before(row), corner = before(row + pixel),
                  guess = left + above - corner;
        const int a = std::abs(guess - left), b = std::abs(guess - above), c = std::abs(guess - corner);
        rest[i] = static_cast<char>(bytes[i] - (a <= b && a <= c ? left : b <= c ? above : corner));
    }
    return rest;
}

}  // namespace

SceneFiles scene_files(const std::string& scene, const Access& access) {
    const std::string marked = marked_path(scene);
    Files files(scene_folder(marked), access);
    const Used used = used_by(marked, files);
    if (!used.error.empty()) return {{}, {}, used.error};
    CopyNames names = copy_names(marked, used.paths, "a page");
    SceneFiles found{names.scene, {}, names.error};
    for (const NamedFile& named : names.files) {
        if (!found.error.empty()) return found;
        std::string error;
        auto bytes = files.read(named.path, error);
        if (!bytes) {
            found.error = fmt::format("cannot read '{}': {}", shown_path(named.path), error);
            return found;
        }
        found.files.push_back({named.name, std::move(*bytes)});
        const PackedFile& file = found.files.back();
        if (used.images.contains(named.path) && !page_decodes(named.name, file.bytes))
            if (auto twin = decoded(file, access.limits)) found.files.push_back(std::move(*twin));
        found.error = too_much(found.files);
    }
    return found;
}

std::string archive(std::span<const PackedFile> files) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::string all;
    for (const PackedFile& file : files) {
        const auto rows = bmp_rows(file.bytes);
        list.push_back({{"name", file.name}, {"size", file.bytes.size()}, {"decoded", file.decoded}});
        if (rows) list.back()["rows"] = *rows;
        all += rows ? without_foretold(file.bytes, *rows) : file.bytes;
    }
    return nlohmann::ordered_json{{"files", list}}.dump() + '\n' + all;
}

std::string gzipped(std::string_view bytes) {
    constexpr int gzip = 16;  // added to the size of the window, it asks for the header of gzip
    // What is left of pixels has few repetitions: the best level looks for them six times as long, for a fiftieth.
    constexpr int level = 7;
    z_stream stream{};
    if (deflateInit2(&stream, level, Z_DEFLATED, MAX_WBITS + gzip, MAX_MEM_LEVEL, Z_FILTERED) != Z_OK)
        throw std::bad_alloc();
    gz_header header{};
    header.os = 255;  // not known: the bytes are the same on every system
    deflateSetHeader(&stream, &header);
    std::string packed(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

}  // namespace snell::app
