#include "sdk/recorder.h"

#include <sstream>

namespace wrinkle::testing {
namespace {

std::string op_name(uint32_t op) {
    switch (op) {
#define X(name, number, arity, rule, glsl, precedence, flags) \
    case number:                                              \
        return #name;
        WR_OPS(X)
#undef X
    }
    return "unknown op";
}

std::string surface_name(uint32_t input) {
    switch (input) {
#define X(name, number, type, doc) \
    case number:                   \
        return #name;
        WR_SURFACE_INPUTS(X)
#undef X
    }
    return "unknown";
}

std::string number(double x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

}  // namespace

wr_value Recorder::value(std::string text) {
    values_.push_back(std::move(text));
    return static_cast<wr_value>(values_.size() - 1);
}

std::string Recorder::list(const wr_value* values, uint32_t count) const {
    std::string text;
    for (uint32_t i = 0; i < count; ++i)
        text += (i > 0 ? ", " : "") + values_.at(values[i]);
    return text;
}

Recorder::Recorder() {
    face.size = sizeof face;
    face.host = this;
    give_ports();
    give_ops();
    give_regions();
    face.error = [](const wr_builder* b, const char* text) { self(b).errors.push_back(text); };
    face.get_extension = [](const wr_builder*, const char*) -> const void* { return nullptr; };
    face.name = [](const wr_builder*, wr_value, const char*) {};
}

void Recorder::give_ports() {
    face.input = [](const wr_builder* b, uint32_t port) {
        return self(b).value("input:" + std::to_string(port));
    };
    face.image = [](const wr_builder*, uint32_t port) -> wr_image { return 100 + port; };
    face.option = [](const wr_builder* b, uint32_t port) { return self(b).options.at(port); };
    face.field = [](const wr_builder* b, uint32_t port, wr_value at) {
        return self(b).value("field:" + std::to_string(port) + "(" + self(b).list(&at, 1) + ")");
    };
    face.output = [](const wr_builder* b, uint32_t port, wr_value value) {
        self(b).outputs[port] = self(b).values_.at(value);
    };
}

void Recorder::give_ops() {
    face.literal = [](const wr_builder* b, uint32_t, const double* lanes) {
        return self(b).value(number(*lanes));
    };
    face.surface = [](const wr_builder* b, uint32_t i) { return self(b).value(surface_name(i)); };
    face.emit = [](const wr_builder* b, uint32_t op, uint32_t, const wr_value* args, uint32_t count,
                   uint32_t extra) {
        const std::string detail = extra ? "[" + std::to_string(extra) + "]" : "";
        return self(b).value(op_name(op) + detail + "(" + self(b).list(args, count) + ")");
    };
    face.sample = [](const wr_builder* b, uint32_t op, wr_image image, const wr_value* args,
                     uint32_t count) {
        return self(b).value(op_name(op) + ":" + std::to_string(image) + "(" +
                             self(b).list(args, count) + ")");
    };
}

void Recorder::give_regions() {
    face.begin_region = [](const wr_builder* b, uint32_t kind, const char* name, const uint32_t*,
                           uint32_t count, wr_value* params) {
        ++self(b).open_regions;
        self(b).recording_.push_back({name, kind});
        for (uint32_t i = 0; i < count; ++i)
            params[i] = self(b).value("p" + std::to_string(i));
    };
    face.end_region = [](const wr_builder* b, const wr_value* results, uint32_t count,
                         uint32_t max) -> wr_region {
        Recorder& r = self(b);
        --r.open_regions;
        Region region = r.recording_.back();
        r.recording_.pop_back();
        region.text += "{" + r.list(results, count) + "}";
        if (region.kind == WR_REGION_LOOP) region.text += "*" + std::to_string(max);
        r.regions_.push_back(region);
        return static_cast<wr_region>(r.regions_.size() - 1);
    };
    face.apply = [](const wr_builder* b, wr_region region, const wr_value* args, uint32_t count,
                    wr_value* results, uint32_t result_count) {
        Recorder& r = self(b);
        const std::string text = r.regions_.at(region).text + "(" + r.list(args, count) + ")";
        for (uint32_t i = 0; i < result_count; ++i)
            results[i] = r.value(text + "." + std::to_string(i));
    };
}

}  // namespace wrinkle::testing
