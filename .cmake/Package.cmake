# What `cpack` makes of an installed tree: `cpack -G DEB` the packages cremona (the programs) and libcremona-dev (the libraries),
# `cpack -G TGZ` an archive of the programs that is unpacked anywhere.
set(CPACK_PACKAGE_NAME cremona)
set(CPACK_PACKAGE_CONTACT "The Cremona authors <cremona@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "structural analysis that teaches")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 2)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_SOURCE_DIR}/.cmake/package_kind.cmake")
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)

set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "Plane and space frames, trusses, grillages and plates are drawn, solved exactly
along every member, drawn as a textbook draws them, and explained; moments are
distributed joint by joint, Mohr's circle is turned by hand, Euler operators
are shown step by step. The program cremona does the same without a window.")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME cremona)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS fonts-dejavu-core)
# Loaded where they are there: pictures without a display; the clipboard; dense products of large systems.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "libosmesa6, xclip, libopenblas0")

set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "The finite-element core and the half-edge kernel of Cremona, which are static
libraries, and what find_package(cremona) of CMake reads.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcremona-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libsuitesparse-dev, libmetis-dev")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
include(CPack)
