// The file under a writer. OpenImageIO does not tell of every write that fails, and never why; this
// remembers the system's first error. Small writes are gathered. OpenEXR's own library writes
// through pwrite() alone.
#pragma once

#include <OpenImageIO/filesystem.h>

#include <string>
#include <vector>

namespace wrinkle::oiio {

class OutputFile final : public OIIO::Filesystem::IOProxy {
public:
    explicit OutputFile(const char* path);
    ~OutputFile() override;

    // Not "file": OpenImageIO's JPEG writer takes each proxy of that name for a FILE of its own.
    const char* proxytype() const override { return "output"; }
    void close() override;
    bool seek(int64_t offset) override;
    size_t read(void* bytes, size_t size) override;
    size_t write(const void* bytes, size_t size) override;
    size_t pread(void* bytes, size_t size, int64_t offset) override;
    size_t pwrite(const void* bytes, size_t size, int64_t offset) override;
    size_t size() const override;
    void flush() const override;

    // "" while all is well. Complete after close().
    std::string failure() const;

private:
    bool put(const char* bytes, size_t size) const;
    bool drain() const;

    int handle_ = -1;
    mutable int error_ = 0;
    mutable std::vector<char> gathered_;
    mutable int64_t gathered_at_ = 0;
    mutable int64_t end_ = 0;
};

}  // namespace wrinkle::oiio
