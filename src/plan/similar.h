// Which file was probably meant by a name that leads nowhere.
#pragma once

#include <string_view>
#include <vector>

namespace snell {

// True if an existing file may be what an argument of these `extensions` takes. An extension that says nothing about
// the kind of file must be the one that was asked for.
bool same_kind(std::string_view file, std::string_view asked, const std::vector<std::string_view>& extensions);

// The file whose name is nearest to `asked`, if so few letters differ that it was probably meant; otherwise empty.
// Extensions count little: same_kind() has decided about them.
std::string_view nearest_file(std::string_view asked, const std::vector<std::string_view>& files);

}  // namespace snell
