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
    call_channel,
    call_with_channel,
    call_mix_materials,
};

constexpr uint32_t no_text = ~0u;        // instead of a size
constexpr uint32_t no_such_value = ~0u;  // invalid for the host
constexpr size_t max_text = 4096;        // bytes, as in wrinkle/plugin.h
constexpr uint32_t max_lanes = 9;

// A recorded call: this, then the list and the text.
struct Head {
    uint32_t function;
    uint32_t words[3];   // arguments in their order
    uint32_t count;      // as it was passed
    uint32_t has_list;   // 0 if the pointer was null or the count too large
    uint32_t text_size;  // bytes, or no_text
};

constexpr uint32_t lanes_of_type(uint32_t type) {
    constexpr uint32_t lanes[] = {
#define X(name, number, glsl, count) count,
        WR_TYPES(X)
#undef X
    };
    return type < std::size(lanes) ? lanes[type] : 0;
}

struct Arguments {
    std::array<uint32_t, 3> words{};
    const uint32_t* list = nullptr;
    uint32_t count = 0;
    const char* text = nullptr;
};

Recorder& record(const wr_builder* b, Call function, const Arguments& arguments) {
    const auto& [words, list, count, text] = arguments;
    const bool has_list = list && count <= max_build_values;
    // One byte more than the host accepts, so that the host reports a longer text.
    const size_t text_size = text ? strnlen(text, max_text + 1) : 0;
    const Head head{function,
                    {words[0], words[1], words[2]},
                    count,
                    has_list,
                    text ? static_cast<uint32_t>(text_size) : no_text};
    std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
    if (has_list) bytes.append(reinterpret_cast<const char*>(list), count * sizeof *list);
    if (text) bytes.append(text, text_size);
    auto& recorder = *static_cast<Recorder*>(b->host);
    recorder.add(bytes);
    return recorder;
}

// Assigns numbers to the first `room` values, poison to the rest.
void give_numbers(Recorder& recorder, uint32_t* values, uint32_t count, uint32_t room) {
    for (uint32_t i = 0; values && i < count; ++i)
        values[i] = i < room ? recorder.next() : WR_POISON;
}

uint32_t record_literal(const wr_builder* b, uint32_t type, const double* lanes) {
    const uint32_t count = lanes ? lanes_of_type(type) : 0;
    std::array<uint32_t, 2 * max_lanes> words{};
    if (count > 0) std::memcpy(words.data(), lanes, count * sizeof *lanes);
    return record(b, call_literal, {{type}, words.data(), 2 * count}).next();
}

void record_begin_region(const wr_builder* b, uint32_t kind, const char* name,
                         const uint32_t* types, uint32_t count, wr_value* params) {
    const bool possible = types && params && count <= max_build_values;
    Recorder& recorder =
        record(b, call_begin_region, {{kind}, possible ? types : nullptr, count, name});
    give_numbers(recorder, params, count, possible ? count : 0);
}

void record_apply(const wr_builder* b, wr_region region, const wr_value* args, uint32_t count,
                  wr_value* results, uint32_t result_count) {
    const uint32_t room = results ? std::min(result_count, max_build_values) : 0;
    Recorder& recorder = record(b, call_apply, {{region, room, results ? 1u : 0u}, args, count});
    give_numbers(recorder, results, result_count, room);
}

void record_materials(wr_builder& face) {
    using B = const wr_builder*;
    face.channel = [](B b, wr_value material, const char* name, uint32_t type) {
        return record(b, call_channel, {.words = {material, type}, .text = name}).next();
    };
    face.with_channel = [](B b, wr_value material, const char* name, uint32_t type,
                           wr_value value) {
        return record(b, call_with_channel, {.words = {material, type, value}, .text = name})
            .next();
    };
    face.mix_materials = [](B b, wr_value one, wr_value other, wr_value t) {
        return record(b, call_mix_materials, {{one, other, t}}).next();
    };
}

wr_builder calls_of_recorder() {
    using B = const wr_builder*;
    wr_builder face{};
    face.size = sizeof face;
    face.input = [](B b, uint32_t port) { return record(b, call_input, {{port}}).next(); };
    face.image = [](B b, uint32_t port) { return record(b, call_image, {{port}}).next(); };
    face.option = [](B b, uint32_t port) { return record(b, call_option, {{port}}).option(port); };
    face.field = [](B b, uint32_t port, wr_value at) {
        return record(b, call_field, {{port, at}}).next();
    };
    face.literal = record_literal;
    face.surface = [](B b, uint32_t input) { return record(b, call_surface, {{input}}).next(); };
    face.emit = [](B b, uint32_t op, uint32_t type, const wr_value* args, uint32_t count,
                   uint32_t extra) {
        return record(b, call_emit, {{op, type, extra}, args, count}).next();
    };
    face.sample = [](B b, uint32_t op, wr_image image, const wr_value* args, uint32_t count) {
        return record(b, call_sample, {{op, image}, args, count}).next();
    };
    face.begin_region = record_begin_region;
    face.end_region = [](B b, const wr_value* results, uint32_t count, uint32_t max) {
        return record(b, call_end_region, {{max}, results, count}).next();
    };
    face.apply = record_apply;
    face.output = [](B b, uint32_t port, wr_value value) {
        record(b, call_output, {{port, value}});
    };
    face.error = [](B b, const char* text) { record(b, call_error, {.text = text}); };
    face.name = [](B b, wr_value value, const char* name) {
        record(b, call_name, {.words = {value}, .text = name});
    };
    face.get_extension = [](B, const char*) -> const void* { return nullptr; };
    record_materials(face);
    return face;
}

class Replay {
public:
    Replay(std::string_view calls, const wr_builder* host) : calls_(calls), b_(host) {}

    bool run() {
        for (size_t i = 0; i < max_build_calls && !calls_.empty(); ++i)
            if (!read() || !call()) return false;
        return calls_.empty();
    }

private:
    bool take(void* to, size_t size) {
        if (calls_.size() < size) return false;
        std::memcpy(to, calls_.data(), size);
        calls_.remove_prefix(size);
        return true;
    }

    // Reads the next call; returns false if it is damaged.
    bool read() {
        if (!take(&head_, sizeof head_)) return false;
        if (head_.has_list &&
            (head_.count > max_build_values || !take(list_.data(), head_.count * sizeof list_[0])))
            return false;
        if (head_.text_size == no_text) return true;
        if (head_.text_size > calls_.size()) return false;
        text_.resize(head_.text_size);
        return take(text_.data(), text_.size());
    }

    const uint32_t* list() const { return head_.has_list ? list_.data() : nullptr; }
    const char* text() const { return head_.text_size == no_text ? nullptr : text_.c_str(); }

    // Returns the list as values of the host.
    const wr_value* values() {
        for (uint32_t i = 0; head_.has_list && i < head_.count; ++i)
            list_[i] = of_host(list_[i]);
        return list();
    }
    uint32_t of_host(uint32_t number) const {
        if (number == WR_POISON) return WR_POISON;
        return number <= of_host_.size() ? of_host_[number - 1] : no_such_value;
    }

    bool gives(uint32_t number) {
        of_host_.push_back(number);
        return true;
    }
    bool gives(const wr_value* list, uint32_t count) {
        of_host_.insert(of_host_.end(), list, list + count);
        return true;
    }

    // Makes the call; returns false if its arguments are impossible.
    bool call() {
        const auto& [x, y, z] = head_.words;
        switch (head_.function) {
            case call_input:
                return gives(b_->input(b_, x));
            case call_image:
                return gives(b_->image(b_, x));
            case call_option:
                return b_->option(b_, x), true;
            case call_surface:
                return gives(b_->surface(b_, x));
            case call_field:
                return gives(b_->field(b_, x, of_host(y)));
            case call_literal:
                return literal(x);
            case call_emit:
                return gives(b_->emit(b_, x, y, values(), head_.count, base_of(x, z)));
            case call_sample:
                return gives(b_->sample(b_, x, of_host(y), values(), head_.count));
            case call_begin_region:
                return begin_region(x);
            case call_end_region:
                return gives(b_->end_region(b_, values(), head_.count, x));
            case call_apply:
                return apply(of_host(x), y, z != 0);
            case call_output:
                return b_->output(b_, x, of_host(y)), true;
            case call_error:
                return b_->error(b_, text()), true;
            case call_name:
                return b_->name(b_, of_host(x), text()), true;
            case call_channel:
                return gives(b_->channel(b_, of_host(x), text(), y));
            case call_with_channel:
                return gives(b_->with_channel(b_, of_host(x), text(), y, of_host(z)));
            case call_mix_materials:
                return gives(b_->mix_materials(b_, of_host(x), of_host(y), of_host(z)));
            default:
                return false;
        }
    }

    bool literal(uint32_t type) {
        const uint32_t count = head_.count;
        if (count == 0) return gives(b_->literal(b_, type, nullptr));
        if (!head_.has_list || count != 2 * lanes_of_type(type)) return false;
        std::array<double, max_lanes> lanes{};
        std::memcpy(lanes.data(), list_.data(), count * sizeof list_[0]);
        return gives(b_->literal(b_, type, lanes.data()));
    }
    bool begin_region(uint32_t kind) {
        std::array<wr_value, max_build_values> params{};
        b_->begin_region(b_, kind, text(), list(), head_.count, list() ? params.data() : nullptr);
        return gives(params.data(), list() ? head_.count : 0);
    }
    bool apply(uint32_t region, uint32_t room, bool has_results) {
        if (room > max_build_values) return false;
        std::array<wr_value, max_build_values> results{};
        b_->apply(b_, region, values(), head_.count, has_results ? results.data() : nullptr, room);
        return gives(results.data(), room);
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
    std::vector<uint32_t> of_host_;  // indexed by the recorder's number - 1
    Head head_{};
    std::array<uint32_t, max_build_values> list_{};
    std::string text_;
};

}  // namespace

Recorder::Recorder(std::span<const int32_t> options, void (*on_full)())
    : face_(calls_of_recorder()), options_(options), on_full_(on_full) {
    face_.host = this;
}

void Recorder::add(std::string_view call) {
    if (++count_ > max_build_calls) on_full_();
    calls_ += call;
}

bool replay(std::string_view calls, const wr_builder* host) {
    return Replay(calls, host).run();
}

}  // namespace wrinkle
