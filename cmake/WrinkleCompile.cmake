# wrinkle_compile(TARGET name GRAPHS file...
#                 [OUTPUT folder] [FORM function|shader] [REFLECT] [OUTPUTS variable]
#                 [OPTIONS option...])
#
# Compiles graphs with `wrinkle compile` while the project is built: each by itself and only when it,
# a sub-graph, an image it names, a plugin or the program changed.
#
# TARGET   is made and built by default; a target that is there already gets the texts before its
#          own sources are compiled
# GRAPHS   relative to the current source folder
# OUTPUT   default: TARGET in the current build folder; STEM.glsl, of the form shader STEM.vert and
#          STEM.frag, with REFLECT also STEM.reflection.json
# OPTIONS  others of `wrinkle compile`, such as --params uniform or --cache DIR
# OUTPUTS  this variable gets the list of the files

function(wrinkle_compile)
    cmake_parse_arguments(ARG "REFLECT" "TARGET;OUTPUT;FORM;OUTPUTS" "GRAPHS;OPTIONS" ${ARGN})
    foreach(needed TARGET GRAPHS)
        if(NOT ARG_${needed})
            message(FATAL_ERROR "wrinkle_compile needs ${needed}")
        endif()
    endforeach()
    if(ARG_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "wrinkle_compile does not know '${ARG_UNPARSED_ARGUMENTS}'")
    endif()
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${ARG_TARGET})
    if(ARG_OUTPUT)
        get_filename_component(folder ${ARG_OUTPUT} ABSOLUTE BASE_DIR ${CMAKE_CURRENT_BINARY_DIR})
    endif()
    set(suffixes .glsl)
    if(ARG_FORM STREQUAL "shader")
        set(suffixes .vert .frag)
        list(APPEND ARG_OPTIONS --form shader)
    elseif(ARG_FORM AND NOT ARG_FORM STREQUAL "function")
        message(FATAL_ERROR "wrinkle_compile knows FORM function and shader, not '${ARG_FORM}'")
    endif()
    file(MAKE_DIRECTORY ${folder})
    set(all)
    foreach(graph ${ARG_GRAPHS})
        get_filename_component(stem ${graph} NAME_WLE)
        get_filename_component(graph ${graph} ABSOLUTE)
        set(output ${folder}/${stem})
        list(TRANSFORM suffixes PREPEND ${output} OUTPUT_VARIABLE made)
        set(options ${ARG_OPTIONS})
        if(NOT ARG_FORM STREQUAL "shader")
            string(APPEND output .glsl)
        endif()
        if(ARG_REFLECT)
            list(APPEND made ${folder}/${stem}.reflection.json)
            list(APPEND options --reflect ${folder}/${stem}.reflection.json)
        endif()
        list(GET made 0 first)
        add_custom_command(OUTPUT ${made}
            COMMAND Wrinkle::wrinkle compile ${graph} -o ${output} ${options}
                -MD -MF ${folder}/${stem}.d -MT ${first}
            DEPENDS ${graph} Wrinkle::wrinkle DEPFILE ${folder}/${stem}.d
            COMMENT "Compiling ${stem} with Wrinkle" VERBATIM)
        list(APPEND all ${made})
    endforeach()
    if(TARGET ${ARG_TARGET})
        add_custom_target(${ARG_TARGET}_graphs DEPENDS ${all})
        add_dependencies(${ARG_TARGET} ${ARG_TARGET}_graphs)
    else()
        add_custom_target(${ARG_TARGET} ALL DEPENDS ${all})
    endif()
    if(ARG_OUTPUTS)
        set(${ARG_OUTPUTS} ${all} PARENT_SCOPE)
    endif()
endfunction()
