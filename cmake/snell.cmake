# For the native program and for the browser's, whose CMakeLists.txt say where the libraries are.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH SNELL_ROOT)

# Warnings and sanitizers for every target of ours.
add_library(snell_options INTERFACE)
target_include_directories(snell_options INTERFACE ${SNELL_ROOT} ${PROJECT_BINARY_DIR}/generated)
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

# A quarter of the time that a full build takes goes into reading the standard library. GCC reads it once; other
# compilers do without, and tell of headers that a file forgets to include.
function(snell_precompile target owner)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()
# snell_precompiled(NAME headers…): a target that only carries them.
function(snell_precompiled name)
  add_library(${name} STATIC ${SNELL_ROOT}/cmake/std.cpp)
  target_link_libraries(${name} PUBLIC snell_options)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_precompile_headers(${name} PRIVATE <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits>
      <map> <memory> <optional> <span> <string> <string_view> <utility> <vector> ${ARGN})
  endif()
endfunction()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # ccache asks for the first. The warnings are GCC 12's bug 105651 again, which precompiled headers bring out.
  target_compile_options(snell_options INTERFACE -fpch-preprocess -Wno-array-bounds -Wno-stringop-overflow
    -Wno-stringop-overread)
endif()
snell_precompiled(snell_std)
snell_precompiled(snell_std_fmt <fmt/format.h>)
target_link_libraries(snell_std_fmt PUBLIC fmt::fmt)

# Links the static library of a package where there is one: what is loaded at every start costs a third of a millisecond.
function(snell_static target)
  get_target_property(libraries ${target} INTERFACE_LINK_LIBRARIES)
  foreach(library IN LISTS libraries)
    string(REGEX REPLACE "[.]so$" ".a" static "${library}")
    if(EXISTS "${static}")
      list(TRANSFORM libraries REPLACE "^${library}$" "${static}")
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES INTERFACE_LINK_LIBRARIES "${libraries}")
endfunction()

# What runs once, or waits for the disk or a person: -O1 builds in four fifths of the time.
function(snell_cold target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# snell_together(TARGET [ROOM+ROOM…]…): the files of a room, or of rooms that are named together, are compiled as one:
# they share headers, and templates that several of them use are instantiated once. Names in their anonymous namespaces
# must differ, or snell_alone lists the file.
option(SNELL_TOGETHER "Compile the files of a room as one: full builds are quicker, small changes slower" ON)
function(snell_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SNELL_TOGETHER} UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH room)
    foreach(rooms IN LISTS ARGN)
      if("+${rooms}+" MATCHES "[+]${room}[+]")
        set(room ${rooms})
        break()
      endif()
    endforeach()
    string(MAKE_C_IDENTIFIER "${room}" room)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "room_${room}")
  endforeach()
endfunction()
function(snell_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# snell_library(NAME libraries…): every .cpp of the calling folder and its rooms, without those whose names SNELL_WITHOUT
# (regular expressions) lists.
function(snell_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)
  foreach(pattern "(^|/)(main|oiio|cairo|libarchive)\\.cpp$" ${SNELL_WITHOUT})
    list(FILTER sources EXCLUDE REGEX "${pattern}")
  endforeach()
  add_library(${name} STATIC ${sources})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${name} PUBLIC snell_options ${ARGN})
  if("fmt::fmt" IN_LIST ARGN)
    snell_precompile(${name} snell_std_fmt)
  else()
    snell_precompile(${name} snell_std)
  endif()
endfunction()
