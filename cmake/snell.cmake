# Warnings and sanitizers for every target of ours.
add_library(snell_options INTERFACE)
target_include_directories(snell_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
# GCC 12's full -Wshadow also objects to enumerators of an enum class named like something global, and its
# -Wrestrict to assigning a literal to a string (GCC bug 105651).
target_compile_options(snell_options INTERFACE
  -Wall -Wextra -Wpedantic $<IF:$<CXX_COMPILER_ID:GNU>,-Wshadow=local;-Wno-restrict,-Wshadow> -Wswitch -Wnon-virtual-dtor -Wno-missing-field-initializers $<$<BOOL:${SNELL_WERROR}>:-Werror>)
if(SNELL_SANITIZE)
  target_compile_options(snell_options INTERFACE -fsanitize=${SNELL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(snell_options INTERFACE -fsanitize=${SNELL_SANITIZE})
endif()
if(SNELL_FUZZ)
  # The libraries tell the fuzzer which of their branches an input took.
  target_compile_options(snell_options INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(snell_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# snell_library(NAME libraries…): every .cpp of the calling folder.
function(snell_library name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(${name} STATIC ${sources})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${name} PUBLIC snell_options ${ARGN})
endfunction()
