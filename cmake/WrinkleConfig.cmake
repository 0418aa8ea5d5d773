# find_package(Wrinkle) gives the program as the target Wrinkle::wrinkle, and wrinkle_compile().
include(${CMAKE_CURRENT_LIST_DIR}/WrinkleTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/WrinkleCompile.cmake)
