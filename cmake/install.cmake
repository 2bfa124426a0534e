# What `cmake --install` puts where. The program finds its module and its pages relative to itself (src/content/image/module.cpp,
# src/app/page/page.cpp), so the prefix may be moved.
include(GNUInstallDirs)
set(data ${CMAKE_INSTALL_DATADIR}/snell)
set(page ${CMAKE_INSTALL_DATADIR}/doc/snell)

install(TARGETS snell RUNTIME DESTINATION bin)
install(TARGETS snell_oiio snell_cairo snell_archive LIBRARY DESTINATION lib/snell)

install(DIRECTORY scenes DESTINATION ${data})
install(DIRECTORY shaders/snell DESTINATION ${data}/shaders)
# The page for browsers, if `./dev web` has built it.
install(CODE "
  foreach(file page.html gallery.html snell.html runtime.js)
    if(EXISTS \"${PROJECT_SOURCE_DIR}/build/web/\${file}\")
      file(INSTALL \"${PROJECT_SOURCE_DIR}/build/web/\${file}\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${data}/web\")
    endif()
  endforeach()")

install(FILES README.md CHANGELOG.md DESTINATION ${page})
install(FILES LICENSE DESTINATION ${page} RENAME copyright)
install(DIRECTORY docs DESTINATION ${page})
# Links of the pages lead to scenes by their paths in the repository.
install(CODE "
  set(link \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${page}/scenes\")
  file(CREATE_LINK ../../snell/scenes \"\${link}\" SYMBOLIC)
  list(APPEND CMAKE_INSTALL_MANIFEST_FILES \"\${CMAKE_INSTALL_PREFIX}/${page}/scenes\")")

# Vim and Neovim look there; the extension for VS Code is there if `./dev editors` has built it.
foreach(folder vim/vimfiles nvim/site)
  install(DIRECTORY docs/editors/vim/ DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder})
endforeach()
install(CODE "
  if(EXISTS \"${PROJECT_SOURCE_DIR}/build/editors/snell.vsix\")
    file(INSTALL \"${PROJECT_SOURCE_DIR}/build/editors/snell.vsix\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${data}/editors\")
  endif()")

install(FILES desktop/snell.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES desktop/snell.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES desktop/snell.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)

# Written by snell_manual.
set(manual ${CMAKE_BINARY_DIR}/manual)
install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(FILES ${manual}/bash/snell DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${manual}/zsh/_snell DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${manual}/fish/snell.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# Parser, translator and runtime for other programs: find_package(snell).
include(CMakePackageConfigHelpers)
foreach(library parser content glsl plan shaders opengl gl runtime document platform)
  install(FILES $<TARGET_FILE:snell_${library}> DESTINATION lib/snell COMPONENT development)
endforeach()
install(DIRECTORY parser DESTINATION include/snell COMPONENT development FILES_MATCHING PATTERN *.h)
foreach(folder content glsl plan gl runtime document platform)
  install(DIRECTORY src/${folder} DESTINATION include/snell/src COMPONENT development
    FILES_MATCHING PATTERN *.h PATTERN web EXCLUDE PATTERN oiio EXCLUDE PATTERN archive EXCLUDE PATTERN forms EXCLUDE)
endforeach()
install(FILES src/content/oiio/api.h DESTINATION include/snell/src/content/oiio COMPONENT development)
install(FILES shaders/embedded.h DESTINATION include/snell/shaders COMPONENT development)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/snellConfigVersion.cmake COMPATIBILITY ExactVersion)
configure_file(cmake/snellConfig.cmake.in ${CMAKE_BINARY_DIR}/snellConfig.cmake COPYONLY)
install(FILES ${CMAKE_BINARY_DIR}/snellConfig.cmake ${CMAKE_BINARY_DIR}/snellConfigVersion.cmake
  DESTINATION lib/cmake/snell COMPONENT development)
install(DIRECTORY examples/embed DESTINATION ${page}/examples)
