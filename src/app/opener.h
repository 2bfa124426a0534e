// Serves what the user wants of files: other scenes, folders to look into, editors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/app/editor.h"
#include "src/app/settings.h"
#include "src/ui/state.h"

namespace snell {

class Opener {
public:
    // `file`: where settings are kept.
    explicit Opener(std::string file) : file_(std::move(file)), kept_(read_settings(file_)), settings_(kept_) {}

    const Settings& settings() const { return settings_; }
    // `in_use` and `revision` are the session's; the rows are made when the latter changes.
    void tell(ui::Facts& facts, const std::string& scene, const std::vector<std::string>& in_use);
    // The scene that is to be opened, if one is. Says in `notice` what became of the rest.
    std::optional<std::string> serve(const ui::Requests& requests, const std::string& scene, ui::Memory& memory);
    // The same for files that were dropped on the window: the first scene among them, or a folder to look into.
    std::optional<std::string> serve_dropped(const std::vector<std::string>& paths, ui::Memory& memory);
    // To be called now and then: ended editors; settings that changed are written, and all the scenes that were open.
    // True: `memory.notice` says something new.
    bool look(ui::Memory& memory);
    void opened(const std::string& scene);
    // In the window's coordinates at zoom 1 and 96 dots per inch.
    void resized(int width, int height);
    void write();

private:
    std::optional<std::string> scene_at(const std::string& path, ui::Memory& memory);

    std::string file_;
    Settings kept_, settings_;
    Editor editor_;
    ui::Listing listing_;
    std::vector<ui::FileRow> rows_;
    std::string rows_of_;                        // the scene
    std::uint64_t rows_at_ = ~std::uint64_t{0};  // the revision
};

}  // namespace snell
