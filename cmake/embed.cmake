# Writes OUT: the definition of snell's FUNCTION, which HEADER declares: the text of each of FILES, by its path below ROOT.
set(text "#include \"${HEADER}\"\n\nnamespace snell {\n\nstd::string_view ${FUNCTION}(std::string_view path) {\n")
foreach(file IN LISTS FILES)
  file(READ ${file} content)
  file(RELATIVE_PATH name ${ROOT} ${file})
  string(APPEND text "    if (path == \"${name}\") return R\"snell_text(${content})snell_text\";\n")
endforeach()
string(APPEND text "    return {};\n}\n\n}  // namespace snell\n")
file(WRITE ${OUT} "${text}")
