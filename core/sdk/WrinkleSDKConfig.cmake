# find_package(WrinkleSDK 1) gives the target Wrinkle::SDK, headers alone, and wrinkle_plugin().
include(${CMAKE_CURRENT_LIST_DIR}/WrinkleSDKTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/plugin.cmake)
