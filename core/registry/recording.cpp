#include "registry/recording.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace wrinkle {
namespace {

// Recorded functions of wr_builder.
enum Call : uint32_t {
    call_input,
    call_image,
    call_option,
    call_field,
    call_literal,
    call_surface,
    call_emit,
    call_sample,
    call_begin_region,
    call_end_region,
    call_apply,
    call_output,
    call_error,
    call_name,
};

constexpr uint32_t no_text = ~0u;        // instead of a size
constexpr uint32_t no_such_value = ~0u;  // invalid for the host
constexpr size_t max_text = 4096;        // bytes, as in wrinkle/plugin.h

constexpr uint32_t lanes_of_type(uint32_t type) {
    constexpr std::array<uint32_t, 14> lanes{
#define X(name, number, glsl, count) count,
        WR_TYPES(X)
#undef X
    };
    return type < lanes.size() ? lanes[type] : 0;
}

Recorder& self(const wr_builder* b) {
    return *static_cast<Recorder*>(b->host);
}

template <class... Words>
Recorder& record(const wr_builder* b, uint32_t call, Words... words) {
    Recorder& recorder = self(b);
    recorder.begin(call);
    (recorder.word(words), ...);
    return recorder;
}

// Assigns numbers to the first `room` values, poison to the rest.
void give_numbers(Recorder& recorder, uint32_t* values, uint32_t count, uint32_t room) {
    for (uint32_t i = 0; values && i < count; ++i)
        values[i] = i < room ? recorder.next() : WR_POISON;
}

uint32_t record_literal(const wr_builder* b, uint32_t type, const double* lanes) {
    const uint32_t count = lanes ? lanes_of_type(type) : 0;
    Recorder& recorder = record(b, call_literal, type, count);
    for (uint32_t i = 0; i < count; ++i)
        recorder.number(lanes[i]);
    return recorder.next();
}

void record_begin_region(const wr_builder* b, uint32_t kind, const char* name,
                         const uint32_t* types, uint32_t count, wr_value* params) {
    const bool possible = types && params && count <= max_build_values;
    Recorder& recorder = record(b, call_begin_region, kind);
    recorder.text(name);
    recorder.words(possible ? types : nullptr, count);
    give_numbers(recorder, params, count, possible ? count : 0);
}

void record_apply(const wr_builder* b, wr_region region, const wr_value* args, uint32_t count,
                  wr_value* results, uint32_t result_count) {
    const uint32_t room = results ? std::min(result_count, max_build_values) : 0;
    Recorder& recorder = record(b, call_apply, region, room, results ? 1u : 0u);
    recorder.words(args, count);
    give_numbers(recorder, results, result_count, room);
}

wr_builder calls_of_recorder() {
    using B = const wr_builder*;
    wr_builder face{};
    face.size = sizeof face;
    face.input = [](B b, uint32_t port) { return record(b, call_input, port).next(); };
    face.image = [](B b, uint32_t port) { return record(b, call_image, port).next(); };
    face.option = [](B b, uint32_t port) { return record(b, call_option, port).option(port); };
    face.field = [](B b, uint32_t port, wr_value at) {
        return record(b, call_field, port, at).next();
    };
    face.literal = record_literal;
    face.surface = [](B b, uint32_t input) { return record(b, call_surface, input).next(); };
    face.emit = [](B b, uint32_t op, uint32_t type, const wr_value* args, uint32_t count,
                   uint32_t extra) {
        Recorder& recorder = record(b, call_emit, op, type, extra);
        recorder.words(args, count);
        return recorder.next();
    };
    face.sample = [](B b, uint32_t op, wr_image image, const wr_value* args, uint32_t count) {
        Recorder& recorder = record(b, call_sample, op, image);
        recorder.words(args, count);
        return recorder.next();
    };
    face.begin_region = record_begin_region;
    face.end_region = [](B b, const wr_value* results, uint32_t count, uint32_t max) {
        Recorder& recorder = record(b, call_end_region, max);
        recorder.words(results, count);
        return recorder.next();
    };
    face.apply = record_apply;
    face.output = [](B b, uint32_t port, wr_value value) { record(b, call_output, port, value); };
    face.error = [](B b, const char* text) { record(b, call_error).text(text); };
    face.name = [](B b, wr_value value, const char* name) {
        record(b, call_name, value).text(name);
    };
    face.get_extension = [](B, const char*) -> const void* { return nullptr; };
    return face;
}

class Replay {
public:
    Replay(std::string_view calls, const wr_builder* host) : calls_(calls), b_(host) {}

    bool run() {
        size_t count = 0;
        while (fine_ && !calls_.empty() && count++ < max_build_calls)
            call(word());
        return fine_ && calls_.empty();
    }

private:
    uint32_t word() {
        uint32_t value = 0;
        if (calls_.size() < sizeof value) return fine_ = false, 0;
        std::memcpy(&value, calls_.data(), sizeof value);
        calls_.remove_prefix(sizeof value);
        return value;
    }

    // As many as were passed; `list` is null if the pointer was null or there were too many.
    struct Array {
        uint32_t count = 0;
        const uint32_t* list = nullptr;  // in words_
    };
    Array words() {
        Array array{word()};
        const bool given = word() != 0;
        if (!given) return array;
        if (array.count > max_build_values) return fine_ = false, array;
        for (uint32_t i = 0; i < array.count; ++i)
            words_[i] = word();
        array.list = words_.data();
        return array;
    }

    // Reads values and maps them to those of the host.
    Array values() {
        const Array array = words();
        for (uint32_t i = 0; array.list && i < array.count; ++i)
            words_[i] = of_host(words_[i]);
        return array;
    }
    uint32_t value() { return of_host(word()); }
    uint32_t of_host(uint32_t number) const {
        if (number == WR_POISON) return WR_POISON;
        return number <= of_host_.size() ? of_host_[number - 1] : no_such_value;
    }

    const char* text() {
        const uint32_t size = word();
        if (size == no_text) return nullptr;
        if (size > calls_.size()) return fine_ = false, nullptr;
        text_ = calls_.substr(0, size);
        calls_.remove_prefix(size);
        return text_.c_str();
    }

    void gives(uint32_t number) { of_host_.push_back(number); }

    void call(uint32_t which) {
        switch (which) {
            case call_input:
                return one([&](uint32_t p) { gives(b_->input(b_, p)); });
            case call_image:
                return one([&](uint32_t p) { gives(b_->image(b_, p)); });
            case call_option:
                return one([&](uint32_t p) { b_->option(b_, p); });
            case call_surface:
                return one([&](uint32_t p) { gives(b_->surface(b_, p)); });
            case call_field:
                return field();
            case call_literal:
                return literal();
            case call_emit:
                return emit();
            case call_sample:
                return sample();
            case call_begin_region:
                return begin_region();
            case call_end_region:
                return end_region();
            case call_apply:
                return apply();
            case call_output:
                return output();
            case call_error:
                return error();
            case call_name:
                return name();
            default:
                fine_ = false;
        }
    }

    template <class F>
    void one(F make) {
        const uint32_t argument = word();
        if (fine_) make(argument);
    }
    void field() {
        const uint32_t port = word(), at = value();
        if (fine_) gives(b_->field(b_, port, at));
    }
    void literal() {
        const uint32_t type = word(), count = word();
        std::array<double, 9> lanes{};
        if (count > lanes.size() || (count > 0 && count != lanes_of_type(type))) fine_ = false;
        for (uint32_t i = 0; fine_ && i < count; ++i) {
            const uint32_t halves[2] = {word(), word()};
            std::memcpy(&lanes[i], halves, sizeof halves);
        }
        if (fine_) gives(b_->literal(b_, type, count > 0 ? lanes.data() : nullptr));
    }
    void emit() {
        const uint32_t op = word(), type = word(), extra = base_of(op, word());
        const Array args = values();
        if (fine_) gives(b_->emit(b_, op, type, args.list, args.count, extra));
    }
    void sample() {
        const uint32_t op = word(), image = value();
        const Array args = values();
        if (fine_) gives(b_->sample(b_, op, image, args.list, args.count));
    }
    void begin_region() {
        const uint32_t kind = word();
        const char* name = text();
        const Array types = words();
        if (!fine_) return;
        std::array<wr_value, max_build_values> params{};
        b_->begin_region(b_, kind, name, types.list, types.count,
                         types.list ? params.data() : nullptr);
        for (uint32_t i = 0; types.list && i < types.count; ++i)
            gives(params[i]);
    }
    void end_region() {
        const uint32_t max = word();
        const Array results = values();
        if (fine_) gives(b_->end_region(b_, results.list, results.count, max));
    }
    void apply() {
        const uint32_t region = value(), room = word(), has_results = word();
        const Array args = values();
        if (room > max_build_values) fine_ = false;
        if (!fine_) return;
        std::array<wr_value, max_build_values> results{};
        b_->apply(b_, region, args.list, args.count, has_results ? results.data() : nullptr, room);
        for (uint32_t i = 0; i < room; ++i)
            gives(results[i]);
    }
    void output() {
        const uint32_t port = word(), given = value();
        if (fine_) b_->output(b_, port, given);
    }
    void error() {
        const char* message = text();
        if (fine_) b_->error(b_, message);
    }
    void name() {
        const uint32_t named = value();
        const char* words = text();
        if (fine_) b_->name(b_, named, words);
    }

    // Maps `extra` if it is a value for this op.
    uint32_t base_of(uint32_t op, uint32_t extra) const {
        const bool source =
            (op >= WR_OP_gradient_from_derivative && op <= WR_OP_gradient_from_normal) ||
            op == WR_OP_gradient_from_outward_normal;
        return source ? of_host(extra) : extra;
    }

    std::string_view calls_;
    const wr_builder* b_;
    bool fine_ = true;
    std::vector<uint32_t> of_host_;  // indexed by the recorder's number - 1
    std::array<uint32_t, max_build_values> words_{};
    std::string text_;
};

}  // namespace

Recorder::Recorder(std::span<const int32_t> options, void (*on_full)())
    : face_(calls_of_recorder()), options_(options), on_full_(on_full) {
    face_.host = this;
}

void Recorder::begin(uint32_t call) {
    if (++count_ > max_build_calls) on_full_();
    word(call);
}

void Recorder::word(uint32_t value) {
    calls_.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void Recorder::words(const uint32_t* values, uint32_t count) {
    const bool given = values && count <= max_build_values;
    word(count);
    word(given ? 1 : 0);
    for (uint32_t i = 0; given && i < count; ++i)
        word(values[i]);
}

void Recorder::number(double value) {
    calls_.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void Recorder::text(const char* source) {
    if (!source) return word(no_text);
    const size_t size = strnlen(source, max_text + 1);
    word(static_cast<uint32_t>(size));
    calls_.append(source, size);
}

bool replay(std::string_view calls, const wr_builder* host) {
    return Replay(calls, host).run();
}

}  // namespace wrinkle
