# wrinkle_plugin(NAME SOURCES file... [OUTPUT folder])
#
# A shared object NAME.so that exports wrinkle_plugin and nothing else. Links wrinkle_sdk, which is headers alone.

function(wrinkle_plugin name)
    cmake_parse_arguments(ARG "" "OUTPUT" "SOURCES" ${ARGN})
    set(exports ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin.map)
    if(NOT ARG_OUTPUT)
        set(ARG_OUTPUT ${CMAKE_BINARY_DIR}/lib/wrinkle/plugins)
    endif()
    add_library(${name} MODULE ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE wrinkle_sdk)
    target_link_options(${name} PRIVATE -Wl,--version-script=${exports})
    set_target_properties(${name} PROPERTIES
        PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
        LINK_DEPENDS ${exports} LIBRARY_OUTPUT_DIRECTORY ${ARG_OUTPUT})
endfunction()
