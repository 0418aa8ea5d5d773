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
    Tile(const Program& program, const PointSet& points, std::span<const Texture> textures,
         RunOp<T> run_op)
        : program_(program),
          points_(points),
          textures_(textures),
          run_op_(run_op),
          floats_(program.float_registers * tile_lanes),
          integers_(program.integer_registers * tile_lanes) {}

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
    T* floats(uint32_t reg) { return floats_.data() + reg * tile_lanes; }
    uint32_t* integers(uint32_t reg) { return integers_.data() + reg * tile_lanes; }

    void load(const Program::Input& input, size_t first) {
        const std::vector<double>& values = points_.at(input.input, input.variant);
        const size_t lanes = info(info(input.input).type).lanes;
        T* out = floats(input.reg);
        for (size_t k = 0; k < count_; ++k)
            out[k] = static_cast<T>(values[(first + k) * lanes + input.lane]);
    }

    double lane(const Program::Output& output, uint32_t reg, size_t k) {
        if (!is_integer_type(output.type)) return static_cast<double>(floats(reg)[k]);
        const uint32_t bits = integers(reg)[k];
        return output.type == Type::int_ ? static_cast<double>(static_cast<int32_t>(bits))
                                         : static_cast<double>(bits);
    }

    void store(const Program::Output& output, size_t first, std::vector<double>& values) {
        const size_t lanes = output.regs.size();
        for (size_t i = 0; i < lanes; ++i)
            for (size_t k = 0; k < count_; ++k)
                values[(first + k) * lanes + i] = lane(output, output.regs[i], k);
    }

    uint32_t execute(uint32_t index) {
        const Step& step = program_.steps[index];
        switch (step.kind) {
            case Step::Kind::op:
                if (!run_op_(step, {floats_.data(), integers_.data()}, count_))
                    assert(!"an op without a CPU case");
                break;
            case Step::Kind::constant:
                constant(step);
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

    void constant(const Step& step) {
        const double value = program_.constants[step.extra];
        if (step.type == Type::float_)
            std::fill_n(floats(step.out[0]), count_, static_cast<T>(value));
        else
            std::fill_n(integers(step.out[0]), count_,
                        static_cast<uint32_t>(static_cast<int64_t>(value)));
    }

    void sample(const Step& step) {
        const Texture& texture = textures_[step.extra];
        const T *u = floats(step.in[0]), *v = floats(step.in[1]), *lod = floats(step.in[2]);
        for (size_t k = 0; k < count_; ++k) {
            const std::array<T, 4> texel = texture.sample_lod(u[k], v[k], lod[k]);
            for (size_t i = 0; i < 4; ++i)
                floats(step.out[i])[k] = texel[i];
        }
    }

    void size(const Step& step) {
        const Texture& texture = textures_[step.extra];
        std::fill_n(floats(step.out[0]), count_, static_cast<T>(texture.width()));
        std::fill_n(floats(step.out[1]), count_, static_cast<T>(texture.height()));
    }

    template <class Lane>
    void move_lanes(Lane* out, const Lane* from, const uint8_t* mask) {
        for (size_t k = 0; k < count_; ++k)
            if (!mask || mask[k]) out[k] = from[k];
    }
    void move(const Step& step, const uint8_t* mask) {
        if (step.type == Type::float_)
            move_lanes(floats(step.out[0]), floats(step.in[0]), mask);
        else
            move_lanes(integers(step.out[0]), integers(step.in[0]), mask);
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
        const uint32_t* goes_on = integers(step.in[0]);
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
    RunOp<T> run_op_;
    std::vector<T> floats_;
    std::vector<uint32_t> integers_;
    std::vector<RunningLoop> loops_;
    size_t count_ = 0;
};

template <class T>
RunOp<T> run_op_of(InstructionSet set) {
#if defined(WRINKLE_HAS_AVX2)
    if (set == InstructionSet::avx2) return avx2::run_op;
#endif
    assert(set == InstructionSet::baseline);
    static_cast<void>(set);
    return baseline::run_op;
}

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
              size_t first, size_t count, Results& results, InstructionSet set) {
    Tile<T> tile(program, points, textures, run_op_of<T>(set));
    for (size_t done = 0; done < count; done += tile_lanes)
        tile.run(first + done, std::min(tile_lanes, count - done), results);
}

template void evaluate<float>(const Program&, const PointSet&, std::span<const Texture>, size_t,
                              size_t, Results&, InstructionSet);
template void evaluate<double>(const Program&, const PointSet&, std::span<const Texture>, size_t,
                               size_t, Results&, InstructionSet);

}  // namespace wrinkle
