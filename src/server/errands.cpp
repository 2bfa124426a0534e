#include "src/server/errands.h"

#include "src/content/json.h"
#include "src/content/uri.h"

namespace snell::server {

void Errands::go_on() {
    if (const auto result = background_.poll()) report(*result);
    if (background_.busy() || state_.wanted.empty()) return;
    const Errand errand = state_.wanted.front();
    state_.wanted.pop_front();
    const auto work = [&] {
        if (!state_.services.run) return std::string();
        const Outcome outcome = state_.services.run(errand, state_.documents.access());
        return text_of({{"file", outcome.file}, {"message", outcome.message}, {"failed", outcome.failed}});
    };
    if (!background_.start(work, std::chrono::minutes(2))) report("");
}

void Errands::report(const std::string& result) {
    const Json outcome = content::parse_json(result);
    const bool read = outcome.is_object();
    const std::string file = read ? string_at(outcome, "file") : "";
    const std::string message = read ? string_at(outcome, "message") : "snell ended before it was done";
    if (!file.empty() && state_.can("/window/showDocument/support"))
        state_.ask("window/showDocument",
                   {{"uri", content::uri_of_path(file)}, {"external", false}, {"takeFocus", false}});
    else if (!message.empty())
        state_.notify("window/showMessage",
                      {{"type", !read || outcome.at("failed") == true ? 1 : 3}, {"message", message}});
}

}  // namespace snell::server
