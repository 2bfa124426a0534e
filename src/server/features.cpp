
#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/content/text_forms.h"
#include "src/language/project.h"
#include "src/language/services.h"
#include "src/plan/values/write_back.h"
#include "src/server/server.h"
#include "src/server/state.h"

namespace snell::server {

// Encodes what is said of the texts of one project.
class Encoder {
public:
    Encoder(const State& state, const language::Project& project) : state_(state), project_(project) {}

    const Lines& lines(FileId file) const;
    Json range(const Span& span) const { return range_json(lines(span.file), span, state_.encoding); }
    // Empty: the text is not the user's, and there is nothing to open.
    std::string uri(FileId file) const;

    Json locations(const std::vector<Span>& spans) const;
    Json edits(const std::vector<Edit>& edits) const;           // of one text
    Json workspace_edit(const std::vector<Edit>& edits) const;  // of several
    Json completions(const std::vector<language::Completion>& items) const;
    Json hover(const language::Hover& hover) const;
    Json signatures(const language::SignatureHelp& help) const;
    // As texts, because there may be many.
    std::string symbols(const std::vector<language::Symbol>& symbols) const;
    std::string colors(const std::vector<language::Color>& colors) const;

private:
    void add_range(std::string& text, const Span& span) const;
    void add_symbols(std::string& text, const std::vector<language::Symbol>& symbols) const;

    const State& state_;
    const language::Project& project_;
    mutable std::map<FileId, Lines> lines_;
};

using namespace language;

const Lines& Encoder::lines(FileId file) const {
    return lines_.try_emplace(file, project_.sources.text(file)).first->second;
}

std::string Encoder::uri(FileId file) const {
    const std::string path(project_.path_of(file));
    if (path.empty()) return {};
    const Document* document = state_.documents.with_path(path);
    return document ? document->uri : content::uri_of_path(real_path(path));
}

Json Encoder::locations(const std::vector<Span>& spans) const {
    Json all = Json::array();
    for (const Span& span : spans)
        if (std::string at = uri(span.file); !at.empty())
            all.push_back({{"uri", std::move(at)}, {"range", range(span)}});
    return all;
}

Json Encoder::edits(const std::vector<Edit>& edits) const {
    Json all = Json::array();
    for (const Edit& edit : edits) all.push_back({{"range", range(edit.span)}, {"newText", edit.text}});
    return all;
}

Json Encoder::workspace_edit(const std::vector<Edit>& all) const {
    Json changes = Json::object();
    for (const Edit& edit : all)
        if (const std::string at = uri(edit.span.file); !at.empty()) {
            const auto open = state_.documents.all().find(at);
            if (open != state_.documents.all().end() && open->second.lost) throw State::lost(open->second);
            changes[at].push_back({{"range", range(edit.span)}, {"newText", edit.text}});
        }
    return {{"changes", std::move(changes)}};
}

namespace {

Json markdown(const std::string& text) { return {{"kind", "markdown"}, {"value", text}}; }

// CompletionItemKind, in the order of Completion::Kind.
constexpr std::array completion_kinds{3, 20, 12, 17, 19, 10, 9, 3, 6, 21, 7, 14, 5};
// SymbolKind, in the order of Symbol::Kind.
constexpr std::array symbol_kinds{3, 5, 7, 10, 22, 19, 20, 17, 12, 13, 14, 23, 8, 21};

// A snippet for editors that know none: of a choice, the first.
std::string plain_text(const std::string& snippet) {
    std::string plain;
    for (std::size_t i = 0; i < snippet.size(); ++i) {
        if (snippet[i] == '\\' && i + 1 < snippet.size()) {
            plain += snippet[++i];
        } else if (snippet[i] == '$' && snippet.compare(i, 2, "${") == 0) {
            const std::size_t mark = snippet.find_first_of(":|}", i), end = snippet.find('}', i);
            if (end == snippet.npos) break;
            const std::size_t last = snippet[mark] == '|' ? snippet.find_first_of(",|", mark + 1) : end;
            if (mark < end) plain += snippet.substr(mark + 1, last - mark - 1);
            i = end;
        } else if (snippet[i] == '$') {
            while (i + 1 < snippet.size() && snippet[i + 1] >= '0' && snippet[i + 1] <= '9') ++i;
        } else {
            plain += snippet[i];
        }
    }
    return plain;
}

// A string of JSON.
void add_quoted(std::string& out, std::string_view text) {
    const auto plain = [](char c) { return c >= ' ' && c < 127 && c != '"' && c != '\\'; };
    if (ranges::all_of(text, plain))
        out.append(1, '"').append(text).append(1, '"');
    else
        out += text_of(Json(text));
}

// Elements with commas between them, in brackets.
template <class Elements, class Add>
void add_list(std::string& out, const Elements& elements, Add&& add) {
    out += '[';
    bool first = true;
    for (const auto& element : elements) {
        if (!std::exchange(first, false)) out += ',';
        add(element);
    }
    out += ']';
}

}  // namespace

Json Encoder::completions(const std::vector<Completion>& items) const {
    const bool snippets = state_.can("/textDocument/completion/completionItem/snippetSupport");
    Json all = Json::array();
    for (const Completion& item : items) {
        const bool snippet = item.snippet && snippets;
        Json json{{"label", item.label},
                  {"kind", completion_kinds[static_cast<std::size_t>(item.kind)]},
                  {"sortText", fmt::format("{:02}{}", item.rank, item.label)},
                  {"filterText", item.label},
                  {"insertTextFormat", snippet ? 2 : 1},
                  {"textEdit",
                   {{"range", range(item.replaced)},
                    {"newText", item.snippet && !snippets ? plain_text(item.text) : item.text}}}};
        if (!item.detail.empty()) json["detail"] = item.detail;
        if (!item.documentation.empty()) json["documentation"] = markdown(item.documentation);
        if (!item.also.empty()) json["additionalTextEdits"] = edits(item.also);
        if (item.more)
            json["command"] = {{"title", "Names in the folder"}, {"command", "editor.action.triggerSuggest"}};
        all.push_back(std::move(json));
    }
    return {{"isIncomplete", false}, {"items", std::move(all)}};
}

Json Encoder::hover(const Hover& hover) const {
    std::string text = hover.documentation;
    std::string picture = hover.picture;
    if (!picture.empty() && !picture.starts_with('/'))
        picture = state_.services.doc_file ? state_.services.doc_file(picture) : "";
    if (!picture.empty()) text += fmt::format("\n\n![]({})", content::uri_of_path(picture));
    return {{"contents", markdown(text)}, {"range", range(hover.span)}};
}

Json Encoder::signatures(const SignatureHelp& help) const {
    Json all = Json::array();
    for (const Signature& signature : help.signatures) {
        const Lines label(signature.label);
        Json parameters = Json::array();
        for (const auto& [begin, end] : signature.parameters)
            parameters.push_back(
                {{"label",
                  {label.place(begin, Encoding::utf16).character, label.place(end, Encoding::utf16).character}}});
        all.push_back({{"label", signature.label},
                       {"documentation", markdown(signature.documentation)},
                       {"parameters", std::move(parameters)}});
    }
    return {{"signatures", std::move(all)}, {"activeSignature", help.signature}, {"activeParameter", help.parameter}};
}

void Encoder::add_range(std::string& out, const Span& span) const {
    const Lines& text = lines(span.file);
    const Place begin = text.place(span.begin, state_.encoding);
    const Place end = text.place(std::max(span.begin, span.end), state_.encoding);
    out += fmt::format(R"({{"start":{{"line":{},"character":{}}},"end":{{"line":{},"character":{}}}}})", begin.line,
                       begin.character, end.line, end.character);
}

void Encoder::add_symbols(std::string& out, const std::vector<Symbol>& symbols) const {
    add_list(out, symbols, [&](const Symbol& symbol) {
        out += R"({"name":)";
        add_quoted(out, symbol.name.empty() ? "?" : symbol.name);
        out += fmt::format(R"(,"kind":{},"range":)", symbol_kinds[static_cast<std::size_t>(symbol.kind)]);
        add_range(out, symbol.span);
        out += R"(,"selectionRange":)";
        add_range(out, symbol.name_span);
        if (!symbol.detail.empty()) {
            out += R"(,"detail":)";
            add_quoted(out, symbol.detail);
        }
        if (!symbol.children.empty()) {
            out += R"(,"children":)";
            add_symbols(out, symbol.children);
        }
        out += '}';
    });
}

std::string Encoder::symbols(const std::vector<Symbol>& symbols) const {
    std::string out;
    add_symbols(out, symbols);
    return out;
}

std::string Encoder::colors(const std::vector<language::Color>& colors) const {
    std::string out;
    add_list(out, colors, [&](const language::Color& color) {
        out += R"({"range":)";
        add_range(out, color.span);
        out += fmt::format(R"(,"color":{{"red":{},"green":{},"blue":{},"alpha":{}}}}})", color.rgba[0], color.rgba[1],
                           color.rgba[2], color.rgba[3]);
    });
    return out;
}

namespace {

// A request about a text: the scene that it belongs to, and the place.
struct Asked {
    Asked(State& state, const Json& params)
        : document(state.known_document(params)),
          project(state.workspace.project_of(document)),
          encode(state, project),
          found(project.file_of(document.path)),
          encoding(state.encoding) {
        if (found && params.contains("position")) offset = offset_of(params.at("position"));
    }

    std::uint32_t offset_of(const Json& place) const { return encode.lines(*found).offset(place_of(place), encoding); }
    FileId file() const { return *found; }

    const Document& document;
    const language::Project& project;
    Encoder encode;
    std::optional<FileId> found;  // nullopt: nothing can be said of it
    Encoding encoding;
    std::uint32_t offset = 0;
};

using Params = const Json&;
Json no_answer() { return nullptr; }

Json completion(Asked& a, Params) { return a.encode.completions(language::completions(a.project, a.file(), a.offset)); }
Json hover(Asked& a, Params) {
    const auto hover = language::hover(a.project, a.file(), a.offset);
    return hover ? a.encode.hover(*hover) : no_answer();
}
Json signature_help(Asked& a, Params) {
    const auto help = language::signature_help(a.project, a.file(), a.offset);
    return help ? a.encode.signatures(*help) : no_answer();
}
Json definition(Asked& a, Params) { return a.encode.locations(language::definition(a.project, a.file(), a.offset)); }
Json references(Asked& a, Params params) {
    const bool declarations = params.value("context", Json::object()).value("includeDeclaration", true);
    return a.encode.locations(language::references(a.project, a.file(), a.offset, declarations));
}
Json highlights(Asked& a, Params) {
    Json all = Json::array();
    for (const Span& span : language::references(a.project, a.file(), a.offset))
        if (span.file == a.file()) all.push_back({{"range", a.encode.range(span)}});
    return all;
}
Json prepare_rename(Asked& a, Params) {
    const language::Renaming naming = language::renaming(a.project, a.file(), a.offset);
    if (!naming.refused.empty()) throw Failure{Failure::request_failed, naming.refused};
    if (naming.span.begin == naming.span.end) return nullptr;
    return {{"range", a.encode.range(naming.span)}, {"placeholder", naming.name}};
}
Json rename(Asked& a, Params params) {
    const language::Rename rename =
        language::rename(a.project, a.file(), a.offset, params.at("newName").get<std::string>());
    if (!rename.refused.empty()) throw Failure{Failure::request_failed, rename.refused};
    return a.encode.workspace_edit(rename.edits);
}
std::string symbols(Asked& a, Params) { return a.encode.symbols(language::symbols(a.project, a.file())); }
std::string colors(Asked& a, Params) { return a.encode.colors(language::colors(a.project, a.file())); }
Json color_presentation(Asked& a, Params params) {
    const Json& color = params.at("color");
    std::array<double, 4> rgba{};
    constexpr std::array names{"red", "green", "blue", "alpha"};
    for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = color.at(names[i]).get<double>();
    const Json& range = params.at("range");
    const Span span{a.file(), a.offset_of(range.at("start")), a.offset_of(range.at("end"))};
    const auto edits = language::color_edits(a.project, span, rgba);
    if (edits.empty()) return Json::array();
    // The editor takes one edit, and a list of further ones.
    const Json all = a.encode.edits(edits);
    Json more = Json::array();
    for (std::size_t i = 1; i < all.size(); ++i) more.push_back(all[i]);
    std::string label;
    for (const Edit& edit : edits) label += (label.empty() ? "" : " ") + edit.text;
    return Json::array({{{"label", label}, {"textEdit", all[0]}, {"additionalTextEdits", std::move(more)}}});
}
Json formatting(Asked& a, Params) {
    if (!a.project.is_scene(a.file())) return nullptr;
    return a.encode.edits(language::layout_edits(a.project.sources.text(a.file()), a.file()));
}
Json range_formatting(Asked& a, Params params) {
    if (!a.project.is_scene(a.file())) return nullptr;
    const std::uint32_t begin = a.offset_of(params.at("range").at("start"));
    const std::uint32_t end = a.offset_of(params.at("range").at("end"));
    return a.encode.edits(language::layout_edits(a.project.sources.text(a.file()), a.file(), begin, end));
}

// A method whose answer is a value.
template <Json (*answer)(Asked&, Params)>
std::string value(Asked& asked, Params params) {
    return text_of(answer(asked, params));
}

struct Method {
    std::string_view name;
    std::string (*answer)(Asked& asked, Params params);
};
constexpr auto methods = std::to_array<Method>({
    {"textDocument/colorPresentation", value<color_presentation>},
    {"textDocument/completion", value<completion>},
    {"textDocument/definition", value<definition>},
    {"textDocument/documentColor", colors},
    {"textDocument/documentHighlight", value<highlights>},
    {"textDocument/documentSymbol", symbols},
    {"textDocument/formatting", value<formatting>},
    {"textDocument/hover", value<hover>},
    {"textDocument/prepareRename", value<prepare_rename>},
    {"textDocument/rangeFormatting", value<range_formatting>},
    {"textDocument/references", value<references>},
    {"textDocument/rename", value<rename>},
    {"textDocument/signatureHelp", value<signature_help>},
});

Json actions(State& state, const Json& params) {
    const Document& document = state.known_document(params);
    const auto said = state.published.find(document.uri);
    if (said == state.published.end() || said->second.value("version", document.version - 1) != document.version)
        return Json::array();  // what was said is of another text
    return code_actions(said->second.at("diagnostics"), params);
}

}  // namespace

std::optional<std::string> feature(State& state, const std::string& method, const Json& params) {
    if (method == "textDocument/codeAction") return text_of(actions(state, params));
    for (const Method& row : methods) {
        if (row.name != method) continue;
        Asked asked(state, params);
        return asked.found ? row.answer(asked, params) : "null";
    }
    return std::nullopt;
}

namespace {

void did_open(State& state, const Json& params) {
    const Json& item = params.at("textDocument");
    const std::string uri = string_at(item, "uri");
    const Document& opened =
        state.documents.open({uri, content::path_of_uri(uri), item.value("languageId", ""),
                              item.value("version", std::int64_t{0}), string_at(item, "text"), state.halves});
    state.workspace.rearranged();
    state.workspace.scene_of(opened);
}

void did_change(State& state, const Json& params) {
    Document& document = state.document(params);
    std::vector<Change> changes;
    for (const Json& json : params.at("contentChanges")) {
        Change change{std::nullopt, string_at(json, "text"), state.halves};
        if (const auto range = json.find("range"); range != json.end() && !range->is_null())
            change.range = Change::Range{place_of(range->at("start")), place_of(range->at("end"))};
        changes.push_back(std::move(change));
    }
    apply(document, changes, state.encoding);
    document.version = params.at("textDocument").value("version", document.version + 1);
    state.workspace.changed(document.path);
}

void did_save(State& state, const Json& params) {
    Document& document = state.document(params);
    const auto text = params.find("text");
    if (text == params.end() || !text->is_string() || (!document.lost && *text == document.text)) return;
    apply(document, {{std::nullopt, text->get<std::string>(), state.halves}}, state.encoding);
    state.workspace.rearranged();
}

void did_close(State& state, const Json& params) {
    const Document& document = state.document(params);
    state.documents.close(std::string(document.uri));
    state.workspace.rearranged();
}

void did_change_files(State& state, const Json& params) {
    bool arrangement = false;
    for (const Json& change : params.at("changes")) {
        const std::string path = content::path_of_uri(string_at(change, "uri"));
        arrangement = arrangement || change.value("type", 2) != 2;
        if (!state.documents.with_path(path)) state.workspace.changed(path);
    }
    if (arrangement) state.workspace.rearranged();
}

void initialized(State& state, const Json&) {
    if (state.can("/workspace/didChangeWatchedFiles/dynamicRegistration"))
        state.ask("client/registerCapability", watched_files());
}

std::string shortened(std::string text) {
    constexpr std::size_t most = 60;
    if (text.size() > most) text = text.substr(0, most - 3) + "...";
    return text;
}

std::string title_of(const Json& fix) {
    const std::string before = shortened(string_at(fix, "old")), after = shortened(string_at(fix, "newText"));
    if (before.empty()) return fmt::format("Insert '{}'", after);
    if (after.empty()) return fmt::format("Remove '{}'", before);
    return fmt::format("Change '{}' to '{}'", before, after);
}

bool wants_quick_fixes(const Json& params) {
    const Json context = params.value("context", Json::object());
    if (!context.contains("only")) return true;
    for (const Json& kind : context["only"])
        if (kind == "quickfix" || kind == "") return true;
    return false;
}

bool before(Place a, Place b) { return a.line != b.line ? a.line < b.line : a.character < b.character; }

bool touch(const Json& a, const Json& b) {
    return !before(place_of(a.at("end")), place_of(b.at("start"))) &&
           !before(place_of(b.at("end")), place_of(a.at("start")));
}

constexpr std::chrono::milliseconds most_trial_time{1500};  // for all fixes of a scene

// What is read with the fixes applied; nullopt if one is in no file of the user's.
std::optional<Access> fixed(const Diagnostic& diagnostic, const Sources& sources, const Access& access) {
    std::map<FileId, std::vector<Edit>> by_file;
    for (const Fix& fix : diagnostic.fixes) by_file[fix.span.file].push_back(fix);
    std::map<std::string, std::string> texts;
    for (auto& [file, fixes] : by_file) {
        const std::string name(sources.name(file));
        if (name.empty() || name.starts_with('<')) return std::nullopt;
        ranges::stable_sort(fixes, {}, [](const Edit& fix) { return fix.span.begin; });
        texts.insert_or_assign(real_path(name), with_edits(sources.text(file), file, fixes));
    }
    return access.with(std::move(texts));
}

using Said = std::multiset<std::pair<std::string_view, std::string_view>>;

// The messages that are at least so severe, by code and text. Views of `all`.
Said said(const Diagnostics& all, Severity severity) {
    Said messages;
    for (const Diagnostic& d : all.items())
        if (d.severity >= severity)
            for (std::size_t i = 0; i <= d.also.size(); ++i) messages.emplace(d.code, d.message);
    return messages;
}

// There are fewer messages, among them the one that is fixed, and none is new. An error hides the warnings of its
// program: they do not count as new when it goes.
bool is_good(const Diagnostic& fixed, const Diagnostics& before, const Diagnostics& after) {
    const Said old = said(before, fixed.severity), now = said(after, fixed.severity);
    const std::pair<std::string_view, std::string_view> one(fixed.code, fixed.message);
    return now.count(one) < old.count(one) && std::includes(old.begin(), old.end(), now.begin(), now.end());
}

}  // namespace

void lose(State& state, const std::optional<std::string>& uri, const std::string& why) {
    const int lost = state.documents.lose(uri);
    if (lost == 0) return;
    state.workspace.rearranged();
    const std::string name = uri ? uri->substr(uri->rfind('/') + 1) : std::to_string(lost) + " texts";
    state.notify("window/showMessage", {{"type", 2},
                                        {"message", "snell could not read a change of " + name + ": " + why +
                                                        ". Save to have it read again."}});
}

void notice(State& state, const std::string& method, const Json& params) {
    if (method == "initialized") initialized(state, params);
    if (method == "textDocument/didOpen") did_open(state, params);
    if (method == "textDocument/didChange") did_change(state, params);
    if (method == "textDocument/didSave") did_save(state, params);
    if (method == "textDocument/didClose") did_close(state, params);
    if (method == "workspace/didChangeWatchedFiles") did_change_files(state, params);
}

Json code_actions(const Json& diagnostics, const Json& params) {
    Json actions = Json::array();
    if (!wants_quick_fixes(params)) return actions;
    for (const Json& diagnostic : diagnostics) {
        if (!diagnostic.contains("data") || !touch(diagnostic.at("range"), params.at("range"))) continue;
        const Json& fixes = diagnostic.at("data").at("fixes");
        Json edits = Json::object();
        for (const Json& fix : fixes)
            edits[string_at(fix, "uri")].push_back({{"range", fix.at("range")}, {"newText", fix.at("newText")}});
        actions.push_back({{"title", title_of(fixes.at(0))},
                           {"kind", "quickfix"},
                           {"diagnostics", Json::array({diagnostic})},
                           {"isPreferred", true},
                           {"edit", {{"changes", std::move(edits)}}}});
    }
    return actions;
}

void keep_good_fixes(Checked& checked, const Access& access, const std::function<Checked(const Access&)>& check) {
    const auto end = std::chrono::steady_clock::now() + most_trial_time;
    Diagnostics kept;
    for (Diagnostic diagnostic : checked.diagnostics.items()) {
        if (!diagnostic.fixes.empty()) {
            const auto with =
                std::chrono::steady_clock::now() < end ? fixed(diagnostic, checked.sources, access) : std::nullopt;
            if (!with || !is_good(diagnostic, checked.diagnostics, check(*with).diagnostics)) diagnostic.fixes.clear();
        }
        kept.add(std::move(diagnostic));
    }
    checked.diagnostics = std::move(kept);
}

}  // namespace snell::server
