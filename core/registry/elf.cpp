#include "registry/library.h"

#include <elf.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

namespace wrinkle {
namespace {

constexpr auto own_class = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;
constexpr auto own_order = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
#if defined(__x86_64__)
constexpr uint32_t own_machine = EM_X86_64;
#elif defined(__aarch64__)
constexpr uint32_t own_machine = EM_AARCH64;
#else
constexpr uint32_t own_machine = EM_NONE;  // not compared
#endif

std::string machine_name(uint32_t machine) {
    constexpr std::pair<uint32_t, const char*> names[] = {
        {EM_386, "x86"},         {EM_X86_64, "x86-64"}, {EM_ARM, "ARM"},
        {EM_AARCH64, "AArch64"}, {EM_RISCV, "RISC-V"},  {EM_PPC64, "PowerPC 64"},
    };
    for (const auto& [number, name] : names)
        if (number == machine) return name;
    return "machine " + std::to_string(machine);
}

bool is_cut_short(const Elf64_Ehdr& head, std::string_view bytes) {
    const auto ends_after = [&](uint64_t at, uint64_t size) {
        return at > bytes.size() || size > bytes.size() - at;
    };
    if (ends_after(head.e_shoff, uint64_t{head.e_shentsize} * head.e_shnum) ||
        ends_after(head.e_phoff, sizeof(Elf64_Phdr) * head.e_phnum))
        return true;
    for (size_t i = 0; i < head.e_phnum; ++i) {
        Elf64_Phdr part;
        std::memcpy(&part, bytes.data() + head.e_phoff + i * sizeof part, sizeof part);
        if (ends_after(part.p_offset, part.p_filesz)) return true;
    }
    return false;
}

}  // namespace

std::string elf_fault(std::string_view bytes) {
    if (bytes.empty()) return "the file is empty";
    if (bytes.substr(0, SELFMAG) != std::string_view(ELFMAG).substr(0, bytes.size()))
        return "it is not a shared object";
    Elf64_Ehdr head;
    if (bytes.size() < sizeof head) return "the file is cut short";
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.e_ident[EI_CLASS] != own_class)
        return "it is built for " + std::string(own_class == ELFCLASS64 ? "32" : "64") +
               "-bit programs, or damaged";
    if (head.e_ident[EI_DATA] != own_order) return "it is built for another byte order, or damaged";
    if (own_machine != EM_NONE && head.e_machine != own_machine)
        return "it is built for " + machine_name(head.e_machine) + ", this program for " +
               machine_name(own_machine);
    if (head.e_type != ET_DYN) return "it is not a shared object";
    if (own_class == ELFCLASS64 && is_cut_short(head, bytes)) return "the file is cut short";
    return {};
}

}  // namespace wrinkle
