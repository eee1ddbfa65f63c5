# Run by CTest: see the CMakeLists.txt beside it.
cmake_minimum_required(VERSION 3.25)
set(example 01_cantilever)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}\nfailed (${result}):\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE "${work}")
run("${CMAKE_COMMAND}" --install "${build}" --prefix "${work}/prefix")

if(apps)
  set(files bin/cremona share/man/man1/cremona.1 share/bash-completion/completions/cremona share/mime/packages/cremona.xml
    share/applications/cremona.desktop)
  foreach(app cross euler frame mohr plane)
    list(APPEND files bin/cremona-${app} share/man/man1/cremona-${app}.1 share/bash-completion/completions/cremona-${app}
      share/applications/cremona-${app}.desktop share/icons/hicolor/scalable/apps/cremona-${app}.svg)
  endforeach()
  foreach(file IN LISTS files)
    if(NOT EXISTS "${work}/prefix/${file}")
      message(FATAL_ERROR "not installed: ${file}")
    endif()
  endforeach()
  file(GLOB programs RELATIVE "${work}/prefix/bin" "${work}/prefix/bin/*")
  list(FILTER programs EXCLUDE REGEX "^cremona")
  if(programs)
    message(FATAL_ERROR "installed under a name that others have: ${programs}")
  endif()
  run("${work}/prefix/bin/cremona" --help)
  run("${work}/prefix/bin/cremona" frame --describe) # becomes the app beside it
  run("${work}/prefix/bin/cremona" "${examples}/cube.eul" --describe)
  run(bash -c "source '${work}/prefix/share/bash-completion/completions/cremona' && COMP_WORDS=(cremona sol) COMP_CWORD=1 && \
_cremona && [ \"\${COMPREPLY[*]}\" = solve ] && COMP_WORDS=(cremona solve --js) COMP_CWORD=2 && _cremona && \
[ \"\${COMPREPLY[*]}\" = --json ]")
endif()

# A student's folder: the example, and the five lines that its lesson shows.
file(COPY "${examples}/${example}.cpp" DESTINATION "${work}/student")
file(WRITE "${work}/student/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)
project(student CXX)
find_package(cremona 0.1 REQUIRED)
add_executable(${example} ${example}.cpp)
target_link_libraries(${example} PRIVATE cremona::femoop cremona::topology)
")
set(flags "")
if(sanitize)
  set(flags "-DCMAKE_CXX_FLAGS=-fsanitize=${sanitize}")
endif()
run("${CMAKE_COMMAND}" -G Ninja -S "${work}/student" -B "${work}/student/build"
    "-DCMAKE_PREFIX_PATH=${work}/prefix" "-DCMAKE_CXX_COMPILER=${compiler}" -DCMAKE_BUILD_TYPE=Debug ${flags})
run("${CMAKE_COMMAND}" --build "${work}/student/build")
run("${python}" "${examples}/compare.py" "${work}/student/build/${example}" "${work}/student/${example}.cpp")
