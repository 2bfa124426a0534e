#include "src/server/published.h"

#include <array>
#include <map>

#include "parser/text/ranges.h"
#include "src/content/text_forms.h"
#include "src/lint/lint.h"

namespace snell::server {

namespace {

// The codes that say that something could as well be left out.
bool unnecessary(std::string_view code) {
    using enum lint::Rule;
    constexpr std::array rules{never_read, program_not_drawn, slider_without_effect};
    return ranges::any_of(rules, [&](lint::Rule rule) { return lint::facts(rule).code == code; });
}

class Publisher {
public:
    Publisher(const Sources& sources, const std::string& scene, const Documents& documents, const Services& services,
              Encoding encoding)
        : sources_(sources), scene_(scene), documents_(documents), services_(services), encoding_(encoding) {}

    void add(const Diagnostic& diagnostic) {
        const Text* text = diagnostic.has_span ? text_at(diagnostic.span.file) : nullptr;
        Span span = diagnostic.span;
        if (!text) {
            text = text_named(scene_);
            span = {};
        }
        if (!text) return;
        Json json{{"range", range_json(text->lines, span, encoding_)},
                  {"severity", 3 - static_cast<int>(diagnostic.severity)},
                  {"code", diagnostic.code},
                  {"source", "snell"},
                  {"message", diagnostic.message}};
        if (!diagnostic.help.empty()) json["message"] = diagnostic.message + "\n" + diagnostic.help;
        if (unnecessary(diagnostic.code)) json["tags"] = Json::array({1});
        const std::string page = services_.page_of ? services_.page_of(diagnostic.code) : "";
        if (!page.empty()) json["codeDescription"] = {{"href", page}};
        add_related(json, diagnostic);
        add_fixes(json, diagnostic);
        found_[text->uri].push_back(std::move(json));
    }

    // Texts about which nothing is said are listed too: what was said of them before is no longer so.
    void list_all() {
        for (FileId file = 0; file < sources_.size(); ++file)
            if (const Text* text = text_at(file)) found_[text->uri];
    }

    Json take() {
        Json all = Json::array();
        for (auto& [uri, diagnostics] : found_) {
            Json file{{"uri", uri}};
            for (const auto& [name, text] : texts_)
                if (text.uri == uri && text.version) file["version"] = *text.version;
            file["diagnostics"] = std::move(diagnostics);
            all.push_back(std::move(file));
        }
        return all;
    }

private:
    struct Text {
        std::string uri;
        Lines lines;
        std::optional<std::int64_t> version;
    };

    // Null: it is no file of the user's.
    const Text* text_at(FileId file) {
        const std::string name(sources_.name(file));
        const auto known = texts_.find(name);
        if (known != texts_.end()) return &known->second;
        const Document* document = documents_.with_path(name);
        if (!document && !name.starts_with('/')) return nullptr;
        Text text{document ? document->uri : content::uri_of_path(real_path(name)), Lines(sources_.text(file)),
                  std::nullopt};
        if (document) text.version = document->version;
        return &texts_.emplace(name, std::move(text)).first->second;
    }

    const Text* text_named(const std::string& name) {
        for (FileId file = 0; file < sources_.size(); ++file)
            if (sources_.name(file) == name) return text_at(file);
        return nullptr;
    }

    void add_related(Json& json, const Diagnostic& diagnostic) {
        const auto add = [&](const Span& span, const std::string& message) {
            if (const Text* text = text_at(span.file))
                json["relatedInformation"].push_back(
                    {{"location", {{"uri", text->uri}, {"range", range_json(text->lines, span, encoding_)}}},
                     {"message", message}});
        };
        for (const Note& note : diagnostic.notes) add(note.span, note.message);
        for (const Span& span : diagnostic.also) add(span, "the same here");
    }

    // From which actions are made (actions.h).
    void add_fixes(Json& json, const Diagnostic& diagnostic) {
        for (const Fix& fix : diagnostic.fixes) {
            const Text* text = text_at(fix.span.file);
            if (!text) continue;
            const std::string_view all = sources_.text(fix.span.file);
            json["data"]["fixes"].push_back({{"uri", text->uri},
                                             {"version", text->version ? Json(*text->version) : Json()},
                                             {"range", range_json(text->lines, fix.span, encoding_)},
                                             {"old", all.substr(fix.span.begin, fix.span.end - fix.span.begin)},
                                             {"newText", fix.text}});
        }
    }

    const Sources& sources_;
    const std::string& scene_;
    const Documents& documents_;
    const Services& services_;
    Encoding encoding_;
    std::map<std::string, Text> texts_;           // by name of the source
    std::map<std::string, Json::array_t> found_;  // by URI
};

}  // namespace

Json published(const Diagnostics& diagnostics, const Sources& sources, const std::string& scene,
               const Documents& documents, const Services& services, Encoding encoding) {
    Publisher publisher(sources, scene, documents, services, encoding);
    publisher.list_all();
    for (const Diagnostic& diagnostic : diagnostics.items()) publisher.add(diagnostic);
    return publisher.take();
}

}  // namespace snell::server
