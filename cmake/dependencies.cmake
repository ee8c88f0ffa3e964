# What is taken from the system. Each library is known to one file or one folder of host/.
# PXM_LIBRARIES gathers the names, for `pxm --version`.

# needs(NAME PACKAGE FIND...): FIND are the arguments of find_package. A library that is not there ends
# the configuration with a message that names the Debian package which brings it.
macro(needs name package find)
    find_package(${find} ${ARGN} QUIET)
    if(NOT ${find}_FOUND)
        missing(${name} ${package})
    endif()
    list(APPEND PXM_LIBRARIES ${name})
    list(APPEND PXM_LIBRARY_PACKAGES ${find})
endmacro()

function(missing name package)
    message(FATAL_ERROR "${name} is missing: install Debian's ${package} "
        "(tools/packages.txt and tools/packages-test.txt list all that pxm needs)")
endfunction()

needs(pthreads g++ Threads)                    # the machine's 64 nodes on host threads (pxm/)
needs(OpenMP g++ OpenMP COMPONENTS CXX)       # the native engines
needs(Highway libhwy-dev hwy CONFIG)          # wide registers (host/wide/)
needs(GLM libglm-dev glm)                     # host vectors and matrices
needs(Eigen libeigen3-dev Eigen3 NO_MODULE)   # eigenvalues, singular values
needs(CLI11 libcli11-dev CLI11)               # the command line
needs(fmt libfmt-dev fmt)                     # text
needs(nlohmann-json nlohmann-json3-dev nlohmann_json)  # statistics
needs(pugixml libpugixml-dev pugixml)         # the XML of flames (host/import/flame/)
needs(Boost.Multiprecision libboost-dev Boost)         # the eye's place in 77 digits, headers only
list(APPEND PXM_LIBRARIES Boost.Beast)                 # the studio's server, headers only
list(APPEND PXM_LIBRARY_PACKAGES Boost)

# Debian's OpenImageIO target names the tools, and fails with the name of a file where they are not there.
find_program(PXM_IMAGE_TOOLS iconvert)
if(NOT PXM_IMAGE_TOOLS)
    missing("iconvert of OpenImageIO" openimageio-tools)
endif()
needs(zlib zlib1g-dev ZLIB)                            # pictures of the default format
needs(OpenEXR libopenexr-dev OpenEXR)                  # pictures of that format
needs(OpenImageIO libopenimageio-dev OpenImageIO)      # image files
# It also names an opencv4 include folder that nobody installs.
foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
    get_target_property(folders OpenImageIO::OpenImageIO ${property})
    if(folders)
        list(FILTER folders EXCLUDE REGEX "/opencv4$")
        set_target_properties(OpenImageIO::OpenImageIO PROPERTIES ${property} "${folders}")
    endif()
endforeach()

find_path(PXM_RANDOM123 Random123/philox.h)   # counter-based random numbers, headers only
if(NOT PXM_RANDOM123)
    missing(Random123 librandom123-dev)
endif()
list(APPEND PXM_LIBRARIES Random123)
list(APPEND PXM_LIBRARY_PACKAGES Random123)

# needs_header(NAME PACKAGE HEADER): a library without a find module, and its version from the header.
# FLINT has rationals, polynomials and their factors; Arb has balls of certified radius (host/fractal/exact/).
macro(needs_header name package header)
    find_path(PXM_${name} ${header})
    if(NOT PXM_${name})
        missing(${name} ${package})
    endif()
    string(TOUPPER ${name} upper)
    file(STRINGS ${PXM_${name}}/${header} line REGEX "define ${upper}_VERSION \"")
    string(REGEX REPLACE ".*\"([0-9.]+)\".*" "\\1" ${name}_VERSION "${line}")
    list(APPEND PXM_LIBRARIES ${name})
    list(APPEND PXM_LIBRARY_PACKAGES ${name})
endmacro()

needs_header(FLINT libflint-dev flint/flint.h)
needs_header(Arb libflint-arb-dev arb.h)
