#include "editor/view/canvas/make_card.h"

#include <algorithm>
#include <cmath>

#include "editor/model/document/field.h"
#include "editor/model/document/knots.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/magnified.h"

namespace wrinkle::editor {
namespace {

bool shows_field(const Port& port) {
    return port.is_option() || lanes_of_field(port) > 0 ||
           (port.is_value() && port.type == PortType::image_);
}

Field::Shows shown_in_field(const NodeType& type, const Port& port) {
    if (port.kind != Port::Kind::count) return Field::Shows::value;
    if (ramp_ports(&type).count == &port) return Field::Shows::strip;
    return curve_ports(&type).count == &port ? Field::Shows::curve : Field::Shows::value;
}

class CardMaker {
public:
    CardMaker(const Fonts& fonts, const Node& node, std::span<const std::string_view> read,
              Shown shown)
        : fonts_(fonts), node_(node), read_(read), shown_(shown) {}

    Card make(const NodeType* type) {
        card.id = node_.id;
        card.type = type;
        card.label = type ? type->title : node_.type;
        card.muted = node_.muted;
        if (node_.type == reroute_type) {
            fill_reroute();
            return std::move(card);
        }
        card.size.x = wanted_width();
        if (type)
            fill_ports();
        else
            fill_unknown();
        return std::move(card);
    }

private:
    float width(const TextStyle& style, std::string_view text) const {
        return magnified_width(fonts_, style, text);
    }
    std::string cut(const TextStyle& style, std::string_view text, float room) const {
        return magnified_fitting(fonts_, style, text, room);
    }
    bool is_read(std::string_view port) const {
        return std::ranges::find(read_, port) != read_.end();
    }

    bool is_wired(const std::string& port) const {
        const Input* input = node_.find(port);
        return input && input->kind == Input::Kind::link;
    }

    float wanted_width() const {
        const float label = std::min(width(card_text::small, card.label), 80.0F);
        float wanted = name_left + width(card_text::bold, card.id) + 16 + label + 10;
        if (!card.type) return std::clamp(std::ceil(wanted / 8) * 8, 104.0F, 240.0F);
        for (const Port& port : card.type->ports) {
            float row = 40 + width(card_text::body, port.name);
            if (port.kind != Port::Kind::output && shows_field(port))
                row += 48 + 44 * static_cast<float>(std::max(lanes_of_field(port) - 1, 0));
            wanted = std::max(wanted, row);
        }
        return std::clamp(std::ceil(wanted / 8) * 8, 104.0F, 240.0F);
    }

    void add_pin(const std::string& port, PortType type, bool known, bool output, bool connected,
                 float y) {
        card.pins.push_back({port, type, known, output, connected, y + row_height / 2,
                             cut(card_text::body, port, card.size.x - 30), false});
    }

    // A single number has its name inside the field, left of its value.
    void write_field(Field& field, const Port& port) const {
        field.shows = shown_in_field(*card.type, port);
        if (field.shows != Field::Shows::value) return;
        field.listed = port.kind == Port::Kind::choice || port.type == PortType::image_;
        const double value = numbers_at(node_, port)[static_cast<size_t>(field.lane)];
        if (field.lanes > 0 && port.has_soft_range())
            field.part = static_cast<float>(
                std::clamp((value - port.soft_min) / (port.soft_max - port.soft_min), 0.0, 1.0));
        const float room = field.width - 14 - (field.listed ? 12.0F : 0.0F);
        // The name of a single number leaves at least this width for the value, else it is
        // truncated.
        constexpr float digits_room = 64;
        const float name = field.lanes > 1 ? 0 : width(card_text::body, port.name) + 6;
        const float number_room = std::min(room, std::max(room - name, digits_room));
        const Fits fits = [&](const std::string& text) {
            return width(card_text::body, text) <= number_room;
        };
        const std::string shown =
            field.lanes > 1 ? shown_number(value, port, fits) : shown_value(node_, port, fits);
        field.value = cut(card_text::body, shown, room);
        const float left = room - width(card_text::body, field.value) - 6;
        if (field.lanes <= 1 && left > 16) field.name = cut(card_text::body, port.name, left);
    }

    // The fields of several numbers are side by side, right of their common name.
    void add_field(uint32_t index, const Port& port, float y) {
        const int lanes = lanes_of_field(port);
        const float named = lanes > 1 ? width(card_text::body, port.name) + 6 : 0;
        const float first = field_inset + named;
        const float wide =
            (card.size.x - field_inset - first) / static_cast<float>(std::max(lanes, 1));
        for (int lane = 0; lane < std::max(lanes, 1); ++lane) {
            Field field;
            field.port = port.name;
            field.index = index;
            field.lane = lane;
            field.lanes = lanes;
            field.x = first + wide * static_cast<float>(lane);
            field.y = y;
            field.width = wide;
            write_field(field, port);
            card.fields.push_back(std::move(field));
        }
    }

    void fold_ports() {
        const std::vector<Port>& ports = card.type->ports;
        const bool is_long = ports.size() > most_rows;
        size_t inputs = 0, outputs = 0;
        bool folds_output = false, folds_input = false;
        for (uint32_t i = 0; i < ports.size(); ++i) {
            const bool output = ports[i].kind == Port::Kind::output;
            if (!output && is_knot_port(*card.type, ports[i].name)) {
                if (is_wired(ports[i].name)) continue;
            } else if (!is_long) {
                continue;
            } else {
                const bool first = (output ? outputs : inputs)++ < first_rows;
                const bool set = node_.find(ports[i].name) != nullptr;
                if (first || (output ? is_read(ports[i].name) : set)) continue;
            }
            folded_.insert(i);
            (output ? folds_output : folds_input) = true;
        }
        if (folded_.empty()) return;
        const char* what = !folds_output ? "input" : folds_input ? "port" : "output";
        card.more = shown_.unfolded ? "fewer" : std::to_string(folded_.size()) + " more " + what;
        if (folded_.size() > 1 && !shown_.unfolded) card.more += "s";
        card.unfolded = shown_.unfolded;
        if (shown_.unfolded) folded_.clear();
    }

    void fill_ports() {
        float y = header_height;
        fold_ports();
        for (uint32_t i = 0; i < card.type->ports.size(); ++i) {
            const Port& port = card.type->ports[i];
            if (port.kind != Port::Kind::output || folded_.contains(i)) continue;
            add_pin(port.name, port.type, true, true, is_read(port.name), y);
            y += row_height;
        }
        for (uint32_t i = 0; i < card.type->ports.size(); ++i) {
            const Port& port = card.type->ports[i];
            if (port.kind == Port::Kind::output || folded_.contains(i)) continue;
            const bool connected = is_wired(port.name);
            const bool field = !connected && shows_field(port);
            if (port.is_value() || connected) {
                add_pin(port.name, port.type, true, false, connected, y);
                card.pins.back().in_field = field && lanes_of_field(port) <= 1;
            }
            if (field) add_field(i, port, y + 1.5F);
            y += row_height;
        }
        if (!card.more.empty()) {
            card.more_y = y;
            y += row_height;
        }
        if (shown_.preview) {
            card.preview_y = y + 4;
            y += node_preview_height + 8;
        }
        card.size.y = y + cost_height;
    }

    void fill_reroute() {
        const PortType type = card.type ? card.type->ports.front().type : PortType::float_;
        const Input* in = node_.find("in");
        const bool fed = in && in->kind == Input::Kind::link;
        const float y = reroute_height / 2;
        card.reroute = true;
        card.size = {reroute_width, reroute_height};
        card.pins.push_back({"out", type, card.type != nullptr, true, is_read("out"), y, ""});
        card.pins.push_back({"in", type, card.type != nullptr, false, fed, y, ""});
    }

    // Ports as listed in the document.
    void fill_unknown() {
        float y = header_height;
        for (const std::string_view port : std::set(read_.begin(), read_.end())) {
            add_pin(std::string(port), PortType::float_, false, true, true, y);
            y += row_height;
        }
        for (const Input& input : node_.inputs) {
            add_pin(input.port, PortType::float_, false, false, input.kind == Input::Kind::link, y);
            y += row_height;
        }
        card.size.y = y + 8;
    }

    Card card;
    const Fonts& fonts_;
    const Node& node_;
    std::span<const std::string_view> read_;
    Shown shown_;
    std::set<uint32_t> folded_;  // ports without a row
};

void write_header(const Fonts& fonts, Card& card) {
    const bool output = card.kind == Card::Kind::outputs;
    const bool pinned = output || std::ranges::any_of(card.pins, &Pin::output);
    const float room = card.size.x - (pinned ? name_left : 10) - 10;
    card.name = magnified_fitting(fonts, card_text::bold, output ? "output" : card.id, room);
    card.name_width = magnified_width(fonts, card_text::bold, card.name);
    const float rest = room - card.name_width - 12;
    if (rest > 28 && card.size.x >= 112)
        card.title = magnified_fitting(fonts, card_text::small, card.label, rest);
}

void add_row(Card& card, std::string name, PortType type, bool output, bool connected) {
    const float y = header_height + row_height * static_cast<float>(card.pins.size());
    card.pins.push_back({name, type, true, output, connected, y + row_height / 2, name, false});
}

// `all`: the card shows all rows; `more`: there are others, or it does.
void close_card(const Fonts& fonts, Card& card, bool more, bool all) {
    card.size = {112, header_height + row_height * static_cast<float>(card.pins.size()) + 8};
    for (const Pin& pin : card.pins)
        card.size.x =
            std::clamp(magnified_width(fonts, card_text::body, pin.port) + 30, card.size.x, 240.0F);
    for (Pin& pin : card.pins)
        pin.label = magnified_fitting(fonts, card_text::body, pin.port, card.size.x - 30);
    write_header(fonts, card);
    if (!more) return;
    card.more = all ? "fewer" : "more...";
    card.more_y = card.size.y - 4;
    card.size.y += row_height - 4;
}

}  // namespace

bool has_preview(const View& view, const Node& node, const NodeType* type) {
    if (!view.node_previews || !type || node.type == reroute_type) return false;
    const Port* made = shown_port(type);
    if (!made) return false;
    const bool usual = std::ranges::none_of(
        type->ports, [&](const Port& port) { return port.is_value() && port.type == made->type; });
    return usual != view.turned.contains(node.id);
}

Shown shown_of(const View& view, const Node& node, const NodeType* type) {
    return {has_preview(view, node, type), view.unfolded.contains(node.id)};
}

Card make_card(const Fonts& fonts, const Node& node, const NodeType* type,
               std::span<const std::string_view> read, Shown shown) {
    Card card = CardMaker(fonts, node, read, shown).make(type);
    write_header(fonts, card);
    return card;
}

Card make_surface_card(const State& state, const Used& used) {
    Card card;
    card.kind = Card::Kind::surface;
    card.id = Link::surface;
    const std::set<std::string_view> usual = {"position", "normal", "uv0", "uv1"};
    for (const SurfaceProperty& property : surface_properties()) {
        const bool read = used.surface.contains(property.name);
        if (read || state.view.all_surface || usual.contains(property.name))
            add_row(card, std::string(property.name), property.type, true, read);
    }
    close_card(state.fonts, card,
               card.pins.size() < surface_properties().size() || state.view.all_surface,
               state.view.all_surface);
    return card;
}

Card make_inputs_card(const State& state, const Used& used) {
    Card card;
    card.kind = Card::Kind::inputs;
    card.id = Link::input;
    for (const GraphInput& input : state.document().inputs)
        add_row(card, input.name, port_type_named(input.type).value_or(PortType::float_), true,
                used.inputs.contains(input.name));
    close_card(state.fonts, card, false, false);
    return card;
}

Card make_outputs_card(const State& state) {
    Card card;
    card.kind = Card::Kind::outputs;
    card.id = Card::outputs_id;
    const Table<Output>& outputs = state.document().outputs;
    const std::set<std::string_view> usual = {"normal", "height", "color", "roughness"};
    const auto standard = standard_outputs();
    for (const std::string_view name : standard) {
        const Output* given = state.document().find_output(name);
        if (given || state.view.all_outputs || usual.contains(name))
            add_row(card, given ? given->name : std::string(name), *standard_output(name), false,
                    given != nullptr);
    }
    const bool more = card.pins.size() < standard.size() || state.view.all_outputs;
    for (const Output& output : outputs) {
        if (standard_output(output.name)) continue;
        const auto type = state.model.type_of(output.from.link);
        add_row(card, output.name, type.value_or(PortType::float_), false, true);
    }
    close_card(state.fonts, card, more, state.view.all_outputs);
    return card;
}

}  // namespace wrinkle::editor
