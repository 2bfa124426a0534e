#include "src/app/desktop/page_maker.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "parser/text/words.h"
#include "src/plan/locate.h"

namespace snell {

namespace {

constexpr std::size_t most_output = 1 << 20;  // bytes

// The first line of the output with this text; "" if there is none.
std::string line_with(const std::string& output, std::string_view text) {
    const std::size_t found = output.find(text);
    if (found == output.npos) return {};
    const std::size_t at = found == 0 ? 0 : output.rfind('\n', found) + 1;  // npos + 1 is 0
    return utf8::printable(output.substr(at, output.find('\n', at) - at));
}

}  // namespace

std::string page_file(const std::string& name) {
    return has_extension(name, "html") || has_extension(name, "htm") ? name : name + ".html";
}

std::string PageMaker::start(const std::string& page, const std::vector<std::string>& arguments) {
    page_ = page_file(page);
    std::error_code none;
    if (page_ != page && std::filesystem::exists(page_, none))
        return fmt::format("{} exists: give its whole name to replace it",
                           utf8::printable(std::filesystem::path(page_).filename().string()));
    std::vector<std::string> words{"/proc/self/exe", "web", "-o", page_};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return process_.start(words, {.most_output = most_output, .captured = true});
}

std::string PageMaker::look() {
    const auto ended = process_.poll();
    if (!ended) return {};
    const std::string& said = ended->output;
    const std::string name = utf8::printable(std::filesystem::path(page_).filename().string());
    if (ended->status != 0) return fmt::format("{} is not saved: {}", name, line_with(said, "error: "));
    const std::string line = line_with(said, " redistributes ");
    const std::size_t told = line.find(name);
    return "saved " +
           (told == line.npos ? name : line.substr(told, line.size() - told - (line.ends_with(':') ? 1 : 0)));
}

}  // namespace snell
