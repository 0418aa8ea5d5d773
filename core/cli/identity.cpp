#include "cli/identity.h"

#include <elf.h>
#include <link.h>

#include <charconv>
#include <cstring>

#include "base/checksum.h"
#include "base/file.h"

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

std::string build_id_of(const dl_phdr_info& object) {
    for (int i = 0; i < object.dlpi_phnum; ++i) {
        const ElfW(Phdr)& header = object.dlpi_phdr[i];
        if (header.p_type != PT_NOTE) continue;
        const auto* const notes = reinterpret_cast<const char*>(object.dlpi_addr + header.p_vaddr);
        if (std::string id = build_id_in(notes, header.p_memsz); !id.empty()) return id;
    }
    return {};
}

// Build ids of the program and the loaded libraries, in this order; "" for one without.
std::vector<std::string> build_ids() {
    std::vector<std::string> ids;
    const auto add = [](dl_phdr_info* object, size_t, void* list) {
        static_cast<std::vector<std::string>*>(list)->push_back(build_id_of(*object));
        return 0;
    };
    dl_iterate_phdr(add, &ids);
    return ids;
}

}  // namespace

std::string program_identity() {
    std::string id = build_ids().at(0);
    if (id.empty()) {
        std::string why;
        const auto bytes = read_file("/proc/self/exe", why);
        if (!bytes) return {};
        id = sha256(*bytes);
    }
    return WRINKLE_VERSION " " + id;
}

std::string loaded_identity() {
    std::string all;
    for (const std::string& id : build_ids())
        all += id;
    return all;
}

std::string join_fields(const std::vector<std::string>& fields) {
    std::string bytes;
    for (const std::string& field : fields)
        bytes += std::to_string(field.size()) + "\n" + field;
    return bytes;
}

std::optional<std::vector<std::string>> split_fields(std::string_view bytes) {
    std::vector<std::string> fields;
    while (!bytes.empty()) {
        size_t size = 0;
        const char* const end = bytes.data() + bytes.size();
        const auto [stop, problem] = std::from_chars(bytes.data(), end, size);
        if (problem != std::errc() || stop == end || *stop != '\n') return {};
        bytes.remove_prefix(static_cast<size_t>(stop - bytes.data()) + 1);
        if (size > bytes.size()) return {};
        fields.emplace_back(bytes.substr(0, size));
        bytes.remove_prefix(size);
    }
    return fields;
}

}  // namespace wrinkle::cli
