#include "image/png/session.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

namespace wrinkle::png {
namespace {

void ignore_warning(png_structp, png_const_charp) {}
void flush_nothing(png_structp) {}

Session& session_of(png_structp png) {
    return *static_cast<Session*>(png_get_error_ptr(png));
}

}  // namespace

Session::Session(const char* path, Access access)
    : file_(std::fopen(path, access == Access::read ? "rbe" : "wbe")), access_(access) {
    if (!file_) throw codec::Failure(std::strerror(errno));
    const auto create = access == Access::read ? png_create_read_struct : png_create_write_struct;
    png_ = create(PNG_LIBPNG_VER_STRING, this, fail, ignore_warning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
        destroy();
        throw std::bad_alloc();
    }
    if (access == Access::read)
        png_set_read_fn(png_, nullptr, read);
    else
        png_set_write_fn(png_, nullptr, write, flush_nothing);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // the caller has limits
}

Session::~Session() {
    destroy();
}

void Session::destroy() {
    if (access_ == Access::read)
        png_destroy_read_struct(&png_, &info_, nullptr);
    else
        png_destroy_write_struct(&png_, &info_);
}

void Session::close_file() {
    if (std::fclose(file_.release()) != 0) throw codec::Failure(std::strerror(errno));
}

void Session::fail(png_structp png, png_const_charp text) {
    std::snprintf(session_of(png).problem_, sizeof problem_, "%s", text);
    png_longjmp(png, 1);
}

void Session::read(png_structp png, png_bytep bytes, size_t size) {
    std::FILE* file = session_of(png).file_.get();
    if (std::fread(bytes, 1, size, file) == size) return;
    fail(png, std::ferror(file) ? std::strerror(errno) : "it ends early");
}

void Session::write(png_structp png, png_bytep bytes, size_t size) {
    if (std::fwrite(bytes, 1, size, session_of(png).file_.get()) != size)
        fail(png, std::strerror(errno));
}

}  // namespace wrinkle::png
