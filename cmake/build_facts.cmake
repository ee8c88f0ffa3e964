# What `pxm --version --json` says of the build: a source that cmake/build_facts.cpp.in becomes.
set(PXM_BUILD_FACTS ${CMAKE_BINARY_DIR}/build_facts.cpp)

# left_out(WHAT BECAUSE) adds to it.
function(left_out what because)
    set_property(GLOBAL APPEND_STRING PROPERTY PXM_LEFT_OUT "    {\"${what}\", \"${because}\"},\n")
endfunction()

# Two do not say their versions as all others do; pthreads and Random123 do not say theirs.
set(OpenMP_VERSION ${OpenMP_CXX_VERSION})
set(ZLIB_VERSION ${ZLIB_VERSION_STRING})
set(PXM_LIBRARY_FACTS)
foreach(name package IN ZIP_LISTS PXM_LIBRARIES PXM_LIBRARY_PACKAGES)
    string(APPEND PXM_LIBRARY_FACTS "    {\"${name}\", \"${${package}_VERSION}\"},\n")
endforeach()

# write_build_facts(FILE): after all that can be left out.
function(write_build_facts file)
    get_property(PXM_LEFT_OUT GLOBAL PROPERTY PXM_LEFT_OUT)
    list(JOIN PXM_LIBRARIES ", " libraries)
    string(TOUPPER ${CMAKE_BUILD_TYPE} type)
    get_target_property(flags pxm_flags INTERFACE_COMPILE_OPTIONS)
    string(REGEX REPLACE "\\$<BUILD_INTERFACE:([^<>]*)>" "\\1" flags "${flags}")
    string(GENEX_STRIP "${flags}" flags)
    list(JOIN flags " " flags)
    string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${flags} -std=c++${CMAKE_CXX_STANDARD}" flags)
    string(REPLACE "\"" "\\\"" flags "${flags}")
    configure_file(${PROJECT_SOURCE_DIR}/cmake/build_facts.cpp.in ${file} @ONLY)
endfunction()
