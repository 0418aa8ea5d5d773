// Implementation of wr_builder, which a node's build() calls, over a module. Data from plugins is
// not trusted: every number is checked before the module receives it.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "base/limits.h"
#include "base/text.h"
#include "ir/surface.h"
#include "lower/call_checks.h"
#include "lower/lowering.h"
#include "lower/sampling.h"
#include "registry/library.h"
#include "registry/port_type.h"

namespace wrinkle {
namespace {

constexpr uint32_t max_region_values = 64;
constexpr uint32_t most_iterations = 65536;

class Builder : CallChecks {
public:
    Builder(Lowering& lowering, uint32_t node)
        : CallChecks(lowering.module(), *lowering.graph().nodes[node].type),
          lowering_(lowering),
          node_(node) {
        static const wr_builder calls = calls_of_host();
        face_ = calls;
        face_.host = this;
    }

    void run() {
        module_.current_node = lowering_.graph().nodes[node_].instance;
        Unbuilt reason;
        const bool built = type_.run(&face_, reason);
        if (over_) throw at_this_node(*over_);
        if (!built) module_.problem(reason.why, reason.remedy);
        if (built && module_.depth() > 0) refuse("leaves a loop or a function open");
        const std::array<Id, 1> nothing{poison};
        while (module_.depth() > 0)
            module_.end_region(nothing);
        for (uint32_t p = 0; built && p < type_.ports.size(); ++p)
            if (type_.ports[p].kind == Port::Kind::output && !lowering_.has_output(node_, p))
                refuse("gives no value to its output '" + type_.ports[p].name + "'");
        // Appended last: if two outputs have one value, the name of the output that is read is
        // used.
        module_.named.insert(module_.named.end(), unread_.begin(), unread_.end());
        module_.current_node = 0;
    }

private:
    static wr_builder calls_of_host() {
        wr_builder face{};
        face.size = sizeof face;
        face.input = call<&Builder::input>;
        face.image = call<&Builder::image>;
        face.option = call<&Builder::option>;
        face.field = call<&Builder::field>;
        face.literal = call<&Builder::literal>;
        face.surface = call<&Builder::surface>;
        face.emit = call<&Builder::emit>;
        face.sample = call<&Builder::sample>;
        face.begin_region = call<&Builder::begin_region>;
        face.end_region = call<&Builder::end_region>;
        face.apply = call<&Builder::apply>;
        face.output = call<&Builder::output>;
        face.error = call<&Builder::error>;
        face.name = call<&Builder::name>;
        face.channel = call<&Builder::channel>;
        face.with_channel = call<&Builder::with_channel>;
        face.mix_materials = call<&Builder::mix_materials>;
        face.get_extension = [](const wr_builder*, const char*) -> const void* { return nullptr; };
        return face;
    }

    // Exceptions do not cross a plugin's code: once there are too many values, calls return empty
    // results, and run() throws.
    template <auto member, class Result, class... Arguments>
    static Result call(const wr_builder* b, Arguments... arguments) {
        Builder& own = *static_cast<Builder*>(b->host);
        try {
            if (!own.over_) return (own.*member)(arguments...);
        } catch (const OverLimit& over) {
            own.over_.emplace(over);
        }
        return Result();
    }

    // Reports the limit at this node, not at the nodes that the values it copies are from.
    OverLimit at_this_node(OverLimit over) const {
        over.node = lowering_.graph().nodes[node_].instance;
        over.path = module_.nodes[over.node].path;
        return over;
    }

    Id input(uint32_t index) {
        const Port* p = port(index, "input()");
        if (!p) return poison;
        if (!p->is_value() || p->type == PortType::image_) return refuse_kind(*p, "a value");
        return lowering_.input(node_, index);
    }
    wr_image image(uint32_t index) {
        const Port* p = port(index, "image()");
        if (!p) return poison;
        if (p->kind != Port::Kind::input || p->type != PortType::image_)
            return refuse_kind(*p, "an image");
        const Id handle = lowering_.image(node_, index);
        if (handle == poison)
            refuse("port '" + p->name + "' has no image", "it needs a path to an image");
        return handle;
    }

    int32_t option(uint32_t index) {
        const Port* p = port(index, "option()");
        if (p && p->is_option()) return lowering_.option(node_, index);
        if (p) refuse_kind(*p, "an option");
        return 0;
    }

    Id field(uint32_t index, wr_value at) {
        const Port* p = port(index, "field()");
        if (!p || !usable(std::array{at})) return poison;
        if (p->kind != Port::Kind::field) return refuse_kind(*p, "a field");
        const auto domain = static_cast<SurfaceInput>(p->default_surface);
        if (module_.type(at) != info(domain).type)
            return refuse("reads the field '" + p->name + "' at a " +
                          std::string(info(module_.type(at)).name) + " in place of a " +
                          std::string(info(info(domain).type).name));
        return lowering_.fields().read(lowering_.input(node_, index), domain, at, p->name);
    }

    Id literal(uint32_t type, const double* lanes) {
        if (!is_number(type) || !lanes) return refuse("requests a literal that is not a number");
        const auto wanted = static_cast<Type>(type);
        const size_t count = info(wanted).lanes;
        for (size_t i = 0; i < count; ++i)
            if (!std::isfinite(lanes[i])) return refuse("asks for a literal that is not finite");
        if (wanted == Type::int_ || wanted == Type::uint_) {
            const double least = wanted == Type::int_ ? -2147483648.0 : 0;
            const double most = wanted == Type::int_ ? 2147483647.0 : 4294967295.0;
            if (lanes[0] < least || lanes[0] > most || lanes[0] != std::floor(lanes[0]))
                return refuse("asks for the integer " + shortest(lanes[0]));
        }
        if (wanted == Type::bool_) return module_.literal(wanted, lanes[0] != 0 ? 1 : 0);
        return module_.constant(wanted, std::span(lanes, count));
    }

    Id surface(uint32_t index) {
        if (index == WR_SURFACE_FRONT_NORMAL) return unit_normal(module_);
        if (index >= static_cast<uint32_t>(surface_input_count))
            return refuse("asks for surface property " + std::to_string(index) +
                          ", which does not exist");
        return lowering_.surface(index);
    }

    Id emit(uint32_t number, uint32_t type, const wr_value* args, uint32_t count, uint32_t extra) {
        const auto o = static_cast<Op>(number);
        const bool fits = exists(number) && !host_only(o) && takes(o, count);
        if (!fits || (count > 0 && !args)) return refuse_op(number, count);
        const std::span<const wr_value> operands(args, count);
        if (!usable(operands)) return poison;
        if ((info(o).flags & WR_FLAG_IMPLICIT) != 0 && module_[operands[0]].level > 0)
            return refuse("takes the derivative " + quoted(o) + " inside a loop or a function");
        const std::optional<uint32_t> checked = checked_extra(o, extra, count);
        if (!checked) return poison;
        return module_.add(o, operands, *checked, static_cast<Type>(type));
    }

    // Returns the `extra` for the module; std::nullopt if it is refused.
    std::optional<uint32_t> checked_extra(Op o, uint32_t extra, uint32_t count) {
        if (o == Op::resolve_) return module_.current_node;
        if (o == Op::swizzle_) return extra;
        if (o != Op::column_ && o != Op::frame_ && !is_gradient_source(o)) return 0;
        if (o == Op::frame_ && ((extra & 0xFF) == WR_FRAME_guess) != (count == 2)) {
            refuse("gives a frame a direction where there is none, or none to 'guess'");
            return {};
        }
        if (!is_possible(o, extra)) {
            refuse("gives the op " + quoted(o) + " an impossible detail");
            return {};
        }
        if (!is_gradient_source(o)) return extra;
        if (extra == 0) return lowering_.own_base(node_);
        const bool surface = module_[extra].arg[0] == lowering_.surface(WR_SURFACE_normal);
        return surface ? 0 : extra;
    }

    // Returns true for a valid column, frame method and scale, or base.
    bool is_possible(Op o, uint32_t extra) const {
        if (o == Op::column_) return extra < 3;
        if (o == Op::frame_) return (extra & 0xFF) <= WR_FRAME_pixel && extra >> 8 <= WR_SCALE_unit;
        return extra == 0 || (extra < module_.size() && module_.type(extra) == Type::base_);
    }

    Id sample(uint32_t number, wr_image image, const wr_value* args, uint32_t count) {
        const auto o = static_cast<Op>(number);
        if (number > 0xFFFF || !reads_image(o))
            return refuse("samples with op " + std::to_string(number) + ", which is none for it");
        if (image == 0) return poison;
        const Lowering::Image* used = lowering_.ready_image(image);
        if (!used) return refuse("samples an image that does not exist");
        if (!takes(o, count) || (count > 0 && !args)) return refuse_count(o, count);
        const std::span<const wr_value> operands(args, count);
        if (!usable(operands)) return poison;
        const uint32_t resource = used->resource;
        if (o == Op::image_size_) return module_.add(o, {}, resource);
        const bool inside = o == Op::sample_ && module_[operands[0]].level > 0;
        const Id texel = inside ? sample_inside(module_, resource, operands[0])
                                : module_.add(o, operands, resource);
        return decode(module_, module_.resources[resource].options, texel);
    }

    void begin_region(uint32_t kind, const char* name, const uint32_t* types, uint32_t count,
                      wr_value* params) {
        std::vector<Type> parameters;
        bool fine = (kind == WR_REGION_FUNCTION || kind == WR_REGION_LOOP) && types && params &&
                    count >= 1 && count <= max_region_values &&
                    module_.depth() < Module::max_region;
        for (uint32_t i = 0; fine && i < count; ++i) {
            fine = is_number(types[i]);
            parameters.push_back(static_cast<Type>(types[i]));
        }
        if (!fine) {
            refuse("begins a loop or a function in an impossible way");
            for (uint32_t i = 0; params && i < count; ++i)
                params[i] = poison;
            parameters.clear();  // still a region, so that begin and end match
        }
        const RegionKind region = kind == WR_REGION_LOOP ? RegionKind::loop : RegionKind::function;
        if (!fine && module_.depth() >= Module::max_region) {
            ++skipped_;
            return;
        }
        const std::vector<Id> ids =
            module_.begin_region(region, is_plain(name) ? name : "", parameters);
        for (size_t i = 0; i < ids.size(); ++i)
            params[i] = ids[i];
    }

    wr_region end_region(const wr_value* results, uint32_t count, uint32_t max_iterations) {
        if (skipped_ > 0) return --skipped_, 0;
        if (module_.depth() == 0) return refuse("ends a loop or a function that it did not begin");
        const bool given_up = !results && count == 0;
        const bool fine = results && count >= 1 && count <= max_region_values + 1 &&
                          max_iterations <= most_iterations;
        if (!fine && !given_up) refuse("ends a loop or a function in an impossible way");
        const std::array<Id, 1> nothing{poison};
        const bool good = fine && usable({results, count});
        RegionUse use = module_.end_region(
            good ? std::span<const Id>(results, count) : std::span<const Id>(nothing),
            max_iterations);
        if (use.region == 0) return 0;
        regions_.push_back(std::move(use));
        return static_cast<wr_region>(regions_.size());
    }

    void apply(wr_region region, const wr_value* args, uint32_t count, wr_value* results,
               uint32_t result_count) {
        // Copied before the results are written: the arrays may overlap.
        const std::vector<wr_value> arguments(args, args + (args ? count : 0));
        for (uint32_t i = 0; results && i < result_count; ++i)
            results[i] = poison;
        if (region == 0) return;
        if (region > regions_.size() || (count > 0 && !args) || !results) {
            refuse("applies a loop or a function that does not exist");
            return;
        }
        if (!usable(arguments)) return;
        const std::vector<Id> ids = module_.apply(regions_[region - 1], arguments);
        for (size_t i = 0; i < ids.size() && i < result_count; ++i)
            results[i] = ids[i];
    }

    void output(uint32_t index, wr_value value) {
        const Port* p = port(index, "output()");
        if (!p) return;
        if (p->kind != Port::Kind::output) {
            refuse("gives a value to port '" + p->name + "', which is not an output");
            return;
        }
        if (lowering_.has_output(node_, index)) refuse("gives its output '" + p->name + "' twice");
        const Id checked = checked_output(*p, value);
        lowering_.set_output(node_, index, checked);
        if (checked == poison || p->type == PortType::image_) return;
        if (info(module_.type(checked)).lanes == 0) return;  // never a statement of generated code
        const FlatGraph& graph = lowering_.graph();
        const bool read = graph.wire(graph.nodes[node_], index).kind == Wire::Kind::output_is_read;
        (read ? module_.named : unread_).push_back({checked, module_.current_node, p->name, true});
    }

    Id checked_output(const Port& p, wr_value value) {
        if (p.type == PortType::image_) {
            if (value == poison || lowering_.ready_image(value)) return value;
            return refuse("gives an image that does not exist to its output '" + p.name + "'");
        }
        if (value == poison || !usable(std::array{value})) return poison;
        const Type wanted = value_type(p.type);
        if (module_.type(value) != wanted)
            return refuse("gives " + std::string(info(module_.type(value)).name) +
                          " to its output '" + p.name + "', which is " +
                          std::string(info(wanted).name));
        if (module_[value].level > 0)
            return refuse("uses a value of a loop or a function outside of it");
        return value;
    }

    // Returns true if the value is a material or poison.
    bool is_material(wr_value value) {
        if (value == poison) return true;
        if (!usable(std::array{value})) return false;
        if (lowering_.records().has(value)) return true;
        return refuse("takes a channel of another value than a material"), false;
    }
    bool is_channel(wr_value material, const char* name, uint32_t type) {
        if (!is_material(material)) return false;
        if (!is_plain(name) || type < 1 || type > port_type_count)
            return refuse("uses an impossible channel"), false;
        const std::string why =
            lowering_.records().problem(material, name, static_cast<PortType>(type));
        return why.empty() || refuse(why);
    }
    Id channel(wr_value material, const char* name, uint32_t type) {
        if (!is_channel(material, name, type)) return poison;
        return lowering_.records().channel(material, name, static_cast<PortType>(type));
    }
    Id with_channel(wr_value material, const char* name, uint32_t type, wr_value value) {
        const auto port_type = static_cast<PortType>(type);
        if (!is_channel(material, name, type)) return poison;
        if (value == poison) return material == poison ? lowering_.records().add({}) : material;
        if (!usable(std::array{value})) return poison;
        if (module_.type(value) != value_type(port_type))
            return refuse("gives channel '" + std::string(name) + "' a value of another type");
        return lowering_.records().with(material, {name, port_type, value});
    }
    Id mix_materials(wr_value one, wr_value other, wr_value t) {
        if (!is_material(one) || !is_material(other) || !usable(std::array{t})) return poison;
        if (t == poison || module_.type(t) != Type::float_)
            return refuse("mixes materials by another value than a float");
        return lowering_.records().mixed(one, other, t);
    }

    void name(wr_value value, const char* name) {
        constexpr size_t max_commented = 160;
        if (value != poison && value < module_.size() && is_plain(name, max_commented))
            module_.name(value, module_.current_node, name);
    }
    static bool is_plain(const char* name, size_t most = max_name) {
        return name && strnlen(name, most + 1) <= most && is_utf8(name);
    }

    void error(const char* text) { refuse(text ? plugin_text(text) : "reports an error", ""); }

    Lowering& lowering_;
    const uint32_t node_;
    wr_builder face_;
    std::vector<Named> unread_;  // outputs that no wire reads
    std::vector<RegionUse> regions_;
    std::optional<OverLimit> over_;
    int skipped_ = 0;  // regions that were nested too deep
};

}  // namespace

void build_node(Lowering& lowering, uint32_t node) {
    Builder(lowering, node).run();
}

}  // namespace wrinkle
