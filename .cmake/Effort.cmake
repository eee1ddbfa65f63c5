# What runs for each element, label or pixel is optimized in full. What runs once a command or a click need not be: with -O1 it
# is compiled in three quarters of the time, and a whole build is mostly that.
if(EMSCRIPTEN OR NOT CMAKE_BUILD_TYPE STREQUAL "Release" OR NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  return()
endif()

function(cremona_compile_quickly)
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      target_compile_options(${target} PRIVATE -O1)
    endif()
  endforeach()
endfunction()

# cremona_compile_folders_quickly(TARGET FOLDER...): of the sources of TARGET those in these folders of its own.
function(cremona_compile_folders_quickly target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  list(TRANSFORM ARGN PREPEND "${folder}/" OUTPUT_VARIABLE folders)
  list(JOIN folders "|" quick)
  set(rest "${sources}")
  list(FILTER sources INCLUDE REGEX "^(${quick})/.*[.]cpp$")
  list(FILTER rest EXCLUDE REGEX "^(${quick})/.*[.]cpp$")
  set_target_properties(${target} PROPERTIES SOURCES "${rest}")
  add_library(${target}_quick OBJECT ${sources})
  target_include_directories(${target}_quick PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target}_quick PRIVATE ${libraries})
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_quick>)
  cremona_precompile(${target}_quick model)
  cremona_compile_quickly(${target}_quick)
endfunction()

cremona_compile_folders_quickly(femoop
  edit io model/check model/fault methods/counting methods/cross methods/derivation methods/force_method methods/free_body methods/funicular methods/mohr
  methods/truss methods/virtual_work typical)

cremona_compile_quickly(
  cremona_pch_model # GCC takes how much is optimized from the precompiled header
  files tabular ui_base ui cremona_cli
  cross_model cross_view cross_report cross_session cross_app
  euler_model euler_view euler_session euler_app
  frame_model frame_predict frame_free_body frame_funicular frame_influence frame_virtual_work frame_truss frame_tools frame_view
  frame_tables frame_report frame_session frame_app
  mohr_model mohr_view mohr_session mohr_app
  plane_backdrop plane_outline plane_model plane_tools plane_session plane_app)
