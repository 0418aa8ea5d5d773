#include "image/oiio/output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace wrinkle::oiio {

OutputFile::OutputFile(const char* path) : IOProxy(path, Write), file_(std::fopen(path, "w+be")) {
    if (note(file_ != nullptr)) std::setvbuf(file_, nullptr, _IOFBF, size_t{1} << 20);
}

OutputFile::~OutputFile() {
    close();
}

void OutputFile::close() {
    if (!file_) return;
    note(std::fclose(std::exchange(file_, nullptr)) == 0);
    m_mode = Closed;
}

// Stores the system's error if `ok` is false and there is none yet; returns `ok`.
bool OutputFile::note(bool ok) const {
    if (!ok && error_ == 0) error_ = errno;
    return ok;
}

// A seek empties the buffer, so it is left out between writes of adjacent bytes.
bool OutputFile::move_to(int64_t offset) {
    if (std::exchange(next_write_, -1) == offset) return true;
    return note(::fseeko(file_, offset, SEEK_SET) == 0);
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
    next_write_ = -1;
    if (error_ != 0 || !file_ || !move_to(offset)) return 0;
    return std::fread(bytes, 1, size, file_);
}

size_t OutputFile::pwrite(const void* bytes, size_t size, int64_t offset) {
    if (error_ != 0 || !file_ || !move_to(offset)) return 0;
    const size_t count = std::fwrite(bytes, 1, size, file_);
    if (!note(count == size)) return count;
    next_write_ = offset + static_cast<int64_t>(count);
    end_ = std::max(end_, next_write_);
    return count;
}

size_t OutputFile::size() const {
    return static_cast<size_t>(end_);
}

void OutputFile::flush() const {
    if (file_) note(std::fflush(file_) == 0);
}

std::string OutputFile::failure() const {
    return error_ ? std::strerror(error_) : "";
}

}  // namespace wrinkle::oiio
