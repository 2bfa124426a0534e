# Writes OUT: the definition of snell's FUNCTION, which HEADER declares: all of FILES, whatever bytes they have, by their
# paths below ROOT.
set(rows "")
foreach(file IN LISTS FILES)
  file(READ ${file} bytes HEX)
  file(SIZE ${file} size)
  file(RELATIVE_PATH name ${ROOT} ${file})
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
  string(APPEND rows "    {\"${name}\", {\"${bytes}\", ${size}}},\n")
endforeach()
file(WRITE ${OUT} "#include \"${HEADER}\"

#include <array>

namespace snell {

std::span<const app::TemplateFile> ${FUNCTION}() {
    static constexpr auto files = std::to_array<app::TemplateFile>({
${rows}    });
    return files;
}

}  // namespace snell
")
