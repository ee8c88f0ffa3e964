# What is taken from the system. Each library is known to one file or one folder of host/.
find_package(Threads REQUIRED)            # the machine's 64 nodes on host threads (pxm/)
find_package(OpenMP REQUIRED COMPONENTS CXX)  # the native engines
find_package(hwy REQUIRED CONFIG)         # wide registers (host/wide/)
find_package(glm REQUIRED)                # host vectors and matrices
find_package(OpenImageIO REQUIRED)        # image files
find_package(Eigen3 REQUIRED NO_MODULE)   # eigenvalues, singular values
find_package(CLI11 REQUIRED)              # the command line
find_package(fmt REQUIRED)                # text
find_package(nlohmann_json REQUIRED)      # statistics

# Debian's OpenImageIO target names an opencv4 include folder that nobody installs.
foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
    get_target_property(folders OpenImageIO::OpenImageIO ${property})
    if(folders)
        list(FILTER folders EXCLUDE REGEX "/opencv4$")
        set_target_properties(OpenImageIO::OpenImageIO PROPERTIES ${property} "${folders}")
    endif()
endforeach()
find_path(PXM_RANDOM123 Random123/philox.h REQUIRED)  # counter-based random numbers, headers only
