// Replaces the allocator of a program that links this folder by mimalloc, which is faster for the
// hundreds of small allocations that compilation makes per node.

#include <mimalloc.h>

#include <new>

namespace {

// Environment variables MIMALLOC_... override these defaults.
[[maybe_unused]] const bool settled = [] {
    // Large graphs and bakes access much memory at random: huge pages of 2 MiB, if available, avoid
    // TLB misses.
    mi_option_set_enabled_default(mi_option_large_os_pages, true);
    // Memory that one graph frees is reused by the next; it returns to the system after a second.
    mi_option_set_default(mi_option_decommit_delay, 1000);
    return true;
}();

void* or_throw(void* memory) {
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

// mimalloc is built as C: its operator new ends the program when memory is exhausted. Its operators
// delete are used.
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
