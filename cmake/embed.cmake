# Writes OUT: one string literal for each of FILES, looked up by path below ROOT.
set(text "#include \"shaders/embedded.h\"\n\nnamespace snell {\n\nstd::string_view embedded_shader(std::string_view path) {\n")
foreach(file IN LISTS FILES)
  file(READ ${file} content)
  file(RELATIVE_PATH name ${ROOT} ${file})
  string(APPEND text "    if (path == \"${name}\") return R\"snell_glsl(${content})snell_glsl\";\n")
endforeach()
string(APPEND text "    return {};\n}\n\n}  // namespace snell\n")
file(WRITE ${OUT} "${text}")
