# carina_module(NAME [MOC] SOURCES file... LINK target... [PRIVATE target...])
#
# One library per module. NAME engine_core becomes the target carina_engine_core with the alias
# Carina::engine_core. LINK holds exactly what the module's row of the include table permits.
function(carina_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "MOC" "" "SOURCES;LINK;PRIVATE")
  set(target carina_${name})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(Carina::${name} ALIAS ${target})
  target_link_libraries(${target} PUBLIC carina_flags ${arg_LINK} PRIVATE ${arg_PRIVATE})
  if(arg_MOC)
    set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOUIC ON)
  endif()
endfunction()

# carina_tests(NAME SOURCES file... LINK target... [DISPLAY test...] [SLOW test...])
#
# One program, test_NAME, of the test classes of one folder, compiled a few at a time. Each class is
# a test of ctest, in a process of its own and named after its file: of tests/engine/core/tst_ids.cpp
# "engine.core.ids". DISPLAY names those that draw with OpenGL: they run under Xvfb with xcb; all
# others run with QT_QPA_PLATFORM=offscreen. SLOW names those that only `./carina test --all` runs. A
# tst_*.cpp of the folder and its rooms that is not among the sources is an error, as is a name after
# DISPLAY or SLOW that no source has.
function(carina_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;DISPLAY;SLOW")
  carina_check_tests("${arg_SOURCES}" "${arg_DISPLAY};${arg_SLOW}")
  set(program test_${name})
  add_executable(${program} ${arg_SOURCES} "${PROJECT_SOURCE_DIR}/tests/support/test_main.cpp")
  # Of what a test costs to compile, half is templates of Eigen that the next test needs, too.
  set_target_properties(${program} PROPERTIES AUTOMOC ON UNITY_BUILD_BATCH_SIZE 20)
  if(CARINA_UNITY_TESTS)
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON)
  endif()
  target_compile_options(${program} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(${program} PRIVATE carina_flags Qt6::Test ${arg_LINK})
  target_compile_definitions(${program} PRIVATE CARINA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  foreach(source ${arg_SOURCES})
    cmake_path(GET source STEM stem)
    if(stem MATCHES "^tst_(.*)")
      carina_test_of(${program} "${source}" ${CMAKE_MATCH_1})
    endif()
  endforeach()
endfunction()

function(carina_check_tests sources named)
  file(GLOB_RECURSE there RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS tst_*.cpp)
  file(GLOB_RECURSE modules RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" */CMakeLists.txt)
  set(stems)
  foreach(source ${there})
    cmake_path(GET source STEM stem)
    list(APPEND stems ${stem})
    set(isOfAnother OFF)
    foreach(module ${modules})
      cmake_path(GET module PARENT_PATH folder)
      if(source MATCHES "^${folder}/")
        set(isOfAnother ON)
      endif()
    endforeach()
    if(CARINA_DESKTOP AND NOT isOfAnother AND NOT source IN_LIST sources)
      message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}/${source} is in no list of tests")
    endif()
  endforeach()
  foreach(test ${named})
    if(NOT tst_${test} IN_LIST stems)
      message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}: there is no tst_${test}.cpp")
    endif()
  endforeach()
endfunction()

# One class of such a program, for ctest.
macro(carina_test_of program source class)
  cmake_path(GET source PARENT_PATH folder)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}/tests"
             OUTPUT_VARIABLE test)
  cmake_path(APPEND test "${folder}" ${class})
  string(REPLACE "/" "." test "${test}")
  set(platform offscreen)
  set(display)
  if(${class} IN_LIST arg_DISPLAY)
    set(platform xcb)
    set(display "${PROJECT_SOURCE_DIR}/tests/support/with_display")
  endif()
  set(label fast)
  set(timeout 240)
  set(patience)
  if(${class} IN_LIST arg_SLOW) # by itself Qt Test gives a function five minutes
    set(label slow)
    set(timeout 600)
    set(patience ";QTEST_FUNCTION_TIMEOUT=7200000")
  endif()
  if(CARINA_SANITIZER) # ten times as slow
    set(timeout 1200)
    set(patience ";QTEST_FUNCTION_TIMEOUT=1200000")
  endif()
  add_test(NAME ${test} COMMAND ${display} $<TARGET_FILE:${program}> ${class})
  set_tests_properties(${test} PROPERTIES LABELS ${label} TIMEOUT ${timeout}
    ENVIRONMENT "QT_QPA_PLATFORM=${platform};QT3D_RENDERER=opengl;LIBGL_ALWAYS_SOFTWARE=1${patience}")
endmacro()
