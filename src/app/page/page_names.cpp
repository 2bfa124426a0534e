#include "src/app/page/page_names.h"

#include <fmt/format.h>
#include <locale.h>
#include <wctype.h>

#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "parser/text/utf8.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

// Names without regard to case; beyond ASCII, if the system knows the letters.
class CaseFolding {
public:
    CaseFolding() = default;
    ~CaseFolding() {
        if (letters_) freelocale(letters_);
    }
    CaseFolding(const CaseFolding&) = delete;
    CaseFolding& operator=(const CaseFolding&) = delete;

    std::string operator()(std::string_view name) const {
        std::string folded;
        for (std::size_t at = 0; at < name.size();) {
            const utf8::Char c = utf8::decode(name, at);
            at += c.length;
            const auto code = static_cast<wint_t>(c.code);
            utf8::append(folded, static_cast<char32_t>(letters_ ? towlower_l(code, letters_) : towlower(code)));
        }
        return folded;
    }

private:
    locale_t letters_ = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
};

// What an address or a system cannot have in a name becomes '-', and so does a first dot, which would hide the page.
std::string page_name(std::string_view text) {
    constexpr std::string_view refused = "/\\:*?\"<>|#%&";
    std::string name;
    for (std::size_t at = 0; at < text.size();) {
        const utf8::Char c = utf8::decode(text, at);
        const bool bad =
            !c.valid || utf8::hidden(c.code) || refused.find(text[at]) != refused.npos || (at == 0 && c.code == '.');
        name += bad ? "-" : text.substr(at, c.length);
        at += c.length;
    }
    return name;
}

std::string name_of_scene(const Exhibit& exhibit) { return page_name(fs::path(exhibit.scene).stem().string()); }

std::string name_with_folders(const Exhibit& exhibit) {
    const fs::path near = fs::path(exhibit.scene).lexically_relative(fs::path(exhibit.folder).lexically_normal());
    return page_name((near.parent_path() / near.stem()).string());
}

}  // namespace

void name_pages(std::vector<Exhibit>& exhibits) {
    const CaseFolding folded;
    std::map<std::string, int> scenes;
    for (const Exhibit& exhibit : exhibits) ++scenes[folded(name_of_scene(exhibit))];
    std::set<std::string> taken{"index"};
    for (const bool clash : {false, true})
        for (Exhibit& exhibit : exhibits) {
            const std::string own = name_of_scene(exhibit);
            if ((scenes[folded(own)] > 1) != clash) continue;
            const std::string name = clash ? name_with_folders(exhibit) : own;
            std::string unique = name;
            for (int number = 2; !taken.insert(folded(unique)).second; ++number)
                unique = fmt::format("{}-{}", name, number);
            exhibit.page = unique + ".html";
        }
}

}  // namespace snell::app
