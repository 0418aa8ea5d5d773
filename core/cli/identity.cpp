#include "cli/identity.h"

#include <elf.h>
#include <link.h>

#include <cstring>

#include "base/file.h"
#include "base/sha256.h"

namespace wrinkle::cli {
namespace {

size_t padded(size_t size) {
    return (size + 3) & ~size_t{3};
}

// Returns the build id in an ELF note segment of `left` bytes, "" if there is none. A note is a
// header, a name and a content; name and content are padded to four bytes.
std::string build_id_in(const char* at, size_t left) {
    ElfW(Nhdr) note;
    while (left >= sizeof note) {
        std::memcpy(&note, at, sizeof note);
        const size_t name = sizeof note, content = name + padded(note.n_namesz);
        const size_t size = content + padded(note.n_descsz);
        if (size > left) break;
        if (note.n_type == NT_GNU_BUILD_ID && std::string_view(at + name, 3) == ELF_NOTE_GNU)
            return {at + content, note.n_descsz};
        at += size;
        left -= size;
    }
    return {};
}

void append_build_id(const dl_phdr_info* info, std::string& result) {
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        const ElfW(Phdr)& header = info->dlpi_phdr[i];
        if (header.p_type != PT_NOTE) continue;
        const auto* const notes = reinterpret_cast<const char*>(info->dlpi_addr + header.p_vaddr);
        const std::string id = build_id_in(notes, header.p_memsz);
        if (id.empty()) continue;
        result += id;
        break;
    }
}

int take_first(dl_phdr_info* info, size_t, void* result) {
    append_build_id(info, *static_cast<std::string*>(result));
    return 1;  // stop: the first object is the program
}

int take_each(dl_phdr_info* info, size_t, void* result) {
    append_build_id(info, *static_cast<std::string*>(result));
    return 0;
}

}  // namespace

std::string program_identity() {
    std::string id, why;
    dl_iterate_phdr(take_first, &id);
    if (id.empty()) {
        const auto bytes = read_file("/proc/self/exe", why);
        if (!bytes) return {};
        id = sha256(*bytes);
    }
    return WRINKLE_VERSION " " + id;
}

std::string loaded_identity() {
    std::string ids;
    dl_iterate_phdr(take_each, &ids);
    return ids;
}

}  // namespace wrinkle::cli
