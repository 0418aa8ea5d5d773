# wrinkle_plugin(NAME SOURCES file... [OUTPUT folder])
#
# A shared object NAME.so that exports wrinkle_plugin and nothing else. Links wrinkle_sdk, which is headers alone.
set(WRINKLE_PLUGIN_MAP ${CMAKE_CURRENT_LIST_DIR}/plugin.map)

function(wrinkle_plugin name)
    cmake_parse_arguments(ARG "" "OUTPUT" "SOURCES" ${ARGN})
    if(NOT ARG_OUTPUT)
        set(ARG_OUTPUT ${CMAKE_BINARY_DIR}/lib/wrinkle/plugins)
    endif()
    add_library(${name} MODULE ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE wrinkle_sdk)
    target_link_options(${name} PRIVATE -Wl,--version-script=${WRINKLE_PLUGIN_MAP})
    set_target_properties(${name} PROPERTIES
        PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
        LINK_DEPENDS ${WRINKLE_PLUGIN_MAP} LIBRARY_OUTPUT_DIRECTORY ${ARG_OUTPUT})
endfunction()
