#include "cpu/evaluate.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "cpu/kernels.h"

namespace wrinkle {
namespace {

// A loop under way: which lanes still go on, and how often it has run.
struct RunningLoop {
    std::array<uint8_t, tile_lanes> active;
    uint32_t iterations = 0;
    uint32_t limit = 0;
};

template <class T>
class Tile {
public:
    Tile(const Program& program, const PointSet& points, std::span<const Texture> textures)
        : program_(program), points_(points), textures_(textures) {
        registers_.floats.resize(program.float_registers * tile_lanes);
        registers_.integers.resize(program.integer_registers * tile_lanes);
        for (const Program::Constant& constant : program.constants)
            load(constant);
    }

    void run(size_t first, size_t count, Results& results) {
        count_ = count;
        for (const Program::Input& input : program_.inputs)
            load(input, first);
        for (uint32_t step = 0; step < program_.steps.size();)
            step = execute(step);
        for (size_t i = 0; i < program_.outputs.size(); ++i)
            store(program_.outputs[i], first, results.values[i]);
    }

private:
    void load(const Program::Constant& constant) {
        if (constant.integer) {
            const auto bits = static_cast<uint32_t>(static_cast<int64_t>(constant.value));
            std::fill_n(registers_.i(constant.reg), tile_lanes, bits);
        } else {
            std::fill_n(registers_.f(constant.reg), tile_lanes, static_cast<T>(constant.value));
        }
    }

    void load(const Program::Input& input, size_t first) {
        const std::vector<double>& values = points_.at(input.input, input.variant);
        const size_t lanes = info(info(input.input).type).lanes;
        T* out = registers_.f(input.reg);
        for (size_t k = 0; k < count_; ++k)
            out[k] = static_cast<T>(values[(first + k) * lanes + input.lane]);
    }

    void store(const Program::Output& output, size_t first, std::vector<double>& values) {
        const size_t lanes = output.regs.size();
        const bool integer =
            output.type == Type::int_ || output.type == Type::uint_ || output.type == Type::bool_;
        for (size_t lane = 0; lane < lanes; ++lane)
            for (size_t k = 0; k < count_; ++k)
                values[(first + k) * lanes + lane] =
                    integer ? static_cast<double>(registers_.i(output.regs[lane])[k])
                            : static_cast<double>(registers_.f(output.regs[lane])[k]);
    }

    uint32_t execute(uint32_t index) {
        const Step& step = program_.steps[index];
        switch (step.kind) {
            case Step::Kind::op:
                run_op(step);
                break;
            case Step::Kind::sample:
                sample(step);
                break;
            case Step::Kind::size:
                size(step);
                break;
            case Step::Kind::move:
                move(step, nullptr);
                break;
            case Step::Kind::masked_move:
                move(step, loops_.back().active.data());
                break;
            case Step::Kind::loop_begin:
                begin(step);
                break;
            case Step::Kind::loop_test:
                test(step);
                break;
            case Step::Kind::loop_end:
                return end(step, index);
        }
        return index + 1;
    }

    void run_op(const Step& step) {
        const bool integer_result = step.type != Type::float_ && step.op != Op::to_float_ &&
                                    step.op != Op::select_ && info(step.op).rule != Rule::compare;
        bool done = false;
        if (step.op == Op::select_ && step.type != Type::float_) {
            select_integer(step);
            done = true;
        } else if (info(step.op).rule == Rule::compare) {
            done = run_comparison(step, registers_, count_);
        } else if (integer_result) {
            done = run_integer(step, registers_.i(step.out[0]), registers_.i(step.in[0]),
                               registers_.i(step.in[1]), count_);
        } else {
            done = run_conversion(step, registers_, count_) ||
                   run_arithmetic(step, registers_, count_) ||
                   run_transcendental(step, registers_, count_);
        }
        assert(done && "an op without a CPU case");
        static_cast<void>(done);
    }

    void select_integer(const Step& step) {
        uint32_t* out = registers_.i(step.out[0]);
        const uint32_t *condition = registers_.i(step.in[0]), *a = registers_.i(step.in[1]),
                       *b = registers_.i(step.in[2]);
        for (size_t k = 0; k < count_; ++k)
            out[k] = condition[k] ? a[k] : b[k];
    }

    void sample(const Step& step) {
        const Texture& texture = textures_[step.extra];
        const T *u = registers_.f(step.in[0]), *v = registers_.f(step.in[1]),
                *lod = registers_.f(step.in[2]);
        for (size_t k = 0; k < count_; ++k) {
            const std::array<T, 4> texel = texture.sample_lod(u[k], v[k], lod[k]);
            for (size_t i = 0; i < 4; ++i)
                registers_.f(step.out[i])[k] = texel[i];
        }
    }

    void size(const Step& step) {
        const Texture& texture = textures_[step.extra];
        std::fill_n(registers_.f(step.out[0]), count_, static_cast<T>(texture.width()));
        std::fill_n(registers_.f(step.out[1]), count_, static_cast<T>(texture.height()));
    }

    template <class Lane>
    void move_lanes(Lane* out, const Lane* from, const uint8_t* mask) {
        for (size_t k = 0; k < count_; ++k)
            if (!mask || mask[k]) out[k] = from[k];
    }
    void move(const Step& step, const uint8_t* mask) {
        if (step.type == Type::float_)
            move_lanes(registers_.f(step.out[0]), registers_.f(step.in[0]), mask);
        else
            move_lanes(registers_.i(step.out[0]), registers_.i(step.in[0]), mask);
    }

    void begin(const Step& step) {
        RunningLoop loop;
        loop.limit = step.extra;
        if (loops_.empty())
            loop.active.fill(1);
        else
            loop.active = loops_.back().active;
        loops_.push_back(loop);
    }

    void test(const Step& step) {
        RunningLoop& loop = loops_.back();
        const uint32_t* goes_on = registers_.i(step.in[0]);
        const bool may_run = loop.iterations < loop.limit;
        for (size_t k = 0; k < count_; ++k)
            loop.active[k] = static_cast<uint8_t>(loop.active[k] && may_run && goes_on[k]);
    }

    uint32_t end(const Step& step, uint32_t index) {
        RunningLoop& loop = loops_.back();
        ++loop.iterations;
        const bool any = std::any_of(loop.active.begin(), loop.active.begin() + count_,
                                     [](uint8_t lane) { return lane != 0; });
        if (any && loop.iterations < loop.limit) return step.extra + 1;
        loops_.pop_back();
        return index + 1;
    }

    const Program& program_;
    const PointSet& points_;
    std::span<const Texture> textures_;
    Registers<T> registers_;
    std::vector<RunningLoop> loops_;
    size_t count_ = 0;
};

}  // namespace

std::vector<InputNeed> needed_inputs(const Program& program) {
    std::set<std::pair<SurfaceInput, Variant>> needs;
    for (const Program::Input& input : program.inputs)
        needs.insert({input.input, input.variant});
    std::vector<InputNeed> list;
    for (const auto& [input, variant] : needs)
        list.push_back({input, variant});
    return list;
}

Results make_results(const Program& program, size_t points) {
    Results results;
    for (const Program::Output& output : program.outputs)
        results.values.emplace_back(output.regs.size() * points);
    return results;
}

template <class T>
void evaluate(const Program& program, const PointSet& points, std::span<const Texture> textures,
              size_t first, size_t count, Results& results) {
    Tile<T> tile(program, points, textures);
    for (size_t done = 0; done < count; done += tile_lanes)
        tile.run(first + done, std::min(tile_lanes, count - done), results);
}

template void evaluate<float>(const Program&, const PointSet&, std::span<const Texture>, size_t,
                              size_t, Results&);
template void evaluate<double>(const Program&, const PointSet&, std::span<const Texture>, size_t,
                               size_t, Results&);

}  // namespace wrinkle
