# Debian packages: `cpack` in a folder that the preset `package` configured (docs/install.md).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pxm)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "${PXM_MAINTAINER}")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR})
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime formats development)
if(PXM_WITH_PYTHON)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME pxm)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
# Not recommended: apt would bring its 160 MB with every pxm, and who needs it is told its name.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "pxm-formats (= ${PROJECT_VERSION}), ffmpeg")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "ray tracer of linear fractals, and emulator of the Pixel Machine
Renders attractors of (recurrent) iterated function systems by tracing rays
through their bounding volumes down to the size of a pixel, after J. C. Hart's
thesis of 1991: on the cores at hand, or on a simulated AT&T Pixel Machine with
its memories, arithmetic and counted time.")

# Apart, as it brings a hundred times what pxm is.
set(CPACK_DEBIAN_FORMATS_PACKAGE_NAME pxm-formats)
set(CPACK_DEBIAN_FORMATS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_FORMATS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FORMATS_PACKAGE_DEPENDS "pxm (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_FORMATS_DESCRIPTION "ray tracer of linear fractals - pictures of many formats
Lets pxm read pictures, for textures, comparisons and imports, and write them
in other formats than PNG and EXR, through OpenImageIO.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpxm-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "pxm (= ${PROJECT_VERSION}), libfmt-dev, libglm-dev, libhwy-dev, libpugixml-dev, zlib1g-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "ray tracer of linear fractals - libraries
Static libraries and headers to render linear fractals within other programs,
to ask what is known of them, and to run the simulated Pixel Machine.")

if(PXM_WITH_PYTHON)
    # Compiled for one Python: Debian's default when the package was made.
    math(EXPR next "${Python3_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-pxm)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "pxm (= ${PROJECT_VERSION}), python3-numpy, \
python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next})")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
        ${PROJECT_SOURCE_DIR}/cmake/python3-pxm/postinst ${PROJECT_SOURCE_DIR}/cmake/python3-pxm/prerm)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
    set(CPACK_COMPONENT_PYTHON_DESCRIPTION "ray tracer of linear fractals - Python module
Renders linear fractals, given as scenes or as arrays of maps, to NumPy arrays
of colours, depths, normals and whatever else is known of a pixel, on the cores
at hand or on a simulated Pixel Machine.")
endif()

# What Debian wants of a package beside the files.
if(NOT PXM_LOOK_IN_BUILD)
    set(debian ${CMAKE_BINARY_DIR}/debian)
    file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
    string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
    string(REGEX REPLACE "\n([^\n])" "\n \\1" licence " ${licence}")
    configure_file(cmake/debian-copyright.in ${debian}/copyright @ONLY)
    execute_process(COMMAND date -u -R -d @${PXM_DATE} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE)
    configure_file(cmake/debian-changelog.in ${debian}/changelog @ONLY)
    execute_process(COMMAND gzip -9nc ${debian}/changelog OUTPUT_FILE ${debian}/changelog.gz)
    set(packages runtime:pxm formats:pxm-formats development:libpxm-dev)
    if(PXM_WITH_PYTHON)
        list(APPEND packages python:python3-pxm)
    endif()
    foreach(pair ${packages})
        string(REPLACE ":" ";" pair ${pair})
        list(GET pair 0 component)
        list(GET pair 1 package)
        install(FILES ${debian}/copyright ${debian}/changelog.gz
            DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
    endforeach()
endif()
configure_file(cmake/package_date.cmake.in ${CMAKE_BINARY_DIR}/package_date.cmake @ONLY)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_BINARY_DIR}/package_date.cmake)
include(CPack)
