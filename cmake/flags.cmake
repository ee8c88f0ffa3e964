# The flags every target is compiled with. Pixels must not depend on the compiler's mood:
# no contraction of a*b+c into one rounding, no fast-math, no -march of the machine at hand.
add_library(pxm_flags INTERFACE)
target_compile_options(pxm_flags INTERFACE
    $<BUILD_INTERFACE:-Wall> $<BUILD_INTERFACE:-Wextra> $<BUILD_INTERFACE:-Wconversion>
    # Files that are compiled together see each other's names, and none of them is the unit's own (cmake/unity.cmake).
    $<BUILD_INTERFACE:$<IF:$<BOOL:${PXM_UNITY}>,-Wno-subobject-linkage,-Wshadow>>
    # What g++ means by -Wconversion: clang counts signs, too.
    $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>>
    -ffp-contract=off
    $<BUILD_INTERFACE:$<$<BOOL:${PXM_WARNINGS_AS_ERRORS}>:-Werror>>)
target_compile_features(pxm_flags INTERFACE cxx_std_20)
target_include_directories(pxm_flags INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${PXM_INSTALL_HEADERS}>)
# What is fuzzed is watched, and tells the fuzzer where it has been.
if(PXM_BUILD_FUZZERS)
    target_compile_options(pxm_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(PXM_SANITIZE)
    target_compile_options(pxm_flags INTERFACE
        -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(pxm_flags INTERFACE -fsanitize=address,undefined)
endif()

# goes_into_shared_libraries(LIBRARY): the Python module is one, and a user of libpxm-dev may make others. What they
# do not export, the compiler may inline, and calls without detours.
function(goes_into_shared_libraries library)
    set_target_properties(${library} PROPERTIES
        POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()
