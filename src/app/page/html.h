// Fills the page that `./dev web` builds.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace snell::app {

// Finds a file of the browser's part: in the folder $SNELL_WEB, in ../share/snell/web of the program's folder, or in
// build/web of the tree that the program was built in. Returns an empty string and sets `error` if it is not there.
std::string web_file(const std::string& name, std::string& error);

// JSON that may stand in a script element.
std::string script_json(const nlohmann::ordered_json& json);

// Of a script or style, as a Content-Security-Policy names it: SHA-256 in base64.
std::string policy_hash(std::string_view text);

struct PageData {
    std::string title;
    std::string scene;    // script_json()
    std::string archive;  // base64
    bool runtime = true;  // false: pictures need none
};

// Returns nullopt if the template has not exactly one place for each of them.
std::optional<std::string> filled_page(std::string_view page, const PageData& data);
// True for a page that shares its runtime with others, as those of a gallery do.
bool is_gallery_page(std::string_view page);

}  // namespace snell::app
