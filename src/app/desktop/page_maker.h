// Makes pages by `snell web` in a process of its own, because a browser's OpenGL needs another context than the window.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace snell {

// The name of a page's file: with .html at the end unless it ends with .html or .htm.
std::string page_file(const std::string& name);

class PageMaker {
public:
    PageMaker() = default;
    // Ends the process if it runs; a page that was there stays as it was.
    ~PageMaker();
    PageMaker(const PageMaker&) = delete;
    PageMaker& operator=(const PageMaker&) = delete;

    bool busy() const { return process_ > 0; }
    // Starts it for page_file(page), with these arguments after those of the page. Returns "" or the error: a file is
    // replaced only if it is named in full.
    std::string start(const std::string& page, const std::vector<std::string>& arguments);
    // Call it regularly while busy(). Returns what the status line says once the process has ended, otherwise "".
    std::string look();

private:
    void read();

    pid_t process_ = 0;
    int output_ = -1;
    std::string page_, said_;
};

}  // namespace snell
