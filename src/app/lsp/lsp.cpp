// `snell lsp`: the language server, and what it asks of the rest of the program.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "parser/text/ranges.h"
#include "src/app/commands/check.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/headless.h"
#include "src/app/open/version.h"
#include "src/content/text_forms.h"
#include "src/lint/lint.h"
#include "src/server/server.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

// The folder of the pages: next to an installed program, or in the folder of the sources.
fs::path docs_folder() {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
    for (const char* way : {"../share/doc/snell/docs", "../../../docs"}) {
        fs::path folder = (program / way).lexically_normal();
        if (fs::is_regular_file(folder / "diagnostics.md", none)) return folder;
    }
    return {};
}

std::string doc_file(const fs::path& docs, std::string_view name) {
    std::error_code none;
    const fs::path file = docs / name;
    return !docs.empty() && fs::is_regular_file(file, none) ? file.string() : "";
}

std::string page_of(const fs::path& docs, std::string_view code) {
    if (docs.empty()) return {};
    const auto rules = lint::rules();
    const auto rule = ranges::find(rules, code, &lint::RuleFacts::code);
    const fs::path page = docs / (rule == rules.end() ? "diagnostics.md" : "teaching.md");
    return fmt::format("{}#{}", content::uri_of_path(page.string()), rule == rules.end() ? code : rule->anchor);
}

server::Services::Checker driver() {
    std::string error;
    const std::shared_ptr<HeadlessContext> context = HeadlessContext::make({}, error);
    if (!context) return nullptr;
    return [context](const std::string& scene, const Access& access) {
        constexpr double seconds = 10;
        const auto document = checked_document(scene, gl::query_caps(), true, seconds, {}, access);
        return server::Checked{std::move(document->sources), std::move(document->diagnostics)};
    };
}

// Only the protocol is written to standard output: what else is printed goes to standard error.
int own_output() {
    const int own = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    return own;
}

int serve() {
    const fs::path docs = docs_folder();
    server::Services services;
    services.driver = driver;
    services.page_of = [docs](std::string_view code) { return page_of(docs, code); };
    services.doc_file = [docs](std::string_view name) { return doc_file(docs, name); };
    services.version = version();
    return server::serve(std::move(services), STDIN_FILENO, own_output());
}

}  // namespace

Run add_lsp(CLI::App& command) {
    command.footer(
        "An editor starts it and talks to it through standard input and output; docs/lsp.md lists what it offers.");
    auto stdio = std::make_shared<bool>();
    command.add_flag("--stdio", *stdio, "accepted because some editors pass it; it changes nothing");
    return [stdio] { return serve(); };
}

}  // namespace snell::app
