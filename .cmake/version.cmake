# Writes version.h, where it says otherwise: cmake -Dsource=DIR -Dversion=0.1.0 -Doutput=version.h -Dis_page=0 -P version.cmake
set(text "${version}")
if(NOT is_page AND EXISTS "${source}/.git")
  execute_process(COMMAND git -C "${source}" describe --always --exclude=* --abbrev=10 --dirty
    OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
  if(NOT failed)
    string(REPLACE "-dirty" ", changed" commit "${commit}")
    string(APPEND text " (commit ${commit})")
  endif()
endif()
file(CONFIGURE OUTPUT "${output}" CONTENT "#pragma once
#define CREMONA_VERSION \"${text}\"
")
