// Tests of recording and replaying the calls of a build(): the host receives the calls that the
// node made, and damaged recordings never cause access to invalid memory.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "registry/recording.h"

namespace wrinkle {
namespace {

// Records its calls, and returns ids that the recorder does not produce.
class Host {
public:
    Host() {
        using B = const wr_builder*;
        face.size = sizeof face;
        face.host = this;
        face.input = [](B b, uint32_t p) { return log(b, "input", {p}).next(); };
        face.image = [](B b, uint32_t p) { return log(b, "image", {p}).next(); };
        face.option = [](B b, uint32_t p) {
            log(b, "option", {p});
            return 7;
        };
        face.field = [](B b, uint32_t p, wr_value at) { return log(b, "field", {p, at}).next(); };
        face.literal = [](B b, uint32_t type, const double* lanes) {
            Host& host = log(b, "literal", {type});
            for (int i = 0; lanes && i < (type == WR_TYPE_mat3 ? 9
                                          : type <= 4          ? int(type)
                                                               : 1);
                 ++i)
                host.text += " " + std::to_string(lanes[i]);
            return host.next();
        };
        face.surface = [](B b, uint32_t i) { return log(b, "surface", {i}).next(); };
        face.emit = [](B b, uint32_t op, uint32_t type, const wr_value* args, uint32_t count,
                       uint32_t extra) {
            return log(b, "emit", {op, type, extra}).list(args, count).next();
        };
        face.sample = [](B b, uint32_t op, wr_image image, const wr_value* args, uint32_t count) {
            return log(b, "sample", {op, image}).list(args, count).next();
        };
        face.begin_region = [](B b, uint32_t kind, const char* name, const uint32_t* types,
                               uint32_t count, wr_value* params) {
            Host& host = log(b, "begin", {kind}).say(name).list(types, count);
            for (uint32_t i = 0; params && i < count; ++i)
                params[i] = host.next();
        };
        face.end_region = [](B b, const wr_value* results, uint32_t count, uint32_t max) {
            return log(b, "end", {max}).list(results, count).next();
        };
        face.apply = [](B b, wr_region region, const wr_value* args, uint32_t count,
                        wr_value* results, uint32_t result_count) {
            Host& host = log(b, "apply", {region, result_count}).list(args, count);
            for (uint32_t i = 0; results && i < result_count; ++i)
                results[i] = host.next();
        };
        face.output = [](B b, uint32_t p, wr_value value) { log(b, "output", {p, value}); };
        face.error = [](B b, const char* message) { log(b, "error", {}).say(message); };
        face.name = [](B b, wr_value value, const char* name) {
            log(b, "name", {value}).say(name);
        };
        face.channel = [](B b, wr_value material, const char* name, uint32_t type) {
            return log(b, "channel", {material, type}).say(name).next();
        };
        face.with_channel = [](B b, wr_value material, const char* name, uint32_t type,
                               wr_value value) {
            return log(b, "with_channel", {material, type, value}).say(name).next();
        };
        face.mix_materials = [](B b, wr_value one, wr_value other, wr_value t) {
            return log(b, "mix_materials", {one, other, t}).next();
        };
        face.get_extension = [](B, const char*) -> const void* { return nullptr; };
    }

    wr_builder face{};
    std::string text;

private:
    static Host& log(const wr_builder* b, const char* call, std::vector<uint32_t> numbers) {
        Host& host = *static_cast<Host*>(b->host);
        host.text += std::string("\n") + call;
        for (const uint32_t number : numbers)
            host.text += " " + std::to_string(number);
        return host;
    }
    Host& say(const char* words) {
        text += words ? " '" + std::string(words) + "'" : " null";
        return *this;
    }
    Host& list(const uint32_t* values, uint32_t count) {
        text += " (" + std::to_string(count);
        for (uint32_t i = 0; values && i < count; ++i)
            text += " " + std::to_string(values[i]);
        text += values ? ")" : " null)";
        return *this;
    }
    uint32_t next() { return last_ += 3; }

    uint32_t last_ = 1000;
};

// Makes every call, with ids of every kind, including null and excessive counts.
void make_every_call(const wr_builder* b) {
    const wr_value x = b->input(b, 0);
    const wr_image image = b->image(b, 1);
    const double lanes[9] = {0.5, -1, 1e300, 4, 5, 6, 7, 8, 1e-300};
    for (const uint32_t type : {WR_TYPE_float, WR_TYPE_vec3, WR_TYPE_mat3, WR_TYPE_bool})
        b->literal(b, type, lanes);
    b->literal(b, WR_TYPE_float, nullptr);
    const wr_value options[] = {b->surface(b, 3), WR_POISON, b->field(b, 2, x), 123456};
    b->emit(b, WR_OP_construct, WR_TYPE_vec4, options, 4, 0);
    b->emit(b, WR_OP_add, 0, nullptr, 2, 0);
    b->emit(b, WR_OP_gradient_from_height, 0, &x, 1, x);
    b->emit(b, WR_OP_frame, 0, &x, 1, WR_FRAME(WR_FRAME_exact, WR_SCALE_unit));
    const std::vector<wr_value> many(1000, x);
    b->emit(b, WR_OP_add, 0, many.data(), 1000, 0);
    b->sample(b, WR_OP_sample_lod, image, options, 2);
    uint32_t types[] = {WR_TYPE_float, WR_TYPE_vec2};
    wr_value params[2] = {}, results[3] = {};
    b->begin_region(b, WR_REGION_LOOP, "loop", types, 2, params);
    const wr_region loop = b->end_region(b, params, 2, 64);
    b->apply(b, loop, params, 2, results, 3);
    b->begin_region(b, 9, nullptr, nullptr, 2, nullptr);
    b->end_region(b, nullptr, 0, 0);
    b->apply(b, 0, nullptr, 2, nullptr, 0);
    b->name(b, results[2], "third");
    b->error(b, nullptr);
    b->error(b, b->option(b, 4) == 7 ? "seven" : "another");
    const wr_value glossy = b->with_channel(b, WR_POISON, "roughness", WR_PORT_float, x);
    const wr_value mixed = b->mix_materials(b, glossy, x, params[0]);
    b->output(b, 5, b->channel(b, mixed, "roughness", WR_PORT_float));
    b->output(b, 5, results[1]);
}

std::string recorded() {
    const std::vector<int32_t> options{0, 0, 0, 0, 7};
    Recorder recorder(options, [] { std::abort(); });
    make_every_call(recorder.builder());
    return recorder.calls();
}

TEST(Recording, ReplayedMakesTheCallsThatWereMade) {
    Host direct, later;
    make_every_call(&direct.face);
    EXPECT_TRUE(replay(recorded(), &later.face));
    // Ids that only the host can check are replayed as an id without a value, and an array that is
    // too long is replayed as null.
    std::string expected = direct.text;
    const auto replace = [&](const std::string& from, const std::string& to) {
        ASSERT_NE(expected.find(from), expected.npos) << from;
        expected.replace(expected.find(from), from.size(), to);
    };
    replace(" 123456", " 4294967295");
    const size_t list = expected.find("(1000 ");
    ASSERT_NE(list, expected.npos);
    expected.replace(list, expected.find(')', list) - list, "(1000 null");
    EXPECT_EQ(later.text, expected);
}

TEST(Recording, ATextIsCutBehindWhatItMayBe) {
    Recorder recorder({}, [] { std::abort(); });
    const std::string text(1'000'000, 'x');
    recorder.builder()->error(recorder.builder(), text.c_str());
    EXPECT_LT(recorder.calls().size(), 5000u);
}

TEST(Recording, ACallBeyondTheLastIsNotRecorded) {
    static size_t refused;
    refused = 0;
    Recorder recorder({}, [] {
        ++refused;
        throw 1;
    });
    for (size_t i = 0; i < max_build_calls; ++i)
        recorder.builder()->input(recorder.builder(), 0);
    EXPECT_EQ(refused, 0u);
    EXPECT_ANY_THROW(recorder.builder()->input(recorder.builder(), 0));
    Host host;
    EXPECT_TRUE(replay(recorder.calls(), &host.face));
    const std::string one = recorder.calls().substr(0, recorder.calls().size() / max_build_calls);
    const std::string more = recorder.calls() + one;
    EXPECT_FALSE(replay(more, &host.face));
}

// Under a sanitizer, access beyond an array is an error.
TEST(Recording, DamagedOneCallsNoMoreThanItHolds) {
    const std::string whole = recorded();
    for (size_t size = 0; size < whole.size(); ++size) {
        Host host;
        replay(whole.substr(0, size), &host.face);
    }
    std::mt19937 random(1);
    size_t refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string damaged = whole;
        for (unsigned n = 0; n <= random() % 4; ++n) {
            const size_t at = random() % (damaged.size() / 4) * 4;
            const uint32_t values[] = {0, 1, 2, 64, 65, 66, 1000, 0x7FFFFFFF, 0xFFFFFFFF};
            std::memcpy(&damaged[at], &values[random() % 9], 4);
        }
        Host host;
        refused += !replay(damaged, &host.face);
    }
    EXPECT_GT(refused, 1000u);
}

}  // namespace
}  // namespace wrinkle
