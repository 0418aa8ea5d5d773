// Runs a body on a thread with a small stack (in bytes): recursion over the input overflows it.
#pragma once

#include <gtest/gtest.h>
#include <pthread.h>

namespace wrinkle::test {

inline void on_small_stack(void (*body)(), size_t size = 256 * 1024) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, size);
    pthread_t thread;
    const auto run = [](void* argument) -> void* {
        reinterpret_cast<void (*)()>(argument)();
        return nullptr;
    };
    ASSERT_EQ(pthread_create(&thread, &attributes, run, reinterpret_cast<void*>(body)), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
}

}  // namespace wrinkle::test
