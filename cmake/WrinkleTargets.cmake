# How every folder becomes one target. A target's link libraries are the include rule
# (tests/layout greps the #include lines as well).
#
#   wrinkle_library(NAME LINK lib...)        static library of the folder's *.cpp
#   wrinkle_compile_quickly(TARGET)          for code without inner loops: -O1, in asan -O0
#   wrinkle_texts(TARGET SPACE FOLDER)       the files of a folder as constants
#   wrinkle_test(NAME LINK lib...)           one GoogleTest program of the folder's *.cpp
#   wrinkle_sanitized_cases(NAME FILTER)     the cases that NAME runs in sanitized builds

option(WRINKLE_WERROR "Treat warnings as errors" ON)
option(WRINKLE_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(WRINKLE_FUZZ "The same, and have libFuzzer see what code it reaches (clang)" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(WRINKLE_MODULE_DIRECTORY ${CMAKE_BINARY_DIR}/lib/wrinkle)
set(WRINKLE_PLUGIN_DIRECTORY ${WRINKLE_MODULE_DIRECTORY}/plugins)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

# Equal bits on every machine and compiler: no fused multiply-add behind our back.
add_compile_options(-Wall -Wextra -Wpedantic -ffp-contract=off -fno-math-errno)
# Nobody replaces a function of ours at load time, so calls within a library may be inlined.
add_compile_options(-fno-semantic-interposition)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    add_compile_options(-Wno-restrict)  # false alarms in std::string, gcc bug 105651
endif()
if(WRINKLE_WERROR)
    add_compile_options(-Werror)
endif()
if(WRINKLE_FUZZ)
    set(WRINKLE_SANITIZE ON)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(WRINKLE_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
                        -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
    if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
        add_compile_definitions(__SANITIZE_ADDRESS__=1)  # as gcc defines it
    endif()
endif()

# -O3 doubles the time to compile commands and writers, without a gain that a user notices. With
# sanitizers, -O1 triples it.
function(wrinkle_compile_quickly target)
    target_compile_options(${target} PRIVATE
        $<$<CONFIG:Release>:-O1> $<$<CONFIG:RelWithDebInfo>:-O0>)
endfunction()

function(wrinkle_library name)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_library(wrinkle_${name} STATIC ${sources})
    target_include_directories(wrinkle_${name} PUBLIC ${PROJECT_SOURCE_DIR}/core)
    target_link_libraries(wrinkle_${name} PUBLIC ${ARG_LINK})
endfunction()

# wrinkle_embed(FOLDER HEADER NAMESPACE): the files of a folder as constants in a header of the build
# folder; FOLDER/plugin.cpp.in is NAMESPACE::plugin_cpp_in.
function(wrinkle_embed folder header namespace)
    file(GLOB texts CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${texts})
    set(constants)
    foreach(file ${texts})
        get_filename_component(name ${file} NAME)
        string(MAKE_C_IDENTIFIER ${name} name)
        file(READ ${file} text)
        string(APPEND constants
            "inline constexpr std::string_view ${name} = R\"text(${text})text\";\n")
    endforeach()
    file(CONFIGURE OUTPUT ${header} @ONLY CONTENT [[
#pragma once
#include <string_view>
namespace @namespace@ {
@constants@}
]])
endfunction()

function(wrinkle_test name)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    find_package(GTest REQUIRED)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_executable(test_${name} ${sources})
    target_link_libraries(test_${name} PRIVATE ${ARG_LINK} GTest::gtest GTest::gtest_main)
    target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    # The code under test is in the libraries, which have the flags of the build. With sanitizers,
    # -O0 takes a quarter of the time to compile.
    target_compile_options(test_${name} PRIVATE $<IF:$<BOOL:${WRINKLE_SANITIZE}>,-O0,-Og>)
    target_compile_definitions(test_${name} PRIVATE
        WRINKLE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" WRINKLE_BINARY_DIR="${CMAKE_BINARY_DIR}")
    add_dependencies(test_${name} wrinkle-plugin-probe)  # what loads plugins starts it
    add_test(NAME ${name} COMMAND test_${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endfunction()

# Under sanitizers a program takes ten times as long. Further arguments are environment variables.
function(wrinkle_sanitized_cases name filter)
    if(WRINKLE_SANITIZE)
        set_tests_properties(${name} PROPERTIES ENVIRONMENT "GTEST_FILTER=${filter};${ARGN}")
    endif()
endfunction()
