// Images and fields: what a body may read at places of its own choice.
//
// Image  an image of the graph, decoded by its encoding: colors are linear, normals and
//        derivatives in [-1, 1] with green up. `sample` filters by the changes of uv between
//        pixels; in a region the host takes those from outside.
// Field  the expression at a port, read where its domain (uv or position) has another value.
#pragma once

#include "wrinkle/math.h"

namespace wrinkle::sdk {

class Image {
public:
    explicit Image(wr_image image) : image_(image) {}
    vec4 sample(vec2 uv) const { return vec4(read(WR_OP_sample, {uv.id})); }
    vec4 sample_lod(vec2 uv, Float lod) const {
        return vec4(read(WR_OP_sample_lod, {uv.id, lod.id}));
    }
    vec4 sample_grad(vec2 uv, vec2 uv_dx, vec2 uv_dy) const {
        return vec4(read(WR_OP_sample_grad, {uv.id, uv_dx.id, uv_dy.id}));
    }
    vec2 size() const { return vec2(read(WR_OP_image_size, {})); }  // in texels

private:
    Raw read(uint32_t op, std::initializer_list<wr_value> args) const {
        if (!builder) return {};
        return {
            builder->sample(builder, op, image_, args.begin(), static_cast<uint32_t>(args.size()))};
    }
    wr_image image_;
};

template <class T, class Domain = vec2>
class Field {
public:
    explicit Field(uint32_t port) : port_(port) {}
    T operator()(Domain at) const {
        return T(builder ? Raw{builder->field(builder, port_, at.id)} : Raw{});
    }

private:
    uint32_t port_;
};

}  // namespace wrinkle::sdk
