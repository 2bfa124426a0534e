// snell_manual FOLDER DATE: writes manual pages, of that date, and completions for shells into FOLDER.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "src/app/help/program.h"
#include "src/app/open/version.h"
#include "tools/manual/manual.h"

int main(int argc, char** argv) {
    using namespace snell;
    if (argc != 3) {
        std::fprintf(stderr, "usage: snell_manual FOLDER DATE\n");
        return 2;
    }
    CLI::App program;
    app::Request request;
    app::describe(program, request);
    const std::vector<manual::Command> commands = manual::described(program);
    std::vector<manual::File> files = manual::pages(commands, version(), argv[2]);
    files.push_back({"bash/snell", manual::bash(commands)});
    files.push_back({"zsh/_snell", manual::zsh(commands)});
    files.push_back({"fish/snell.fish", manual::fish(commands)});
    for (const manual::File& file : files) {
        const std::filesystem::path path = std::filesystem::path(argv[1]) / file.path;
        std::error_code error;
        std::filesystem::create_directories(path.parent_path(), error);
        if (!(std::ofstream(path, std::ios::binary) << file.text)) {
            std::fprintf(stderr, "%s cannot be written\n", path.c_str());
            return 1;
        }
    }
}
