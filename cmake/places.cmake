# Where pxm is installed. PXM_PLACES is what host/files/installed_places.cpp is told of that.
include(GNUInstallDirs)
set(PXM_INSTALL_MODULES ${CMAKE_INSTALL_LIBDIR}/pxm)
set(PXM_INSTALL_DATA ${CMAKE_INSTALL_DATADIR}/pxm)
set(PXM_INSTALL_HEADERS ${CMAKE_INSTALL_INCLUDEDIR}/pxm)
set(PXM_INSTALL_CONFIG ${CMAKE_INSTALL_LIBDIR}/cmake/pxm)

# Pages of the manual have a date: that of the sources, not of the build.
set(PXM_DATE $ENV{SOURCE_DATE_EPOCH})
if(NOT PXM_DATE)
    execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 --format=%ct
        OUTPUT_VARIABLE PXM_DATE OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT PXM_DATE)
    set(PXM_DATE 0)
endif()

# A package is told nothing of the folders that it was built in.
option(PXM_LOOK_IN_BUILD "Programs find modules and scenes where they were built, too" ON)
if(PXM_LOOK_IN_BUILD)
    set(built_modules ${CMAKE_BINARY_DIR}/lib/pxm)
    set(source_data ${PROJECT_SOURCE_DIR})
else()
    # Its date is that of the commit that it is made of, also where the folder was configured before.
    execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} rev-parse --path-format=absolute --git-path logs/HEAD
        OUTPUT_VARIABLE commits OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(EXISTS "${commits}")
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${commits})
    endif()
endif()

set(modules ${CMAKE_INSTALL_FULL_LIBDIR}/pxm)
set(data ${CMAKE_INSTALL_FULL_DATADIR}/pxm)
file(RELATIVE_PATH bin_to_modules ${CMAKE_INSTALL_FULL_BINDIR} ${modules})
file(RELATIVE_PATH bin_to_data ${CMAKE_INSTALL_FULL_BINDIR} ${data})
set(PXM_PLACES
    PXM_BIN_TO_MODULES="${bin_to_modules}" PXM_BUILT_MODULES="${built_modules}" PXM_MODULES="${modules}"
    PXM_BIN_TO_DATA="${bin_to_data}" PXM_SOURCE_DATA="${source_data}" PXM_DATA="${data}")
