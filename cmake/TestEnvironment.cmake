# For every test that ctest starts: the plugins of the user who runs it are none of its own.
set(ENV{WRINKLE_NO_DEFAULT_PLUGINS} 1)
unset(ENV{WRINKLE_PLUGIN_PATH})
