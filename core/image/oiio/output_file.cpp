#include "image/oiio/output_file.h"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace wrinkle::oiio {

namespace {

constexpr size_t gather_limit = size_t{1} << 20;
constexpr size_t large = size_t{1} << 15;  // written without a copy

}  // namespace

OutputFile::OutputFile(const char* path)
    : IOProxy(path, Write), handle_(::open(path, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (handle_ < 0) error_ = errno;
}

OutputFile::~OutputFile() {
    close();
}

void OutputFile::close() {
    if (handle_ < 0) return;
    drain();
    if (::close(handle_) != 0 && error_ == 0) error_ = errno;
    handle_ = -1;
    m_mode = Closed;
}

// Writes the buffered bytes and, after them, `bytes`.
bool OutputFile::put(const char* bytes, size_t size) const {
    iovec parts[] = {{gathered_.data(), gathered_.size()}, {const_cast<char*>(bytes), size}};
    int64_t offset = gathered_at_;
    while (parts[0].iov_len + parts[1].iov_len > 0 && error_ == 0) {
        const ssize_t count = ::pwritev(handle_, parts, 2, offset);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            error_ = count < 0 ? errno : ENOSPC;
            break;
        }
        offset += count;
        auto left = static_cast<size_t>(count);
        for (iovec& part : parts) {
            const size_t taken = std::min(left, part.iov_len);
            part.iov_base = static_cast<char*>(part.iov_base) + taken;
            part.iov_len -= taken;
            left -= taken;
        }
    }
    gathered_.clear();
    return error_ == 0;
}

bool OutputFile::drain() const {
    return put(nullptr, 0);
}

bool OutputFile::seek(int64_t offset) {
    m_pos = offset;
    return offset >= 0;
}

size_t OutputFile::read(void* bytes, size_t size) {
    const size_t count = pread(bytes, size, m_pos);
    m_pos += static_cast<int64_t>(count);
    return count;
}

size_t OutputFile::write(const void* bytes, size_t size) {
    const size_t count = pwrite(bytes, size, m_pos);
    m_pos += static_cast<int64_t>(count);
    return count;
}

size_t OutputFile::pread(void* bytes, size_t size, int64_t offset) {
    if (!drain()) return 0;
    const ssize_t count = ::pread(handle_, bytes, size, offset);
    return count < 0 ? 0 : static_cast<size_t>(count);
}

size_t OutputFile::pwrite(const void* bytes, size_t size, int64_t offset) {
    if (error_ != 0 || handle_ < 0) return 0;
    const bool follows =
        !gathered_.empty() && offset == gathered_at_ + static_cast<int64_t>(gathered_.size());
    if (!follows && !drain()) return 0;
    const char* first = static_cast<const char*>(bytes);
    end_ = std::max(end_, offset + static_cast<int64_t>(size));
    if (gathered_.empty()) gathered_at_ = offset;
    if (size >= large || gathered_.size() + size > gather_limit) return put(first, size) ? size : 0;
    gathered_.insert(gathered_.end(), first, first + size);
    return size;
}

size_t OutputFile::size() const {
    return static_cast<size_t>(end_);
}

void OutputFile::flush() const {
    drain();
}

std::string OutputFile::failure() const {
    return error_ ? std::strerror(error_) : "";
}

}  // namespace wrinkle::oiio
