# Each dependency is looked for on the system first, else fetched at a version pinned by hash.
# The preset "fetch" looks for none of them. Those that are only headers get their target from us, so that nothing of
# their own builds runs; GLFW builds itself.
include(FetchContent)
set(FETCHCONTENT_QUIET ON)

# header_only(TARGET FETCHED_NAME SUBDIR): the target of fetched headers, unless the system had it.
function(header_only target fetched subdir)
  if(TARGET ${target})
    return()
  endif()
  FetchContent_GetProperties(${fetched} SOURCE_DIR source)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${source}${subdir}")
endfunction()

FetchContent_Declare(Eigen3 # 3.4.0
  GIT_REPOSITORY https://gitlab.com/libeigen/eigen.git
  GIT_TAG 3147391d946bb4b6c68edd901f2add6ac1f31f8c
  SOURCE_SUBDIR headers-only
  FIND_PACKAGE_ARGS 3.4 CONFIG)
FetchContent_Declare(nlohmann_json
  URL https://github.com/nlohmann/json/releases/download/v3.11.2/json.tar.xz
  URL_HASH SHA256=8c4b26bf4b422252e13f332bc5e388ec0ab5c3443d24399acb675e68278d341f
  SOURCE_SUBDIR headers-only
  FIND_PACKAGE_ARGS 3.11 CONFIG)
FetchContent_MakeAvailable(Eigen3 nlohmann_json)
header_only(Eigen3::Eigen Eigen3 "")
header_only(nlohmann_json::nlohmann_json nlohmann_json "/include")

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

if(CREMONA_METIS)
  find_package(METIS MODULE)
endif()
if(CREMONA_CHOLMOD)
  find_package(CHOLMOD MODULE)
endif()

if(CREMONA_APPS)
  FetchContent_Declare(glfw3 # 3.3.8
    GIT_REPOSITORY https://github.com/glfw/glfw.git
    GIT_TAG 7482de6071d21db77a7236155da44c172a7f6c9e
    FIND_PACKAGE_ARGS 3.3 CONFIG)
  FetchContent_Declare(ImGui
    URL https://github.com/ocornut/imgui/archive/v1.86.tar.gz
    URL_HASH SHA256=6ba6ae8425a19bc52c5e067702c48b70e4403cd339cba02073a462730a63e825
    SOURCE_SUBDIR has-no-build-of-its-own
    FIND_PACKAGE_ARGS MODULE)
  FetchContent_Declare(CLI11
    URL https://github.com/CLIUtils/CLI11/archive/v2.1.2.tar.gz
    URL_HASH SHA256=26291377e892ba0e5b4972cdfd4a2ab3bf53af8dac1f4ea8fe0d1376b625c8cb
    SOURCE_SUBDIR headers-only
    FIND_PACKAGE_ARGS 2.1 CONFIG)
  FetchContent_Declare(pugixml
    URL https://github.com/zeux/pugixml/archive/v1.13.tar.gz
    URL_HASH SHA256=5c5ad5d7caeb791420408042a7d88c2c6180781bf218feca259fd9d840a888e1
    SOURCE_SUBDIR has-no-build-of-its-own
    FIND_PACKAGE_ARGS 1.13 CONFIG)
  foreach(part DOCS TESTS EXAMPLES INSTALL)
    set(name GLFW_BUILD_${part})
    if(part STREQUAL "INSTALL")
      set(name GLFW_INSTALL)
    endif()
    set(${name} OFF CACHE INTERNAL "GLFW alone, as a static library")
  endforeach()
  FetchContent_MakeAvailable(glfw3 ImGui CLI11 pugixml)
  header_only(CLI11::CLI11 CLI11 "/include")

  if(NOT TARGET imgui::imgui)
    FetchContent_GetProperties(ImGui SOURCE_DIR imgui_source)
    add_library(imgui STATIC EXCLUDE_FROM_ALL
      ${imgui_source}/imgui.cpp ${imgui_source}/imgui_draw.cpp ${imgui_source}/imgui_tables.cpp
      ${imgui_source}/imgui_widgets.cpp ${imgui_source}/misc/cpp/imgui_stdlib.cpp
      ${imgui_source}/backends/imgui_impl_glfw.cpp)
    target_include_directories(imgui SYSTEM PUBLIC
      ${imgui_source} ${imgui_source}/misc/cpp ${imgui_source}/backends)
    target_link_libraries(imgui PRIVATE glfw)
    add_library(imgui::imgui ALIAS imgui)
  endif()

  if(NOT TARGET pugixml::pugixml)
    FetchContent_GetProperties(pugixml SOURCE_DIR pugixml_source)
    add_library(pugixml STATIC EXCLUDE_FROM_ALL ${pugixml_source}/src/pugixml.cpp)
    target_include_directories(pugixml SYSTEM PUBLIC ${pugixml_source}/src)
    add_library(pugixml::pugixml ALIAS pugixml)
  endif()

  # These come with every desktop and are not fetched.
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
  pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET freetype2)
  pkg_check_modules(PHOTOS REQUIRED IMPORTED_TARGET libpng libturbojpeg)
endif()

if(BUILD_TESTING)
  FetchContent_Declare(doctest # 2.4.9
    GIT_REPOSITORY https://github.com/doctest/doctest.git
    GIT_TAG b7c21ec5ceeadb4951b00396fc1e4642dd347e5f
    SOURCE_SUBDIR headers-only
    FIND_PACKAGE_ARGS 2.4 CONFIG)
  FetchContent_MakeAvailable(doctest)
  header_only(doctest::doctest doctest "")
  # The system's own Python has the modules of packages.txt; another that comes first in PATH may not.
  if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python3_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python3 COMPONENTS Interpreter REQUIRED)
endif()
