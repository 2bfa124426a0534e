#include "tools/docs/generate.h"

#include <algorithm>
#include <set>

#include "parser/commands/commands.h"
#include "parser/text/limits.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/lint/lint.h"

namespace snell::docs {
namespace {

std::string_view kind_name(const Parameter& p) {
    switch (p.kind) {
        case ArgumentKind::number:
            return "number";
        case ArgumentKind::integer:
            return "whole number";
        case ArgumentKind::path:
            return "file name";
        case ArgumentKind::name:
            return "word";
        case ArgumentKind::choice:
            return "one of the words";
        case ArgumentKind::vec3:
            return "`[x y z]`";
        case ArgumentKind::uniforms:
            return "uniforms and values";
        case ArgumentKind::rest:
            return "text to the end of the line";
    }
    return "";
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : std::string(separator)) + word;
    return out;
}

// "slices:int=60" as an argument of a reference: `slices`, whole number, 60.
std::string row(const Parameter& p) {
    std::string kind(kind_name(p));
    if (p.kind == ArgumentKind::choice) {
        std::string words(p.choices);
        std::replace(words.begin(), words.end(), '/', ' ');
        kind = "one of: " + words;
    }
    std::string value =
        p.default_text.empty() ? (p.optional ? "optional" : "") : "`" + std::string(p.default_text) + "`";
    if (p.repeated) value = "repeated";
    return "| `" + std::string(p.name) + "` | " + kind + " | " + value + " |\n";
}

std::string usage(const Command& c, std::size_t alternative) {
    std::string text(c.name);
    for (std::size_t i = 0; i < c.signature.parameter_count(alternative); ++i) {
        const Parameter& p = c.signature.parameter(alternative, i);
        std::string name(p.name);
        if (p.kind == ArgumentKind::vec3) name.insert(0, "[") += "]";
        if (p.repeated) name += " …";
        text += p.optional ? " (" : " ";
        text += name;
        if (p.optional) text += ")";
    }
    return text;
}

std::string section(const Command& c) {
    const std::string name(c.name);
    std::string out = "\n### " + name + "\n\n";
    out += "<img src=\"images/" + name + ".png\" align=\"right\" width=\"128\" alt=\"" + name + "\">\n\n";
    out += "```\n";
    for (std::size_t i = 0; i < c.signature.count; ++i) out += usage(c, i) + "\n";
    out += "```\n\n" + std::string(c.doc);
    if (!c.alias.empty()) out += " Also written `" + std::string(c.alias) + "`.";
    if (c.addition) out += "\n\n*An addition of snell's.*";
    out += "\n\nSignature: `" + name + (c.signature.text.empty() ? "" : " ") + std::string(c.signature.text) + "`\n";
    std::set<std::string_view> seen;
    std::string rows;
    for (std::size_t a = 0; a < c.signature.count; ++a)
        for (std::size_t i = 0; i < c.signature.parameter_count(a); ++i)
            if (const Parameter& p = c.signature.parameter(a, i); seen.insert(p.name).second) rows += row(p);
    if (!rows.empty()) out += "\n| argument | kind | default |\n|---|---|---|\n" + rows;
    return out + "\n<br clear=\"right\">\n";
}

std::string language(const std::string& intro) {
    std::string out = intro;
    std::string_view group;
    std::string contents = "\n## Commands\n";
    for (const Command& c : commands()) {
        if (c.group != group) contents += "\n\n**" + std::string(c.group) + "**:";
        group = c.group;
        contents += " [" + std::string(c.name) + "](#" + lowered(c.name) + ")";
    }
    out += contents + "\n";
    group = {};
    for (const Command& c : commands()) {
        if (c.group != group) out += "\n## Commands: " + lowered(c.group) + "\n";  // a command is named Geometry, too
        group = c.group;
        out += section(c);
    }
    return out;
}

std::vector<std::string> command_words() {
    std::vector<std::string> words;
    for (const std::string_view name : command_names()) words.emplace_back(name);
    std::sort(words.begin(), words.end(), [](const auto& a, const auto& b) { return lowered(a) < lowered(b); });
    return words;
}

// Every word that is an argument of some command.
std::vector<std::string> choice_words() {
    std::set<std::string> words;
    for (const Command& c : commands())
        for (const Parameter& p : c.signature.parameters)
            for (const std::string_view word : split(p.choices, '/')) words.emplace(word);
    for (const std::string_view name : topology_names()) words.emplace(name);
    return {words.begin(), words.end()};
}

std::string textmate() {
    const std::string number = R"([-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?)";
    const auto pattern = [](const std::string& name, const std::string& match) {
        return "    {\"name\": \"" + name + ".glib\", \"match\": \"" + match + "\"}";
    };
    return "{\n  \"name\": \"GLIB scene\",\n  \"scopeName\": \"source.glib\",\n  \"fileTypes\": [\"glib\"],\n  "
           "\"patterns\": [\n" +
           joined({pattern("comment.line", "(#|//).*$"), pattern("string.quoted.double", R"(\"[^\"]*\"?)"),
                   pattern("keyword.control", R"((?i)^\\s*()" + joined(command_words(), "|") + R"()\\b)"),
                   pattern("constant.language", "\\\\b(true|false|" + joined(choice_words(), "|") + ")\\\\b"),
                   pattern("constant.numeric", "(?<![\\\\w.])" + number),
                   pattern("punctuation.separator.continuation", R"(\\\\\\s*$)"),
                   pattern("punctuation.section.brackets", R"([<>\\[\\]{}])")},
                  ",\n") +
           "\n  ]\n}\n";
}

std::string vim() {
    std::string out =
        "\" Vim syntax file for GLIB scenes. Written by snell_docs from the table of commands.\n"
        "if exists(\"b:current_syntax\")\n  finish\nendif\n\nsyntax case ignore\n";
    for (const std::string& word : command_words()) out += "syntax keyword glibCommand " + word + "\n";
    out += "syntax case match\n";
    for (const std::string& word : choice_words()) out += "syntax keyword glibConstant " + word + "\n";
    return out + R"(syntax keyword glibConstant true false
syntax match glibNumber "\v[-+]?<(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?"
syntax match glibNumber "\v[-+]?\.\d+([eE][-+]?\d+)?"
syntax region glibString start=+"+ end=+"+ oneline
syntax match glibBracket "[<>\[\]{}]"
syntax match glibContinuation "\\\s*$"
syntax match glibComment "#.*$"
syntax match glibComment "//.*$"

highlight default link glibCommand Statement
highlight default link glibConstant Constant
highlight default link glibNumber Number
highlight default link glibString String
highlight default link glibBracket Delimiter
highlight default link glibContinuation Special
highlight default link glibComment Comment

let b:current_syntax = "glib"
)";
}

// Words for the fuzzer, which finds them by chance only in days.
std::string dictionary() {
    std::string out = "# Written by snell_docs from the table of commands.\n";
    for (const std::string& word : command_words()) out += "\"" + word + "\"\n";
    for (const std::string& word : choice_words()) out += "\"" + word + "\"\n";
    return out +
           "\"\\x0a\"\n\"\\x5c\\x0a\"\n\"<0. .5 1.>\"\n\"{1 0 0}\"\n\"[1 2 "
           "3]\"\n\"<true>\"\n\"\\xc2\\xa0\"\n\"\\xef\\xbb\\xbf\"\n";
}

std::string lints() {
    std::string out =
        "# Lints\n\nProbable mistakes that `snell check` finds in scenes that run. Each is a warning or a note with "
        "its "
        "place; the exit status\nstays 0, and `--no-lint` leaves them out. The window lists the warnings. Shaders are "
        "followed from `main` through "
        "the "
        "functions it calls. Only what is\ncertain is reported. `snell help CODE` prints the page of a code. Written "
        "by snell_docs from the table in "
        "src/lint/rules.cpp.\n\n| code | finds | instead | page |\n|---|---|---|---|\n";
    for (const lint::RuleFacts& rule : lint::rules())
        out += "| <a id=\"" + std::string(rule.code) + "\"></a>`" + std::string(rule.code) + "`" +
               (rule.severity == Severity::note ? " (a note)" : "") + " | " + std::string(rule.finds) + " | " +
               std::string(rule.instead) + " | [teaching.md](teaching.md#" + std::string(rule.anchor) + ") |\n";
    return out;
}

std::string limits() {
    std::string out =
        "# Limits\n\nThe limits of a scene, checked before memory is allocated. A request above a limit is an error "
        "that names "
        "the limit, and\nthe rest of the scene continues; `--limit NAME=VALUE` of every command that reads scenes "
        "changes "
        "one. Written by snell_docs\nfrom the table in parser/text/limits.cpp.\n\n| limit | default | unit | maximum "
        "|\n"
        "|---|---|---|---|\n";
    const Limits defaults;
    for (const LimitFacts& limit : limit_table())
        out += "| `" + std::string(limit.name) + "` | " + std::to_string(defaults.*limit.value) + " | " +
               std::string(limit.unit) + " " + std::string(limit.doc) + " | " + std::to_string(limit.most) + " |\n";
    return out +
           "\nA picture of more than `output-bytes`, or half a gigabyte, is drawn in tiles and written row by row; a "
           "picture that does not\nfit even in tiles of 64x64 pixels is an error.\n"
           "\nOpenGL has its own limits, which `snell info` prints; a texture or picture that exceeds them is an error "
           "too.\nMesa's llvmpipe ends the loops of a shader after 65,535 rounds together, without a message "
           "([reliability.md](reliability.md)).\n"
           "\nThe window undoes at most 1000 steps of a scene, of 16 MiB together, for the last 12 scenes that it "
           "showed. "
           "It keeps values,\nrungs and view of at most 200 scenes, and removes those first that were not opened or "
           "changed for the longest time; more\nthan 256 KiB of a scene are not kept.\n";
}

}  // namespace

std::vector<Document> generate(const std::string& intro) {
    return {{"docs/language.md", language(intro)},
            {"docs/lints.md", lints()},
            {"docs/limits.md", limits()},
            {"docs/variables.md", variables()},
            {"docs/editors/glib.tmLanguage.json", textmate()},
            {"docs/editors/vim/syntax/glib.vim", vim()},
            {"docs/editors/vim/ftdetect/glib.vim", "autocmd BufNewFile,BufRead *.glib setfiletype glib\n"},
            {"editors/vscode/snippets.json", snippets()},
            {"web/page/editor/words.json", page_words()},
            {"tests/fuzz/parser.dict", dictionary()}};
}

}  // namespace snell::docs
