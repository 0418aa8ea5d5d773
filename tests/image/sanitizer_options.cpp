// OpenImageIO's dependencies start threads while they are loaded (log4cplus), and the leak checker
// of gcc 12 then mistakes the thread-local storage of late modules and crashes at exit; it finds
// that storage on its own without the interception.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "intercept_tls_get_addr=0";
}
