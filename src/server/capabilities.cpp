#include "src/server/capabilities.h"

#include <algorithm>

namespace snell::server {

Encoding chosen_encoding(const Json& offered) {
    if (offered.is_array() && std::find(offered.begin(), offered.end(), "utf-8") != offered.end())
        return Encoding::utf8;
    return Encoding::utf16;
}

Json capabilities(Encoding encoding) {
    return {{"positionEncoding", encoding == Encoding::utf8 ? "utf-8" : "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", {{"includeText", true}}}}},
            {"codeActionProvider", {{"codeActionKinds", Json::array({"quickfix"})}}},
            {"completionProvider", {{"triggerCharacters", {".", "<", "\"", "/", "#", "{"}}}},
            {"hoverProvider", true},
            {"signatureHelpProvider", {{"triggerCharacters", {"(", ",", " "}}}},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"documentHighlightProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"documentSymbolProvider", true},
            {"colorProvider", true},
            {"documentFormattingProvider", true},
            {"documentRangeFormattingProvider", true}};
}

Json watched_files() {
    return {{"registrations",
             {{{"id", "files"},
               {"method", "workspace/didChangeWatchedFiles"},
               {"registerOptions", {{"watchers", {{{"globPattern", "**/*"}}}}}}}}}};
}

}  // namespace snell::server
