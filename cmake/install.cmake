# `cmake --install`: the component `runtime` is the program with what it reads, `formats` the modules
# with OpenImageIO and OpenVDB, `development` the libraries with their headers, `python` the Python module (python/CMakeLists.txt). A
# tree that was installed may be moved as a whole.

# public_headers(VARIABLE HEADER...): these headers of host/, and all that they include.
function(public_headers variable)
    set(waiting ${ARGN})
    set(known)
    while(waiting)
        list(POP_FRONT waiting header)
        if(header IN_LIST known OR NOT header MATCHES "^host/")
            continue()
        endif()
        list(APPEND known ${header})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
        file(STRINGS ${PROJECT_SOURCE_DIR}/${header} lines REGEX "^#include \"")
        foreach(line ${lines})
            string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
            list(APPEND waiting ${included})
        endforeach()
    endwhile()
    set(${variable} ${known} PARENT_SCOPE)
endfunction()

# docs/library.md says what is in them.
public_headers(headers
    host/engine/engine.hpp
    host/engine/frame.hpp
    host/engine/statistics.hpp
    host/error.hpp
    host/files/installed_places.hpp
    host/fractal/bounds/bounds.hpp
    host/fractal/dimension/dimension.hpp
    host/fractal/measure/chaos_game.hpp
    host/fractal/system/contraction.hpp
    host/inspect/inspect_json.hpp
    host/inspect/inspect_text.hpp
    host/inspect/inspection.hpp
    host/output/image.hpp
    host/output/statistics_json.hpp
    host/render/render.hpp
    host/scene/check/check.hpp
    host/scene/parse/parser.hpp
    host/scene/print/print.hpp
    host/scene/diagnostics.hpp
    host/scene/scene.hpp
    host/scene/scene_path.hpp)
foreach(header ${headers})
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${header} DESTINATION ${PXM_INSTALL_HEADERS}/${folder} COMPONENT development)
endforeach()
install(DIRECTORY pxm dsp_kernels DESTINATION ${PXM_INSTALL_HEADERS} COMPONENT development
    FILES_MATCHING PATTERN "*.hpp" PATTERN "*.inl")

set_target_properties(dsp_kernels PROPERTIES EXPORT_NAME kernels)
foreach(library flags machine fractal render host)
    set_target_properties(pxm_${library} PROPERTIES EXPORT_NAME ${library})
endforeach()
install(TARGETS pxm_flags pxm_machine dsp_kernels pxm_fractal pxm_render pxm_host EXPORT pxm
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT pxm NAMESPACE pxm:: FILE pxmTargets.cmake DESTINATION ${PXM_INSTALL_CONFIG} COMPONENT development)

include(CMakePackageConfigHelpers)
configure_package_config_file(cmake/pxmConfig.cmake.in ${CMAKE_BINARY_DIR}/install/pxmConfig.cmake
    INSTALL_DESTINATION ${PXM_INSTALL_CONFIG} PATH_VARS PXM_INSTALL_MODULES PXM_INSTALL_DATA)
# Before 1.0 a minor version may change the interface (docs/library.md).
write_basic_package_version_file(${CMAKE_BINARY_DIR}/install/pxmConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/install/pxmConfig.cmake ${CMAKE_BINARY_DIR}/install/pxmConfigVersion.cmake
    DESTINATION ${PXM_INSTALL_CONFIG} COMPONENT development)

# From the .pc file's folder to the top of the tree.
file(RELATIVE_PATH PXM_PC_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" PXM_PC_TO_PREFIX ${PXM_PC_TO_PREFIX})
configure_file(cmake/pxm.pc.in ${CMAKE_BINARY_DIR}/install/pxm.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/install/pxm.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

install(TARGETS pxm_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
install(TARGETS pxm_openexr pxm_flint LIBRARY DESTINATION ${PXM_INSTALL_MODULES} COMPONENT runtime)
install(TARGETS pxm_openimageio LIBRARY DESTINATION ${PXM_INSTALL_MODULES} COMPONENT formats)
if(PXM_WITH_OPENVDB)
    install(TARGETS pxm_openvdb LIBRARY DESTINATION ${PXM_INSTALL_MODULES} COMPONENT formats)
endif()
install(DIRECTORY scenes DESTINATION ${PXM_INSTALL_DATA} COMPONENT runtime FILES_MATCHING PATTERN "*.pxm"
    PATTERN gallery EXCLUDE)
install(FILES README.md CHANGELOG.md LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
# Their pictures would be a third of the package.
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT runtime
    PATTERN examples EXCLUDE PATTERN man EXCLUDE PATTERN "*.png" EXCLUDE)
install(DIRECTORY docs/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
