# What can be switched. Tests are switched by CTest's own BUILD_TESTING.
option(CREMONA_APPS "Build ui and the apps (Dear ImGui, GLFW, Cairo, FreeType, CLI11)" ON)
option(CREMONA_CHOLMOD "Use CHOLMOD of SuiteSparse where it is installed; a build without it is complete" ON)
option(CREMONA_METIS "Order large systems without positions by METIS where it is installed; a build without it is complete" ON)
option(CREMONA_THREADS "Solve large systems with several threads; off where there are none, as in a browser" ON)
option(CREMONA_PCH "Precompile the headers of Eigen and doctest" ON)
option(CREMONA_UNITY "Compile a dozen sources of a target as one: a cold build takes a third of the time" ON)
set(CREMONA_UNITY_BATCH 12 CACHE STRING "How many; the more, the less of a target is compiled anew with an edit, and by one core")
option(CREMONA_FUZZERS "Build the libFuzzer targets (clang only)" OFF)
set(CREMONA_SANITIZE "" CACHE STRING "Sanitizers of every target, such as address,undefined")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()
