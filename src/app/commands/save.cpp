// `snell save`: writes values into a scene's text.
#include <fmt/format.h>

#include <cstdio>

#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/complain.h"
#include "src/app/open/deadline.h"
#include "src/app/open/exit_status.h"
#include "src/app/open/headless.h"
#include "src/app/open/write_saved.h"
#include "src/content/replace.h"
#include "src/document/save_values.h"

namespace snell::app {

namespace {

struct SaveOptions {
    std::string scene, output;  // an empty output means the scene's own file
    std::vector<std::string> sets, ladders;
    std::string context;
    Access access;
    double timeout = 20;  // in seconds, for reading
};

// Writes the scene's new text into another file.
Exit write_copy(const Document& document, const Saved& saved, const std::string& output) {
    std::string text(document.sources.text(0));
    for (const SavedFile& file : saved.files) {
        if (file.path != document.path)
            return complain(exit_input,
                            fmt::format("a value is in {}, which {} would still include", file.path, output));
        text = file.after;
    }
    const std::string error = content::replace_file(output, text);
    return error.empty() ? exit_fine : complain(exit_input, error);
}

Exit save(const SaveOptions& options) {
    Deadline deadline(options.timeout);
    deadline.begin(fmt::format("reading '{}'", options.scene));
    const auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    Diagnostics problems;
    const auto choose = [&](const Scene& scene, Rungs& rungs) {
        for (const std::string& ladder : options.ladders) choose_rung(rungs, scene, ladder, problems);
    };
    const auto document = open_document(options.scene, gl::query_caps(), choose, nullptr, {}, options.access);
    if (!document->runtime) {
        fmt::print(stderr, "{}", snell::render(document->diagnostics, document->sources));
        return exit_input;
    }
    for (const std::string& set : options.sets) set_control(document->controls, document->scene(), set, problems);
    // A value may be missing because of an error in the scene.
    Diagnostics said;
    for (const Diagnostic& diagnostic : document->diagnostics.items())
        if (diagnostic.severity == Severity::error) said.add(diagnostic);
    said.append(problems);
    fmt::print(stderr, "{}", snell::render(said, document->sources));
    if (problems.has_errors()) return exit_input;

    const Saved saved = saved_values(*document);
    if (!saved.error.empty()) return complain(exit_input, saved.error);
    for (const Unwritten& value : saved.unwritten) complain(fmt::format("{}: {}", value.name, value.reason));
    if (!saved.unwritten.empty()) return exit_input;
    if (!options.output.empty()) {
        if (const Exit wrong = write_copy(*document, saved, options.output); wrong != exit_fine) return wrong;
    } else if (const std::string error = write_saved(saved.files); !error.empty()) {
        return complain(exit_input, error);
    }
    return said.has_errors() ? exit_input : exit_fine;
}

}  // namespace

Run add_save(CLI::App& command) {
    auto options = std::make_shared<SaveOptions>();
    command.add_option("SCENE", options->scene)->required();
    add_access(command, options->access);
    add_timeout(command, options->timeout, "reading the scene");
    add_values(command, options->sets, options->ladders);
    command.add_option("-o,--output", options->output, "write another file than the scene itself");
    add_context(command, options->context);
    return [options] { return save(*options); };
}

}  // namespace snell::app
