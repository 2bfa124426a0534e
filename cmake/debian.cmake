# Run by CPack on the files of the package before they are packed: Debian wants manual pages compressed, and a changelog in
# its own format.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE files ${CPACK_TEMPORARY_DIRECTORY}/*.1 ${CPACK_TEMPORARY_DIRECTORY}/CHANGELOG.md)
set(changes ${files})
list(FILTER changes INCLUDE REGEX "/doc/snell/CHANGELOG\\.md$")
get_filename_component(folder ${changes} DIRECTORY)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${folder}/changelog "${CPACK_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * CHANGELOG.md in this folder lists what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
list(FILTER files INCLUDE REGEX "/man1/[^/]*$")
execute_process(COMMAND gzip -9n ${files} ${folder}/changelog COMMAND_ERROR_IS_FATAL ANY)
