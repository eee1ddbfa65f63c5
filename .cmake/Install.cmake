# What `cmake --install` puts in place: the libraries for find_package(cremona), which are the component "development"; the
# component "programs" is that of apps/CMakeLists.txt. `cpack` makes packages of both (Package.cmake).
include(CMakePackageConfigHelpers)
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/cremona")

install(TARGETS files tabular topology femoop EXPORT cremona
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
  FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/cremona" COMPONENT development)
install(EXPORT cremona NAMESPACE cremona:: FILE cremonaTargets.cmake DESTINATION "${package_folder}" COMPONENT development)

set(CREMONA_USES "")
foreach(library CHOLMOD METIS)
  if(TARGET ${library}::${library})
    list(APPEND CREMONA_USES ${library})
    install(FILES .cmake/Find${library}.cmake DESTINATION "${package_folder}" COMPONENT development)
  endif()
endforeach()
configure_package_config_file(.cmake/cremonaConfig.cmake.in "${PROJECT_BINARY_DIR}/cremonaConfig.cmake"
  INSTALL_DESTINATION "${package_folder}" NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/cremonaConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/cremonaConfig.cmake" "${PROJECT_BINARY_DIR}/cremonaConfigVersion.cmake"
  DESTINATION "${package_folder}" COMPONENT development)

set(documents programs)
if(NOT CREMONA_APPS)
  set(documents development)
endif()
install(FILES LICENSE CHANGELOG.md CITATION.cff courseware/conventions.md DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT ${documents})
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME copyright COMPONENT ${documents})
install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT ${documents} FILES_MATCHING PATTERN "*.json"
  PATTERN "*.eul")
install(DIRECTORY courseware/reference DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT ${documents} FILES_MATCHING PATTERN "*.md" PATTERN "*.json"
  PATTERN "*.svg")
