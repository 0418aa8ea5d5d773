#include "bake/maps.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "bake/map_values.h"
#include "base/mapped.h"
#include "base/standard_outputs.h"
#include "base/text.h"
#include "cpu/kernels.h"
#include "image/writer.h"
#include "ir/covariance.h"
#include "ir/rewrite.h"
#include "ir/tangent_space.h"

namespace wrinkle {
namespace {

constexpr std::array<const char*, 4> color_channels = {"R", "G", "B", "A"};
constexpr const char* slopes_name = "slopes";

const ModuleOutput* output_named(const Module& module, std::string_view name) {
    const auto found = std::ranges::find(module.outputs, name, &ModuleOutput::name);
    return found == module.outputs.end() ? nullptr : &*found;
}

class MapPlanner {
public:
    MapPlanner(const Module& module, const MapOptions& options, Diagnostics& diagnostics)
        : source_(module), module_(module), options_(options), diagnostics_(diagnostics) {
        module_.outputs.clear();
    }

    std::optional<BakePlan> plan(const std::vector<MapRequest>& requests) {
        for (const MapRequest& request : requests)
            add(request);
        warn_of_view();
        std::string why;
        const Module runs = drop_covariances(std::move(module_));
        plan_.program = compile_program(runs, why);
        if (!why.empty()) diagnostics_.error(RuleId::over_limit, why);
        if (diagnostics_.has_errors()) return {};
        plan_.resources = runs.resources;
        return std::move(plan_);
    }

private:
    void add(const MapRequest& request) {
        BakedMap map =
            request.pack.empty() ? map_of(request.name, request.integers) : packed(request);
        if (request.integers && map.channels.size() == 2)
            map.channels.push_back({"B", map.channels[0].lane, 0, 0, false, 0});
        plan_.maps.push_back(std::move(map));
    }

    // Warns of maps that depend on the view: a texel has one direction only.
    void warn_of_view() {
        std::string names;
        for (const BakedMap& map : plan_.maps)
            if (reads_view(map)) names += (names.empty() ? "'" : ", '") + map.name + "'";
        if (names.empty()) return;
        diagnostics_.add(file_problem(Severity::warning, RuleId::map_view, "",
                                      "view-dependent maps: " + names,
                                      "each texel is baked as seen along its normal"));
    }

    bool reads_view(const BakedMap& map) const {
        std::vector<Id> values;
        for (const auto& [id, first] : lanes_) {
            const uint32_t end = first + info(module_.type(id)).lanes;
            if (std::ranges::any_of(map.channels, [first = first, end](const MapChannel& channel) {
                    return channel.lane >= first && channel.lane < end;
                }))
                values.push_back(id);
        }
        const std::vector<bool> needed = reachable(module_, values);
        for (Id id = 0; id < module_.size(); ++id)
            if (needed[id] && module_[id].op == Op::input_ &&
                input_of(module_[id].extra) == SurfaceInput::view_)
                return true;
        return false;
    }

    // Adds the value to the program's outputs if it is new; returns its first lane.
    uint32_t lane_of(Value value) {
        const auto known = lanes_.find(value.id);
        if (known != lanes_.end()) return known->second;
        const auto first = static_cast<uint32_t>(plan_.lanes);
        module_.outputs.push_back({std::to_string(first), WR_PORT_float, value.id});
        plan_.lanes += info(module_.type(value.id)).lanes;
        lanes_.emplace(value.id, first);
        return first;
    }

    BakedMap map_of(const std::string& name, bool integers) {
        const bool made = name == "derivative" || name == slopes_name;
        const ModuleOutput* output = output_named(source_, made ? "normal" : output_name(name));
        BakedMap map{name, {}, false};
        if (!output)
            print_error(name);
        else if (name == "derivative")
            add_derivative(map, {&module_, output->value}, integers);
        else if (name == slopes_name)
            add_slopes(map, {&module_, output->value}, integers);
        else if (output->port_type == WR_PORT_normal)
            add_normal(map, {&module_, output->value});
        else
            add_values(map, *output, integers);
        return map;
    }

    void print_error(const std::string& name) {
        const std::vector<std::string> names =
            map_names(mapped<std::string>(source_.outputs, &ModuleOutput::name));
        diagnostics_.error(RuleId::unknown_map, "the graph makes no map '" + name + "'",
                           did_you_mean(name, names, "it makes " + joined(names, ", ")));
    }

    void add_normal(BakedMap& map, Value normal) {
        const bool tangent = options_.tangent_space;
        if (tangent) normal = in_tangent_space(module_, normal, options_.vertex_tangents);
        const uint32_t lane = lane_of(normal);
        if (std::ranges::find(plan_.unit, lane) == plan_.unit.end()) plan_.unit.push_back(lane);
        for (uint32_t i = 0; i < 3; ++i) {
            const float sign = i == 1 && options_.green_down ? -1.0F : 1.0F;
            const float empty = tangent && i == 2 ? 1.0F : 0.5F;
            map.channels.push_back({color_channels[i], lane + i, 0.5F * sign, 0.5F, false, empty});
        }
    }

    void add_derivative(BakedMap& map, Value normal, bool integers) {
        const uint32_t lane = lane_of(slope_of_normal(module_, normal));
        const double code = integers ? 0.5 : 1;
        const float offset = integers ? 0.5F : 0.0F;
        const std::array<double, 2> texels = {static_cast<double>(options_.width),
                                              static_cast<double>(options_.height)};
        for (uint32_t i = 0; i < 2; ++i) {
            const auto gain = static_cast<float>(texels[i] * code / options_.scale);
            map.channels.push_back({color_channels[i], lane + i, gain, offset, false, offset});
        }
    }

    void add_slopes(BakedMap& map, Value normal, bool integers) {
        const Value slope = slope_of_normal(module_, normal);
        const Value s = slope.x(), t = -slope.y();
        const ModuleOutput* height = output_named(source_, "height");
        std::array<Value, 6> values = {
            height ? Value{&module_, height->value} : number(s, -1), s, t, s * s, t * t, s * t};
        if (const Value lost = covariance_of(slope)) {
            values[3] = values[3] + lost.x();
            values[4] = values[4] + lost.y();
            values[5] = values[5] - lost.z();  // t is -v
        }
        if (integers)
            diagnostics_.error(RuleId::option,
                               "the map 'slopes' holds numbers that integers do not",
                               "--type half or float, in OpenEXR or TIFF");
        for (uint32_t i = 0; i < 6; ++i) {
            double gain = i >= 3 ? 1 / (options_.scale * options_.scale) : 1 / options_.scale;
            if (i == 0 && !height) gain = 1;
            const float empty = i == 0 && !height ? -1.0F : 0.0F;
            map.channels.push_back({bumpslopes_channels[i], lane_of(values[i]),
                                    static_cast<float>(gain), 0, false, empty});
        }
    }

    void add_values(BakedMap& map, const ModuleOutput& output, bool integers) {
        const uint32_t lane = lane_of({&module_, output.value});
        const uint32_t count = info(module_.type(output.value)).lanes;
        const bool is_length =
            output.port_type == WR_PORT_height || output.port_type == WR_PORT_derivative;
        const float gain = is_length ? static_cast<float>(1 / options_.scale) : 1.0F;
        const bool srgb = output.port_type == WR_PORT_color && integers;
        for (uint32_t i = 0; i < count; ++i)
            map.channels.push_back(
                {count == 1 ? "Y" : color_channels[i], lane + i, gain, 0, srgb && i < 3, 0});
        map.has_alpha = count == 4;
    }

    BakedMap packed(const MapRequest& request) {
        BakedMap map{request.name, {}, false};
        for (const PackedChannel& from : request.pack) {
            const size_t to = std::string_view("rgba").find(from.to);
            if (map.channels.size() <= to) map.channels.resize(to + 1, {"", 0, 0, 0, false, 0});
            const BakedMap source = map_of(from.map, request.integers);
            if (from.channel >= source.channels.size()) {
                if (!source.channels.empty())
                    diagnostics_.error(RuleId::unknown_map,
                                       "the map '" + from.map + "' has " +
                                           std::to_string(source.channels.size()) + " channels",
                                       "one of them, such as " + from.map + ".r");
                continue;
            }
            map.channels[to] = source.channels[from.channel];
            map.channels[to].srgb = false;
        }
        for (size_t i = 0; i < map.channels.size(); ++i)
            map.channels[i].name = color_channels[i];
        map.has_alpha = map.channels.size() == 4;
        return map;
    }

    const Module& source_;
    Module module_;
    const MapOptions& options_;
    Diagnostics& diagnostics_;
    BakePlan plan_;
    std::map<Id, uint32_t> lanes_;
};

}  // namespace

std::vector<std::string> map_names(std::vector<std::string> outputs) {
    const auto has = [&](const char* name) {
        return std::ranges::find(outputs, name) != outputs.end();
    };
    if (has("normal"))
        for (const char* made : {"derivative", slopes_name})
            if (!has(made)) outputs.emplace_back(made);
    return outputs;
}

bool fits_integers(std::string_view map) {
    // Integers end at 1, which usual values of some outputs exceed.
    const StandardOutput* output = find_standard_output(map);
    return map != slopes_name && (!output || output->slider_high <= 1);
}

Covariances covariances_for(const std::vector<MapRequest>& requests) {
    const auto is_moments = [](const MapRequest& request) {
        return request.pack.empty() ? request.name == slopes_name
                                    : std::ranges::find(request.pack, slopes_name,
                                                        &PackedChannel::map) != request.pack.end();
    };
    const bool any = std::ranges::any_of(requests, is_moments);
    return any ? Covariances::kept : Covariances::dropped;
}

std::optional<BakePlan> plan_maps(const Module& module, const std::vector<MapRequest>& requests,
                                  const MapOptions& options, Diagnostics& diagnostics) {
    return MapPlanner(module, options, diagnostics).plan(requests);
}

void store_map(const BakedMap& map, const float* lanes, const uint8_t* covered, size_t count,
               float* stored) {
    const Kernels& kernels = kernels_of(default_instruction_set());
    const size_t channels = map.channels.size();
    std::vector<float> values(count);
    for (size_t c = 0; c < channels; ++c) {
        const MapChannel channel = map.channels[c];
        const float* lane = lanes + channel.lane * count;
        for (size_t i = 0; i < count; ++i)
            values[i] = lane[i] * channel.gain + channel.offset;
        if (channel.srgb) kernels.encode_srgb(values.data(), count);
        for (size_t i = 0; i < count; ++i)
            stored[i * channels + c] = covered[i] ? values[i] : channel.empty;
    }
}

}  // namespace wrinkle
