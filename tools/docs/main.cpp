// snell_docs REPOSITORY          writes what derives from the table of commands
// snell_docs --check REPOSITORY  fails when a file differs from what would be written
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tools/docs/generate.h"

namespace {

std::string read(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace

int main(int argc, char** argv) {
    const bool check = argc == 3 && std::string(argv[1]) == "--check";
    if (argc != 2 && !check) {
        std::fprintf(stderr, "usage: snell_docs [--check] REPOSITORY\n");
        return 2;
    }
    const std::string root = argv[argc - 1];
    const std::string intro = read(root + "/tools/docs/intro.md");
    if (intro.empty()) {
        std::fprintf(stderr, "no tools/docs/intro.md in %s\n", root.c_str());
        return 1;
    }
    int wrong = 0;
    for (const snell::docs::Document& document : snell::docs::generate(intro)) {
        const std::string path = root + "/" + document.path;
        if (read(path) == document.text) continue;
        if (check) {
            std::fprintf(stderr, "%s is not what the table of commands makes it: run snell_docs %s\n", path.c_str(),
                         root.c_str());
            ++wrong;
            continue;
        }
        std::error_code error;
        std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
        if (!(std::ofstream(path, std::ios::binary) << document.text)) {
            std::fprintf(stderr, "%s cannot be written\n", path.c_str());
            ++wrong;
        }
    }
    return wrong > 0 ? 1 : 0;
}
