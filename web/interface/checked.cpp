#include "web/interface/checked.h"

#include <utility>

#include "src/lint/lint.h"
#include "src/plan/plan.h"
#include "src/plan/texts.h"
#include "web/interface/open_scene.h"

namespace snell::web {

Document checked(const std::string& path) {
    Document document;
    document.path = path;
    document.files = std::make_unique<Files>(scene_folder(path), page_access({}));
    if (const auto plan = read_plan(path, *document.files, document.sources, document.diagnostics))
        document.diagnostics.append(lint::check(*plan, document.sources, shader_includes(*document.files)));
    document.diagnostics.sort();
    return document;
}

}  // namespace snell::web
