# Debian packages by CPack: `wrinkle` (programs, samples, documentation) and `libwrinkle-dev` (library
# for C, C++ and Python, SDK of plugins). ./run package builds them; docs/packages.md is about them.
set(here ${CMAKE_CURRENT_LIST_DIR}/package)

# Desktop, documentation, completions.
install(FILES ${here}/wrinkle-editor.desktop DESTINATION share/applications)
install(FILES ${here}/wrinkle.svg DESTINATION share/icons/hicolor/scalable/apps)
install(FILES ${here}/wrinkle.xml DESTINATION share/mime/packages)
install(DIRECTORY docs/ DESTINATION share/doc/wrinkle FILES_MATCHING PATTERN "*.md")
install(FILES README.md DESTINATION share/doc/wrinkle)

set(made ${CMAKE_BINARY_DIR}/package)
set(completions "")
foreach(shell bash zsh fish)
    add_custom_command(OUTPUT ${made}/completion.${shell}
        COMMAND wrinkle completion ${shell} > ${made}/completion.${shell} DEPENDS wrinkle VERBATIM)
    list(APPEND completions ${made}/completion.${shell})
endforeach()
add_custom_target(completions ALL DEPENDS ${completions})
install(FILES ${made}/completion.bash RENAME wrinkle
    DESTINATION share/bash-completion/completions)
install(FILES ${made}/completion.zsh RENAME _wrinkle DESTINATION share/zsh/vendor-completions)
install(FILES ${made}/completion.fish RENAME wrinkle.fish
    DESTINATION share/fish/vendor_completions.d)
install(FILES ${here}/wrinkle-editor.1 DESTINATION share/man/man1)

# copyright and changelog of each package, as Debian's policy asks.
file(READ LICENSE licence)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" ignored "${licence}")
set(COPYRIGHT ${CMAKE_MATCH_1})
string(REGEX REPLACE "^.*\n\n(Permission)" "\\1" terms "${licence}")
string(STRIP "${terms}" terms)
string(REPLACE "\n\n" "\n.\n" terms "${terms}")
string(REPLACE "\n" "\n " terms "${terms}")
configure_file(${here}/copyright.in ${made}/copyright @ONLY)
file(APPEND ${made}/copyright " ${terms}\n")
foreach(component programs library)
    set(folder share/doc/wrinkle)
    if(component STREQUAL library)
        set(folder share/doc/libwrinkle-dev)
    endif()
    install(FILES ${made}/copyright DESTINATION ${folder} COMPONENT ${component})
    install(FILES CHANGELOG.md RENAME changelog DESTINATION ${folder} COMPONENT ${component})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Wrinkle authors <wrinkle@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${here}/compress.cmake)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME wrinkle)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "fonts-inter, fonts-jetbrains-mono, libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "Layered materials as graphs of nodes
Heights, normal maps, derivative maps and noise are layered as surface
gradients. The programs compile graphs to shaders, export them to engines,
bake maps, and edit, test, compare and merge them.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libwrinkle-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "wrinkle (= ${PROJECT_VERSION}), python3")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_DEV_PACKAGE_CONTROL_EXTRA ${here}/triggers)
set(CPACK_DEBIAN_DEV_DESCRIPTION "Wrinkle as a library, and the SDK of its plugins
Headers for C and C++, the module for Python, and the headers with which
nodes are written in shared objects.")
include(CPack)
cpack_add_component_group(dev)
cpack_add_component(programs)
cpack_add_component(library GROUP dev)
cpack_add_component(sdk GROUP dev)
