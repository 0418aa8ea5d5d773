// Output file of a writer. OpenImageIO's own proxy (IOFile) does not serve: OpenImageIO does not
// report every failed write, and never the reason; this class stores the first system error.
// OpenEXR's own library writes only through pwrite().
#pragma once

#include <OpenImageIO/filesystem.h>

#include <cstdio>
#include <string>

namespace wrinkle::oiio {

class OutputFile final : public OIIO::Filesystem::IOProxy {
public:
    explicit OutputFile(const char* path);
    ~OutputFile() override;

    // Not "file": OpenImageIO's JPEG writer treats each proxy of that name as its own class with a
    // FILE.
    const char* proxytype() const override { return "output"; }
    void close() override;
    bool seek(int64_t offset) override;
    size_t read(void* bytes, size_t size) override;
    size_t write(const void* bytes, size_t size) override;
    size_t pread(void* bytes, size_t size, int64_t offset) override;
    size_t pwrite(const void* bytes, size_t size, int64_t offset) override;
    size_t size() const override;
    void flush() const override;

    // Returns the first error; "" if there is none. Complete after close().
    std::string failure() const;

private:
    bool note(bool ok) const;
    bool move_to(int64_t offset);

    std::FILE* file_ = nullptr;
    mutable int error_ = 0;
    int64_t next_write_ = -1;  // position of the stream after a write; -1 if unknown
    int64_t end_ = 0;
};

}  // namespace wrinkle::oiio
