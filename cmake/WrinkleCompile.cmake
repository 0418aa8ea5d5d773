# wrinkle_compile(TARGET name GRAPHS file...
#                 [LANGUAGE language] [FORM function|shader] [OUTPUT folder] [REFLECT]
#                 [OUTPUTS variable] [OPTIONS option...])
#
# Compiles graphs with `wrinkle compile` while the project is built: each by itself and only when it,
# a sub-graph, an image it names, a plugin or the program changed.
#
# TARGET   is made and built by default; a target that is there already gets the texts before its
#          own sources are compiled, from any number of calls
# GRAPHS   relative to the current source folder
# LANGUAGE what `wrinkle compile --target` takes: glsl330 (default), glsl450, essl300, hlsl, msl,
#          wgsl, spirv (only the form shader), godot3, godot4 (only the form function)
# OUTPUT   default: TARGET in the current build folder; STEM.glsl, STEM.hlsl, STEM.msl, STEM.wgsl,
#          STEM.shader (Godot 3) or STEM.gdshaderinc (Godot 4); of the form shader STEM.vert and
#          STEM.frag, followed by .hlsl, .msl, .wgsl or .spv; with REFLECT also
#          STEM.reflection.json
# OPTIONS  others of `wrinkle compile`, such as --params uniform or --cache DIR; --target and --form
#          have words of their own here
# OUTPUTS  this variable gets the list of the files

function(wrinkle_compile)
    cmake_parse_arguments(ARG "REFLECT" "TARGET;OUTPUT;LANGUAGE;FORM;OUTPUTS" "GRAPHS;OPTIONS" ${ARGN})
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
    foreach(option ${ARG_OPTIONS})
        if(option MATCHES "^--(target|form)(=|$)")
            message(FATAL_ERROR "wrinkle_compile takes LANGUAGE and FORM in place of '${option}'")
        endif()
    endforeach()
    if(NOT ARG_LANGUAGE)
        set(ARG_LANGUAGE glsl330)
    endif()
    set(form function)
    set(suffix)
    if(ARG_LANGUAGE STREQUAL "spirv")
        set(form shader)
        set(suffix .spv)
    elseif(ARG_LANGUAGE MATCHES "^(hlsl|msl|wgsl)$")
        set(suffix .${ARG_LANGUAGE})
    elseif(ARG_LANGUAGE STREQUAL "godot3")
        set(suffix .shader)
    elseif(ARG_LANGUAGE STREQUAL "godot4")
        set(suffix .gdshaderinc)
    elseif(NOT ARG_LANGUAGE MATCHES "^(glsl330|glsl450|essl300)$")
        message(FATAL_ERROR "wrinkle_compile knows no LANGUAGE '${ARG_LANGUAGE}'")
    endif()
    if(ARG_FORM AND NOT ARG_FORM MATCHES "^(function|shader)$")
        message(FATAL_ERROR "wrinkle_compile knows FORM function and shader, not '${ARG_FORM}'")
    elseif("${ARG_LANGUAGE} ${ARG_FORM}" MATCHES "^(spirv function|godot. shader)$")
        message(FATAL_ERROR "wrinkle_compile has no FORM ${ARG_FORM} of LANGUAGE ${ARG_LANGUAGE}")
    elseif(ARG_FORM)
        set(form ${ARG_FORM})
    endif()
    if(form STREQUAL "shader")
        set(suffixes .vert${suffix} .frag${suffix})
    elseif(suffix)
        set(suffixes ${suffix})
    else()
        set(suffixes .glsl)
    endif()
    list(APPEND ARG_OPTIONS --target ${ARG_LANGUAGE} --form ${form})
    file(MAKE_DIRECTORY ${folder})
    set(all)
    foreach(graph ${ARG_GRAPHS})
        get_filename_component(stem ${graph} NAME_WLE)
        get_filename_component(graph ${graph} ABSOLUTE)
        set(output ${folder}/${stem})
        list(TRANSFORM suffixes PREPEND ${output} OUTPUT_VARIABLE made)
        set(options ${ARG_OPTIONS})
        if(form STREQUAL "function")
            string(APPEND output ${suffixes})
        endif()
        if(ARG_REFLECT)
            list(APPEND made ${folder}/${stem}.reflection.json)
            list(APPEND options --reflect ${folder}/${stem}.reflection.json)
        endif()
        list(GET made 0 first)
        add_custom_command(OUTPUT ${made}
            COMMAND Wrinkle::wrinkle compile ${graph} -o ${output} ${options}
                -MD -MF ${first}.d -MT ${first}
            DEPENDS ${graph} Wrinkle::wrinkle DEPFILE ${first}.d
            COMMENT "Compiling ${stem} with Wrinkle" VERBATIM)
        list(APPEND all ${made})
    endforeach()
    if(TARGET ${ARG_TARGET})
        set(graphs ${ARG_TARGET}_graphs)
        while(TARGET ${graphs})  # of an earlier call
            string(APPEND graphs _)
        endwhile()
        add_custom_target(${graphs} DEPENDS ${all})
        add_dependencies(${ARG_TARGET} ${graphs})
    else()
        add_custom_target(${ARG_TARGET} ALL DEPENDS ${all})
    endif()
    if(ARG_OUTPUTS)
        set(${ARG_OUTPUTS} ${all} PARENT_SCOPE)
    endif()
endfunction()
