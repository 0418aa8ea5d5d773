// Compiling makes and drops a hundred small things for every node, which mimalloc does faster than
// the C library. It has no header: a program that links this folder has it.

#include <mimalloc.h>

#include <new>

namespace {

// A user's MIMALLOC_... of the environment stand above these.
[[maybe_unused]] const bool settled = [] {
    // A graph of ten thousand nodes and the pictures of a bake reach all over their memory: pages
    // of 2 MiB, where the system has them to give, spare misses of the table of pages.
    mi_option_set_enabled_default(mi_option_large_os_pages, true);
    // What one graph let go, the next one takes: it goes back to the system after a second's rest.
    mi_option_set_default(mi_option_decommit_delay, 1000);
    return true;
}();

void* or_throw(void* memory) {
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

// Built as C, mimalloc's own ends the program where memory does. It has the ways to delete.
void* operator new(std::size_t size) {
    return or_throw(mi_malloc(size));
}
void* operator new[](std::size_t size) {
    return or_throw(mi_malloc(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return or_throw(mi_malloc_aligned(size, static_cast<std::size_t>(alignment)));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return or_throw(mi_malloc_aligned(size, static_cast<std::size_t>(alignment)));
}
