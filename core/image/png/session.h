// A file and libpng's state for it. libpng returns from errors by longjmp, so call() wraps every
// call that can fail.
#pragma once

#include <png.h>

#include <csetjmp>

#include "base/file.h"
#include "image/codec_support.h"

namespace wrinkle::png {

enum class Access { read, write };

class Session {
public:
    // Throws codec::Failure with the system's reason.
    Session(const char* path, Access access);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Calls work(png, info). Throws codec::Failure if libpng, or the system in reading or writing,
    // reports an error; destructors within `work` do not run then.
    template <typename Work>
    void call(Work work) {
        if (setjmp(png_jmpbuf(png_))) throw codec::Failure(problem_);
        work(png_, info_);
    }

    // Throws codec::Failure with the system's reason.
    void close_file();

private:
    void destroy();
    [[noreturn]] static void fail(png_structp png, png_const_charp text);
    static void read(png_structp png, png_bytep bytes, size_t size);
    static void write(png_structp png, png_bytep bytes, size_t size);

    OpenedFile file_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    Access access_;
    char problem_[256] = "";
};

}  // namespace wrinkle::png
