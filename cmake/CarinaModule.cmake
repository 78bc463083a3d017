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
    set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOUIC ON
      AUTOUIC_SEARCH_PATHS "${PROJECT_SOURCE_DIR}/ui")
  endif()
endfunction()

# What nearly every test includes, precompiled once for all of them. Not <QTest>, which depends on
# definitions that differ from test to test. Modules do without: their unity builds are as fast alone
# (docs/decisions/0005-unity-and-precompiled-headers.md).
function(carina_precompile_for_tests target)
  if(NOT CARINA_PRECOMPILED_HEADERS)
    return()
  endif()
  if(NOT TARGET carina_test_headers)
    file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/test_headers.cpp" CONTENT "")
    add_library(carina_test_headers STATIC "${CMAKE_BINARY_DIR}/test_headers.cpp")
    target_link_libraries(carina_test_headers PRIVATE carina_flags Eigen3::Eigen tl::expected Qt6::Core)
    target_precompile_headers(carina_test_headers PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm>
      <array> <chrono> <cmath> <functional> <map> <memory> <optional> <span> <string> <variant> <vector>
      <tl/expected.hpp> <QDateTime> <QHash> <QMap> <QMetaEnum> <QObject> <QPointF> <QRectF>
      <QStringList> <QTemporaryFile> <QUrl> <QVariant>)
  endif()
  target_precompile_headers(${target} REUSE_FROM carina_test_headers)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>) # for ccache
endfunction()

# carina_test(NAME SOURCES file... LINK target... [LABELS label...] [DISPLAY])
#
# One Qt Test program per class, run by ctest under its own name. DISPLAY marks a test that draws
# with OpenGL: it runs under Xvfb with xcb; all others run with QT_QPA_PLATFORM=offscreen. A program
# of which nothing ran but its set-up and clean-up is reported as skipped.
function(carina_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "DISPLAY" "" "SOURCES;LINK;LABELS")
  add_executable(test_${name} ${arg_SOURCES})
  set_target_properties(test_${name} PROPERTIES AUTOMOC ON)
  target_link_libraries(test_${name} PRIVATE carina_flags Qt6::Test ${arg_LINK})
  target_compile_definitions(test_${name} PRIVATE CARINA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  carina_precompile_for_tests(test_${name})
  if(arg_DISPLAY)
    set(platform xcb)
    add_test(NAME ${name} COMMAND "${PROJECT_SOURCE_DIR}/tests/support/with_display"
             $<TARGET_FILE:test_${name}>)
  else()
    set(platform offscreen)
    add_test(NAME ${name} COMMAND test_${name})
  endif()
  set(labels ${arg_LABELS})
  if(NOT labels)
    set(labels fast)
  endif()
  set_tests_properties(${name} PROPERTIES LABELS "${labels}" TIMEOUT 120
    SKIP_REGULAR_EXPRESSION "Totals: [12] passed, 0 failed, [1-9][0-9]* skipped"
    ENVIRONMENT "QT_QPA_PLATFORM=${platform};QT3D_RENDERER=opengl;LIBGL_ALWAYS_SOFTWARE=1")
endfunction()
