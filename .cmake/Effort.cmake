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

cremona_compile_apart(femoop quick
  edit io model/check model/fault methods/counting methods/cross methods/derivation methods/force_method methods/free_body methods/funicular methods/mohr
  methods/truss methods/virtual_work typical)
cremona_precompile(femoop_quick model)

cremona_compile_quickly(
  femoop_quick
  cremona_pch_model # GCC takes how much is optimized from the precompiled header
  files tabular ui_base ui cremona_cli
  cross_model cross_view cross_report cross_session cross_app
  euler_model euler_view euler_session euler_app
  frame_model frame_predict frame_free_body frame_funicular frame_influence frame_virtual_work frame_truss frame_tools frame_view
  frame_tables frame_report frame_session frame_app
  mohr_model mohr_view mohr_session mohr_app
  plane_backdrop plane_outline plane_model plane_tools plane_session plane_app)
