// Names of the pages of a gallery.
#pragma once

#include <string>
#include <vector>

namespace snell::app {

// A scene, and the file name of its page.
struct Exhibit {
    std::string scene, folder;  // `folder`: the one that was named
    std::string page;
};

// Names each page after its scene. Scenes that would have one name get the names of their folders, too, and a number if
// that is not enough; the names of all other scenes do not depend on them. Upper and lower case are the same name,
// because folders move to systems that do not tell them apart.
void name_pages(std::vector<Exhibit>& exhibits);

}  // namespace snell::app
