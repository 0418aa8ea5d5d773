// OpenImageIO's dependencies start threads while they are loaded (log4cplus); the leak checker of
// gcc 12 then mistakes the thread-local storage of late modules and crashes at exit. Without the
// interception it finds that storage itself.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "intercept_tls_get_addr=0";
}
