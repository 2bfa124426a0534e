// snell_stability RECORDS REPOSITORY  writes docs/stability.md from what the tests measured
// snell_stability --check REPOSITORY  fails when it does not have every case that a test declares, or one that none
// does
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "tools/stability/record.h"

namespace {

namespace fs = std::filesystem;
using snell::stability::Record;

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

// However a call is broken into lines.
std::string without_blanks(std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    return text;
}

// What stands between each `before` and the next `after`.
void collect(const std::string& text, const std::string& before, char after, std::set<std::string>& found) {
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
        const std::size_t begin = at + before.size(), end = text.find(after, begin);
        if (end != std::string::npos && end - begin < 5) found.insert(text.substr(begin, end - begin));
    }
}

int report(const std::set<std::string>& some, const std::set<std::string>& others, const char* message) {
    int wrong = 0;
    for (const std::string& number : some)
        if (!others.contains(number)) {
            std::fprintf(stderr, "hard case %s %s\n", number.c_str(), message);
            ++wrong;
        }
    return wrong;
}

int check(const fs::path& root) {
    std::set<std::string> declared, shown, all;
    for (const auto& entry : fs::recursive_directory_iterator(root / "tests"))
        if (entry.path().extension() == ".cpp")
            collect(without_blanks(read(entry.path())), "hard_case({\"", '"', declared);
    collect(read(root / "docs/stability.md"), "\n| ", ' ', shown);
    shown.erase("no.");
    for (const int n : snell::stability::missing({})) all.insert(std::to_string(n));
    int wrong = report(all, declared, "has no test");
    wrong += report(declared, shown, "is not in docs/stability.md: run ./dev stability");
    wrong += report(shown, declared, "is in docs/stability.md, but no test declares it: run ./dev stability");
    return wrong > 0 ? 1 : 0;
}

int write(const fs::path& folder, const fs::path& root) {
    std::vector<Record> records;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        std::ifstream in(entry.path());
        std::string line;
        std::getline(in, line);
        if (const auto record = snell::stability::from_line(line)) records.push_back(*record);
    }
    int status = 0;
    for (const int n : snell::stability::missing(records)) {
        std::fprintf(stderr, "hard case %d: no test measured it\n", n);
        status = 1;
    }
    std::ofstream out(root / "docs/stability.md", std::ios::binary);
    out << snell::stability::page(std::move(records));
    return out.flush() ? status : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: snell_stability RECORDS|--check REPOSITORY\n");
        return 2;
    }
    return std::string(argv[1]) == "--check" ? check(argv[2]) : write(argv[1], argv[2]);
}
