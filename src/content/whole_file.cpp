#include "src/content/whole_file.h"

#include <fstream>
#include <iterator>

namespace snell::content {

std::string whole_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace snell::content
