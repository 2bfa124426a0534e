// What `snell new` and the window make new folders of: one kind of scene for each subject that scenes are written
// about.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace snell::app {

// A file of templates/, which the build embeds.
struct TemplateFile {
    std::string_view path;  // below templates/, such as "refract/glass.frag"
    std::string_view bytes;
};
std::span<const TemplateFile> template_files();

struct Kind {
    std::string_view name;     // that of its folder, and of the scene in it
    std::string_view summary;  // completes "a scene of …"
    std::string_view words;    // those of a folder's name that choose this kind, between blanks
    std::string_view borrows;  // files of other kinds that belong to it, too: the beginning of their paths; may be ""
};
std::span<const Kind> kinds();

// A kind that a name asks for, and the word in it that does.
struct Choice {
    const Kind* kind;
    std::string word;
};
// One if the name is clear, none if no word of it is one of a kind's, or several that disagree.
std::vector<Choice> kinds_for(std::string_view name);
// The kind's word that is most like one of the name's; "" if none is near.
std::string_view nearest_word(std::string_view name);

// A file of a new folder: its path below the folder, and its bytes.
struct NewFile {
    std::string path;
    std::string_view bytes;
};
// The scene is the first one, and is called `stem`.glib.
std::vector<NewFile> files_of(const Kind& kind, std::string_view stem);

// Writes the files into a folder next to the new one's place, and renames it, so that the new one is there as a whole
// or not at all. Folders above it that do not exist are made. Returns "" or what went wrong.
std::string write_folder(const std::filesystem::path& folder, const std::vector<NewFile>& files);

}  // namespace snell::app
