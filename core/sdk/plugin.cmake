# wrinkle_plugin(NAME SOURCES file... [OUTPUT folder])
#
# A shared object NAME.so of C++ or C that exports wrinkle_plugin and nothing else. It links
# Wrinkle::SDK, which is headers alone. OUTPUT: WRINKLE_PLUGIN_DIRECTORY, else the build folder.

function(wrinkle_plugin name)
    cmake_parse_arguments(ARG "" "OUTPUT" "SOURCES" ${ARGN})
    set(exports ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin.map)
    foreach(folder ${WRINKLE_PLUGIN_DIRECTORY} ${CMAKE_BINARY_DIR})
        if(NOT ARG_OUTPUT)
            set(ARG_OUTPUT ${folder})
        endif()
    endforeach()
    add_library(${name} MODULE ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE Wrinkle::SDK)
    target_link_options(${name} PRIVATE -Wl,--version-script=${exports})
    set_target_properties(${name} PROPERTIES
        PREFIX "" SUFFIX .so C_STANDARD 11 CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
        C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
        LINK_DEPENDS ${exports} LIBRARY_OUTPUT_DIRECTORY ${ARG_OUTPUT})
endfunction()
