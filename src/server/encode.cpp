#include "src/server/encode.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "parser/text/ranges.h"
#include "src/content/text_forms.h"

namespace snell::server {

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

}  // namespace snell::server
