#include "web/interface/checked.h"

#include <utility>

#include "src/lint/lint.h"
#include "src/plan/plan.h"
#include "src/plan/texts.h"

namespace snell::web {

Document checked(const std::string& path) {
    Document document;
    document.path = path;
    document.files = std::make_unique<Files>(scene_folder(path));
    auto parsed = parse_document(path, *document.files, document.sources, document.diagnostics);
    if (parsed) {
        const Plan plan = make_plan(std::move(parsed->scene), *document.files, document.sources, document.diagnostics);
        document.diagnostics.append(lint::check(plan, document.sources, shader_includes(*document.files)));
    }
    document.diagnostics.sort();
    return document;
}

}  // namespace snell::web
