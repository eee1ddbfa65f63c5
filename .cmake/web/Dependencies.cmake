# What the page is made of, instead of .cmake/Dependencies.cmake. Libraries that are only headers come from the system; they
# are linked into a folder of their own, since the system's other headers are not the browser's.
set(headers "${PROJECT_BINARY_DIR}/include")
file(MAKE_DIRECTORY "${headers}")

# web_headers(TARGET FOLDER): the headers of the system's /usr/include/FOLDER.
function(web_headers target folder)
  get_filename_component(name "${folder}" NAME)
  file(CREATE_LINK "/usr/include/${folder}" "${headers}/${name}" SYMBOLIC)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${headers}")
endfunction()
web_headers(Eigen3::Eigen eigen3/Eigen)
web_headers(nlohmann_json::nlohmann_json nlohmann)
web_headers(CLI11::CLI11 CLI)
web_headers(doctest::doctest doctest)
web_headers(fast_float::fast_float fast_float)
web_headers(stb::stb stb)
file(GLOB dragonbox RELATIVE /usr/include /usr/include/dragonbox-*/dragonbox)
web_headers(dragonbox::dragonbox "${dragonbox}")
include_directories(SYSTEM "${headers}") # of fast_float and Dragonbox, which libcxx13/charconv reads and writes by

add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)

# For programs of the command line: under node, with the files and the environment of their caller.
add_library(web_console INTERFACE)
target_link_options(web_console INTERFACE -sNODERAWFS=1 -sEXIT_RUNTIME=1 "SHELL:--pre-js ${CMAKE_CURRENT_LIST_DIR}/node.js")

# Dear ImGui, pugixml and FreeType are compiled along, from Debian's source packages (.ci/debian_source.bash).
if(CREMONA_APPS)
  enable_language(C)
  set(CREMONA_IMGUI_SOURCE "" CACHE PATH "The unpacked source package imgui")
  add_library(imgui STATIC EXCLUDE_FROM_ALL
    ${CREMONA_IMGUI_SOURCE}/imgui.cpp ${CREMONA_IMGUI_SOURCE}/imgui_draw.cpp ${CREMONA_IMGUI_SOURCE}/imgui_tables.cpp
    ${CREMONA_IMGUI_SOURCE}/imgui_widgets.cpp ${CREMONA_IMGUI_SOURCE}/misc/cpp/imgui_stdlib.cpp)
  target_include_directories(imgui SYSTEM PUBLIC "${CREMONA_IMGUI_SOURCE}" "${CREMONA_IMGUI_SOURCE}/misc/cpp")
  add_library(imgui::imgui ALIAS imgui)

  set(CREMONA_PUGIXML_SOURCE "" CACHE PATH "The unpacked source package pugixml")
  add_library(pugixml STATIC EXCLUDE_FROM_ALL "${CREMONA_PUGIXML_SOURCE}/src/pugixml.cpp")
  target_include_directories(pugixml SYSTEM PUBLIC "${CREMONA_PUGIXML_SOURCE}/src")
  add_library(pugixml::pugixml ALIAS pugixml)

  # Of FreeType the modules that freetype/ftmodule.h names: outlines of TrueType, light hinting, grey pictures;
  # freetype/ftoption.h says what of these.
  set(CREMONA_FREETYPE_SOURCE "" CACHE PATH "The unpacked source package freetype")
  set(parts base/ftbase base/ftbitmap base/ftdebug base/ftglyph base/ftinit base/ftsystem autofit/autofit sfnt/sfnt smooth/smooth
    truetype/truetype)
  list(TRANSFORM parts PREPEND "${CREMONA_FREETYPE_SOURCE}/src/")
  list(TRANSFORM parts APPEND ".c")
  add_library(freetype STATIC EXCLUDE_FROM_ALL ${parts})
  target_compile_definitions(freetype PRIVATE FT2_BUILD_LIBRARY
    "FT_CONFIG_MODULES_H=\"${CMAKE_CURRENT_LIST_DIR}/freetype/ftmodule.h\""
    "FT_CONFIG_OPTIONS_H=\"${CMAKE_CURRENT_LIST_DIR}/freetype/ftoption.h\"")
  target_include_directories(freetype SYSTEM PUBLIC "${CREMONA_FREETYPE_SOURCE}/include")
  set_target_properties(imgui pugixml freetype PROPERTIES UNITY_BUILD OFF)
  add_library(PkgConfig::FREETYPE ALIAS freetype)
endif()

if(BUILD_TESTING)
  # They look at pipes, devices and limits of a system that is not there.
  set(CREMONA_TESTS_LEFT_OUT "--test-case-exclude=What has no end is not read*,A file that is there and cannot be read*")
  if(NOT DEFINED Python3_EXECUTABLE)
    set(Python3_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python3 COMPONENTS Interpreter REQUIRED)
endif()
