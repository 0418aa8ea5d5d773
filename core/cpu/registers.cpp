#include <algorithm>

#include "cpu/flatten.h"

namespace wrinkle {
namespace {

constexpr uint32_t never = ~0u;
constexpr uint32_t live_out = never - 1;

// Returns the last use of each register. A register defined before a loop and used in it is live
// until the loop's end; inputs, constants and outputs are live until the end of the program.
std::vector<uint32_t> last_uses(const Program& program, size_t registers) {
    std::vector<uint32_t> born(registers, 0), last(registers, 0), loop_end(program.steps.size());
    for (uint32_t s = 0; s < program.steps.size(); ++s)
        if (program.steps[s].kind == CpuInst::Kind::loop_end) loop_end[program.steps[s].extra] = s;
    std::vector<uint32_t> open;  // loop_begin steps of the enclosing loops
    std::vector<bool> written(registers, false);
    const auto touch = [&](uint32_t reg, uint32_t step) {
        uint32_t until = step;
        for (const uint32_t begin : open)
            if (born[reg] < begin) {
                until = std::max(until, loop_end[begin]);
                break;
            }
        last[reg] = std::max(last[reg], until);
    };
    for (uint32_t s = 0; s < program.steps.size(); ++s) {
        const CpuInst& step = program.steps[s];
        for (uint32_t i = 0; i < step.count; ++i)
            touch(step.in[i], s);
        for (uint32_t i = 0; i < step.outputs; ++i) {
            const uint32_t reg = step.out[i];
            if (!written[reg]) born[reg] = s;
            written[reg] = true;
            touch(reg, s);
        }
        if (step.kind == CpuInst::Kind::loop_begin) open.push_back(s);
        if (step.kind == CpuInst::Kind::loop_end) open.pop_back();
    }
    for (const Program::Input& input : program.inputs)
        last[input.reg] = live_out;
    for (const Program::Constant& constant : program.constants)
        last[constant.reg] = live_out;
    for (const Program::Output& output : program.outputs)
        for (const uint32_t reg : output.regs)
            last[reg] = live_out;
    return last;
}

// Free list of one register file: linear scan over the last uses. The number of registers need not
// be minimal.
struct File {
    std::vector<uint32_t> free;
    uint32_t size = 0;

    uint32_t take() {
        if (free.empty()) return size++;
        const uint32_t reg = free.back();
        free.pop_back();
        return reg;
    }
};

struct Allocator {
    const std::vector<bool>&integer, &uniform;
    std::vector<uint32_t> slot;
    File files[2][2];  // by integer and uniform

    File& file(uint32_t reg) { return files[integer[reg]][uniform[reg]]; }
    void define(uint32_t reg) {
        if (slot[reg] == never) slot[reg] = file(reg).take();
    }
    void release(uint32_t reg) { file(reg).free.push_back(slot[reg]); }
    // Uniform registers come first. Precondition: all registers have a slot.
    uint32_t final_register(uint32_t reg) const {
        return slot[reg] + (uniform[reg] ? 0 : files[integer[reg]][1].size);
    }
};

void allocate_slots(const Program& program, Allocator& allocator) {
    const size_t registers = allocator.slot.size();
    const std::vector<uint32_t> last = last_uses(program, registers);
    std::vector<std::vector<uint32_t>> dying(program.steps.size());
    for (uint32_t reg = 0; reg < registers; ++reg)
        if (last[reg] < program.steps.size()) dying[last[reg]].push_back(reg);
    for (const Program::Constant& constant : program.constants)
        allocator.define(constant.reg);
    for (const Program::Input& input : program.inputs)
        allocator.define(input.reg);
    for (uint32_t s = 0; s < program.steps.size(); ++s) {
        const CpuInst& step = program.steps[s];
        for (uint32_t i = 0; i < step.outputs; ++i)
            allocator.define(step.out[i]);
        for (const uint32_t reg : dying[s])
            if (allocator.slot[reg] != never) allocator.release(reg);
    }
}

}  // namespace

void allocate_registers(Program& program, const std::vector<bool>& integer,
                        const std::vector<bool>& uniform) {
    Allocator allocator{integer, uniform, std::vector<uint32_t>(integer.size(), never), {}};
    allocate_slots(program, allocator);
    for (CpuInst& step : program.steps) {
        step.to_uniform = step.outputs > 0 && uniform[step.out[0]];
        for (uint32_t i = 0; i < step.count; ++i) {
            if (uniform[step.in[i]]) step.uniform |= static_cast<uint8_t>(1U << i);
            step.in[i] = allocator.final_register(step.in[i]);
        }
        for (uint32_t i = 0; i < step.outputs; ++i)
            step.out[i] = allocator.final_register(step.out[i]);
    }
    for (Program::Constant& constant : program.constants)
        constant.reg = allocator.final_register(constant.reg);
    for (Program::Input& input : program.inputs)
        input.reg = allocator.final_register(input.reg);
    for (Program::Output& output : program.outputs)
        for (uint32_t& reg : output.regs)
            reg = allocator.final_register(reg);
    program.uniform_floats = allocator.files[0][1].size;
    program.uniform_integers = allocator.files[1][1].size;
    program.float_registers = allocator.files[0][0].size + program.uniform_floats;
    program.integer_registers = allocator.files[1][0].size + program.uniform_integers;
}

}  // namespace wrinkle
