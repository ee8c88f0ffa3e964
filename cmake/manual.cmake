# What the program writes of itself: the manual (docs/man/, by scdoc, which may be missing) and the
# completion of three shells.
find_program(PXM_SCDOC scdoc)
set(extras ${CMAKE_BINARY_DIR}/extras)

# write(FILE PROGRAM ARGUMENTS...): what the command prints, in a file.
function(write_extra file)
    cmake_parse_arguments(PARSE_ARGV 1 extra "" "" "COMMAND;DEPENDS")
    get_filename_component(folder ${file} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${file} COMMAND ${extra_COMMAND} > ${file}.new
        COMMAND ${CMAKE_COMMAND} -E rename ${file}.new ${file} DEPENDS ${extra_DEPENDS} VERBATIM)
    set_property(GLOBAL APPEND PROPERTY PXM_EXTRAS ${file})
endfunction()

# Sanitizers watch tests, not the build.
if(PXM_SANITIZE)
    left_out(manual "the build has sanitizers")
    left_out(completion "the build has sanitizers")
    return()
endif()

foreach(pair bash:pxm zsh:_pxm fish:pxm.fish)
    string(REPLACE ":" ";" pair ${pair})
    list(GET pair 0 shell)
    list(GET pair 1 name)
    write_extra(${extras}/${shell}/${name} COMMAND pxm_program completion ${shell} DEPENDS pxm_program)
endforeach()
set(PXM_ZSH_COMPLETION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Where zsh finds completion")
install(FILES ${extras}/bash/pxm DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT runtime)
install(FILES ${extras}/zsh/_pxm DESTINATION ${PXM_ZSH_COMPLETION} COMPONENT runtime)
install(FILES ${extras}/fish/pxm.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT runtime)

if(PXM_SCDOC)
    file(GLOB texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/man/*.scd)
    foreach(text ${texts})
        get_filename_component(page ${text} NAME_WE)
        set(section 1)
        if(page STREQUAL pxm-scene)
            set(section 5)
        endif()
        set(source ${extras}/man/${page}.scd)
        set(made ${extras}/man/${page}.${section})
        write_extra(${source} COMMAND pxm_program manual ${page} ${text} DEPENDS pxm_program ${text})
        write_extra(${made} COMMAND ${CMAKE_COMMAND} -E env SOURCE_DATE_EPOCH=${PXM_DATE} ${PXM_SCDOC} < ${source}
            DEPENDS ${source})
        write_extra(${made}.gz COMMAND gzip -9nc ${made} DEPENDS ${made})
        install(FILES ${made}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} COMPONENT runtime)
    endforeach()
else()
    left_out(manual "scdoc was not found")
endif()

get_property(made GLOBAL PROPERTY PXM_EXTRAS)
add_custom_target(pxm_extras ALL DEPENDS ${made})
