# Compiler flags of everything that is ours, in one interface target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(CARINA_CCACHE ccache)
if(CARINA_CCACHE)
  # Without these two it does not cache what uses a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros "${CARINA_CCACHE}")
endif()

add_library(carina_flags INTERFACE)
target_include_directories(carina_flags INTERFACE "${PROJECT_SOURCE_DIR}")
target_compile_definitions(carina_flags INTERFACE
  QT_NO_KEYWORDS QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_DISABLE_DEPRECATED_BEFORE=0x060400)
# Folds are deterministic: no fast-math, and no fused multiply-add that another compiler may not use.
target_compile_options(carina_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
  -Woverloaded-virtual -Wconversion -Wno-sign-conversion -ffp-contract=off)
if(CARINA_WARNINGS_AS_ERRORS)
  target_compile_options(carina_flags INTERFACE -Werror)
endif()
if(CARINA_SANITIZER STREQUAL "address")
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
elseif(CARINA_SANITIZER STREQUAL "thread")
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
endif()
# moc reads these headers of the standard library without the ones they start from, and stops at
# their first line; with their guards set it passes over them.
set(CMAKE_AUTOMOC_MOC_OPTIONS -D_COMPARE -D_GLIBCXX_CONCEPTS -D_GLIBCXX_NUMBERS)
if(CARINA_FUZZERS)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
