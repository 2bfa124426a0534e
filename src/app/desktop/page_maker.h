// Makes pages by `snell web` in a process of its own, because a browser's OpenGL needs another context than the window.
#pragma once

#include <string>
#include <vector>

#include "src/content/process.h"

namespace snell {

// The name of a page's file: with .html at the end unless it ends with .html or .htm.
std::string page_file(const std::string& name);

class PageMaker {
public:
    bool busy() const { return process_.running(); }
    // Starts it for page_file(page), with these arguments after those of the page. Returns "" or the error: a file is
    // replaced only if it is named in full.
    std::string start(const std::string& page, const std::vector<std::string>& arguments);
    // Call it regularly while busy(). Returns what the status line says once the process has ended, otherwise "".
    std::string look();

private:
    content::Process process_;  // ends with the object; a page that was there stays as it was
    std::string page_;
};

}  // namespace snell
