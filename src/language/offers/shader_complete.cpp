// Completion in shaders.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "parser/text/words.h"
#include "src/glsl/read/words.h"
#include "src/language/offers/offers.h"
#include "src/language/shader/builtins.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using Offer = Completion::Kind;

constexpr std::string_view directive_words =
    "define undef if ifdef ifndef else elif endif include version extension line";

// Whether the text may use what core profiles lack.
bool legacy_dialect(const Outline& outline) {
    for (const ShaderDirective& directive : outline.directives) {
        if (directive.word != "version") continue;
        int version = 110;
        std::from_chars(directive.rest.data(), directive.rest.data() + directive.rest.size(), version);
        return version < 140 || directive.rest.find("compatibility") != std::string_view::npos;
    }
    return true;
}

class ShaderOffers {
public:
    ShaderOffers(Texts& texts, FileId file, std::uint32_t offset)
        : texts_(texts), o_(texts.outline(file)), file_(file), offset_(offset), uses_(texts.uses(file)) {
        if (!uses_.empty()) stage_ = uses_.front().stage;
        next_ = o_.before(offset);  // the first token that begins at or behind the offset
        if (next_ > 0 && o_.tokens[next_ - 1].end >= offset && o_.tokens[next_ - 1].kind == glsl::Kind::identifier)
            token_ = &o_.tokens[--next_];
        replaced_ = token_ != nullptr ? o_.span(*token_) : Span{file, offset, offset};
    }

    std::vector<Completion> run() {
        if (o_.in_comment(offset_)) return {};
        if (const ShaderDirective* directive = o_.directive_at(offset_)) return in_directive(*directive);
        const ShaderToken* left = before(0);
        if (left != nullptr && left->end == offset_ &&
            (left->kind == glsl::Kind::integer || left->kind == glsl::Kind::real))
            return {};  // a number that is being written
        if (word(0) == ".") return members();
        const bool body = o_.in_body(offset_);
        if (declares_name()) {
            if (!body && word(1) == "uniform") wanted_uniforms(true);
            return finish();
        }
        const bool expression =
            body || (!word(0).empty() && std::string_view("=(,+-*/<>?:&|!").find(word(0)[0]) != std::string_view::npos);
        types();
        words();
        globals();
        if (expression) {
            locals();
            functions();
            variables();
            wanted_uniforms(false);
        } else {
            declarations_wanted();
        }
        return finish();
    }

private:
    // The token `back` before the word that is being written.
    const ShaderToken* before(std::size_t back) const { return next_ > back ? &o_.tokens[next_ - 1 - back] : nullptr; }
    std::string_view word(std::size_t back) const {
        const ShaderToken* token = before(back);
        return token == nullptr ? std::string_view() : o_.word(*token);
    }
    // A new name follows its type.
    bool declares_name() const {
        const ShaderToken* type = before(0);
        return type != nullptr && type->kind == glsl::Kind::identifier && glsl::builtin_type(o_.word(*type)) &&
               !type->in_directive;
    }

    Completion& add(std::string_view label, Offer kind, std::string detail = {}, std::string documentation = {}) {
        return add_offer(found_, label, kind, replaced_, std::move(detail), std::move(documentation));
    }

    std::vector<Completion> finish() {
        std::set<std::string> seen;
        std::erase_if(found_, [&](const Completion& one) { return !seen.insert(one.label).second; });
        return std::move(found_);
    }

    // ---- directives

    std::vector<Completion> in_directive(const ShaderDirective& directive) {
        const auto word_end =
            static_cast<std::uint32_t>(directive.word.data() + directive.word.size() - o_.text.data());
        if (offset_ <= word_end) {
            for (const std::string_view one : split(directive_words)) add(one, Offer::keyword);
            return finish();
        }
        if (directive.word == "include") return included(directive);
        if (directive.word == "version" || directive.word == "extension" || directive.word == "line") return {};
        if (directive.word == "error" || directive.word == "pragma") return {};
        globals();
        ladders();
        if (directive.word == "define") functions(), variables(), types();
        return finish();
    }

    std::vector<Completion> included(const ShaderDirective& directive) {
        if (directive.name_begin == 0 || offset_ < directive.name_begin || offset_ > directive.name_end) return {};
        replaced_ = {file_, directive.name_begin, directive.name_end};
        if (directive.rest.front() == '<') {
            for (const Shader& shader : texts_.project.shaders)
                if (shader.path.empty()) add(texts_.project.sources.name(shader.file), Offer::file);
            for (const std::string_view name : library_headers()) add(name, Offer::file);
            return finish();
        }
        constexpr std::array<std::string_view, 3> extensions{"glsl", "inc", "h"};
        return file_completions(texts_.project.path_of(file_),
                                o_.text.substr(directive.name_begin, offset_ - directive.name_begin), replaced_,
                                extensions, Quotes::never);
    }

    // ---- names

    void types() {
        for (const std::string_view type : type_names()) add(type, Offer::type).rank = 4;
    }
    void words() {
        for (const std::string_view keyword : keywords()) add(keyword, Offer::keyword).rank = 4;
    }

    void globals() {
        for (const FileId file : texts_.together(file_)) {
            const Outline& outline = texts_.outline(file);
            for (const ShaderDeclaration& d : outline.declarations) {
                if (d.local || d.kind == Kind::member || d.kind == Kind::block || d.name == "main") continue;
                const std::uint32_t at = outline.tokens[d.token].begin;
                if (file == file_ && (&outline.tokens[d.token] == token_ || at == offset_)) continue;
                const Offer kind = d.kind == Kind::function                            ? Offer::function
                                   : d.kind == Kind::structure                         ? Offer::type
                                   : d.kind == Kind::macro || d.kind == Kind::constant ? Offer::constant
                                   : d.kind == Kind::uniform                           ? Offer::uniform
                                                                                       : Offer::variable;
                Completion& one = add(d.name, kind, declaration_text(outline, d));
                one.documentation = fmt::format("Declared at {}.", place_text(texts_, file, at));
                if (const std::string comment = comment_of(outline, d.begin, d.end); !comment.empty())
                    one.documentation += "\n\n" + comment;
                if (file != file_ && texts_.project.path_of(file).empty()) one.rank = 3;
            }
        }
        ladders();
    }

    void ladders() {
        for (const Ladder& ladder : texts_.project.scene().ladders) {
            const std::string rungs = ladder_text(ladder);
            add(ladder.name, Offer::constant, "ladder", rungs).rank = 2;
            for (const std::string& rung : ladder.rungs)
                add(ladder.name + "_" + rung, Offer::constant, "rung of " + ladder.name, rungs).rank = 2;
        }
    }
    void locals() {
        for (const ShaderDeclaration& d : o_.declarations) {
            if (!d.local || d.visible_from > offset_ || d.visible_to < offset_) continue;
            if (o_.tokens[d.token].in_directive || &o_.tokens[d.token] == token_) continue;
            add(d.name, Offer::variable, fmt::format("{} {}", d.type, d.name)).rank = 0;
        }
        // The one that is declared last hides the others.
        std::reverse(found_.begin(), found_.end());
    }

    void functions() {
        for (const std::string_view name : function_names(legacy_dialect(o_))) {
            const std::vector<std::string> all = function_signatures(name);
            const glsl::BuiltinFunction* doc = function_doc(name);
            add(name, Offer::function, all.empty() ? "" : all.front(), std::string(doc->doc)).rank = 3;
        }
    }

    void variables() {
        const bool legacy = legacy_dialect(o_);
        for (const VariableDoc& doc : variable_docs(stage_)) {
            if (doc.legacy && !legacy) continue;
            Completion& one = add(doc.name, Offer::variable, doc.type, doc.doc);
            one.rank = doc.undeclared ? 3 : 5;
            if (doc.undeclared) continue;
            const std::size_t bracket = doc.type.find('[');
            const std::string element = doc.type.substr(0, bracket);
            const std::string size = bracket == std::string::npos ? "" : doc.type.substr(bracket);
            declare(one, fmt::format("{} {} {}{};", qualifier(doc.qualifier), element, doc.name, size));
        }
    }
    std::string_view qualifier(std::string_view modern) const {
        return modern == "in" && legacy_dialect(o_) ? "attribute" : modern;
    }

    // Adds the declaration where the others are.
    void declare(Completion& one, const std::string& declaration) {
        std::uint32_t at = 0;
        bool found = false;
        for (const ShaderDeclaration& d : o_.declarations) {
            if (d.kind != Kind::uniform || found) continue;
            at = static_cast<std::uint32_t>(o_.text.rfind('\n', d.begin) + 1);  // npos + 1 is 0
            found = true;
        }
        for (const ShaderDirective& directive : o_.directives)
            if (!found && (directive.word == "version" || directive.word == "extension"))
                at = static_cast<std::uint32_t>(std::min<std::size_t>(directive.end + 1, o_.text.size()));
        if (at >= offset_) return;
        const bool open_line = at > 0 && o_.text[at - 1] != '\n';
        const std::string_view end = o_.text.find("\r\n") != std::string_view::npos ? "\r\n" : "\n";
        one.also.push_back({{file_, at, at}, fmt::format("{}{}{}", open_line ? end : "", declaration, end)});
    }

    // What the scene sets and no shader of the program declares; `typed`: behind `uniform` and a type.
    void wanted_uniforms(bool typed) {
        for_wanted([&](const UniformValue& value, const std::string& type) {
            const std::string_view name = base_name(value.name);
            Completion& one = add(name, Offer::uniform, type, "The scene sets it; no shader declares it.");
            one.rank = 0;
            if (typed)
                one.text = std::string(name) + ";";
            else
                declare(one, fmt::format("uniform {} {};", type, name));
        });
    }
    // Whole declarations.
    void declarations_wanted() {
        const bool begun = word(0) == "uniform";
        for_wanted([&](const UniformValue& value, const std::string& type) {
            const std::string text = fmt::format("{} {};", type, base_name(value.name));
            Completion& one = add(begun ? text : "uniform " + text, Offer::uniform, "the scene sets it");
            one.rank = 0;
        });
        for (const VariableDoc& doc : variable_docs(stage_)) {
            if (doc.undeclared || doc.type.find('[') != std::string::npos) continue;
            if (begun && doc.qualifier != "uniform") continue;
            const std::string text = fmt::format("{} {};", doc.type, doc.name);
            add(begun ? text : fmt::format("{} {}", qualifier(doc.qualifier), text), Offer::variable, "snell sets it",
                doc.doc)
                .rank = 5;
        }
    }
    template <class Each>
    void for_wanted(Each each) {
        const auto& programs = texts_.project.scene().programs;
        std::set<std::string> done;
        for (const ShaderUse& use : uses_) {
            if (use.program >= programs.size()) continue;
            for (const UniformValue& value : programs[use.program].uniforms) {
                const std::string name(base_name(value.name));
                if (!done.insert(name).second || !declarations(texts_, file_, name).empty()) continue;
                each(value, guessed_type(texts_.project.scene(), value));
            }
        }
    }

    // ---- members

    std::vector<Completion> members() {
        for (const MemberOffer& member : members_before(texts_, file_, next_ - 1, stage_))
            add(member.name, Offer::member, member.type).rank = member.rank;
        return finish();
    }

    Texts& texts_;
    const Outline& o_;
    FileId file_;
    std::uint32_t offset_;
    std::vector<ShaderUse> uses_;
    Stage stage_ = Stage::fragment;
    std::size_t next_ = 0;
    const ShaderToken* token_ = nullptr;  // the word that is being written
    Span replaced_;
    std::vector<Completion> found_;
};

}  // namespace

std::vector<Completion> shader_completions(Texts& texts, FileId file, std::uint32_t offset) {
    return ShaderOffers(texts, file, offset).run();
}

}  // namespace snell::language
