#include "editor/model/images/remarks.h"

#include <algorithm>
#include <array>

#include "editor/model/document/field.h"
#include "editor/model/document/wiring.h"
#include "editor/model/images/facts.h"
#include "editor/model/session.h"
#include "graph/edit.h"
#include "lower/literal.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

using maps::MapClass;

// Corresponding node types for the kinds of maps; "" if there is none.
struct MapFamily {
    std::string_view height, normal, object, slopes;
};
constexpr std::array families = {
    MapFamily{"height_map", "tangent_normal_map", "object_normal_map", "derivative_map"},
    MapFamily{"triplanar_height_map", "triplanar_normal_map", "", "triplanar_derivative_map"},
    MapFamily{"hex_tile_height_map", "hex_tile_normal_map", "", ""},
};

const MapFamily* family_of(std::string_view type) {
    for (const MapFamily& family : families)
        for (const std::string_view each :
             {family.height, family.normal, family.object, family.slopes})
            if (!each.empty() && each == type) return &family;
    return nullptr;
}

bool is_tangent(MapClass look) {
    return look == MapClass::normal || look == MapClass::normal_gl || look == MapClass::normal_dx;
}

// Returns the node type that fits the image; "" if nothing contradicts the current one.
std::string_view better_type(const MapFamily& family, std::string_view type, MapClass look) {
    if (look == MapClass::height) return family.height;
    if (type == family.slopes) return {};  // 8-bit slopes may look like any kind
    if (is_tangent(look) && type == family.object)
        return look == MapClass::normal ? "" : family.normal;
    if (is_tangent(look)) return family.normal;
    if (look == MapClass::normal_object) return family.object;
    if (look == MapClass::two_channel && type == family.height) return family.slopes;
    return {};
}

std::string_view what_it_reads(const MapFamily& family, std::string_view type) {
    if (type == family.height) return "heights";
    if (type == family.slopes) return "slopes";
    return type == family.object ? "object-space normals" : "tangent-space normals";
}

class Remarker {
public:
    Remarker(const Session& session, std::vector<ImageWarning>& remarks)
        : session_(session), images_(session.images), remarks_(remarks) {}

    void look_at(const Node& node, const NodeType& type) {
        family_ = family_of(type.id);
        if (!family_) return;
        node_ = &node;
        type_ = &type;
        for (const Input& input : node.inputs) {
            port_ = input_port(&type, input.port);
            if (port_ && input.kind == Input::Kind::literal && port_->is_value() &&
                port_->type == PortType::image_)
                look_at(input);
        }
    }

private:
    void look_at(const Input& input) {
        literal_ = literal_image(input.value);
        encoding_ = literal_.encoding.value_or(port_->encoding);
        examined_ = examined_at(session_, *node_, port_->name);
        if (!examined_ || !examined_->problem.empty() || encoding_ == Encoding::normal_ag) return;
        file_ = images_.paths.at(std::string(literal_.file));
        if (remark_type()) return;  // other remarks would follow from it
        remark_green();
        remark_defects();
    }

    bool is_normals() const { return type_->id == family_->normal; }
    bool has_green() const {
        return encoding_ == Encoding::normal_gl || encoding_ == Encoding::normal_dx;
    }

    void add(std::string about, std::string message, std::string evidence, Remedy remedy = {}) {
        const std::vector<std::string>& dismissed = session_.keeping.settings.dismissed;
        const std::string mark = dismissal_mark(file_, examined_->stamp, about);
        if (std::ranges::find(dismissed, mark) != dismissed.end()) return;
        ImageWarning remark;
        remark.problem.severity = Severity::warning;
        remark.problem.pointer = "/nodes/" + node_->id + "/in/" + port_->name;
        remark.problem.node = node_->id;
        remark.problem.message = std::move(message);
        remark.problem.expected = std::move(evidence);
        remark.port = port_->name;
        remark.file = file_.string();
        remark.about = std::move(about);
        remark.remedy = std::move(remedy);
        const bool helps = remark.remedy.kind != Remedy::Kind::none &&
                           !same_node(remedied(session_, remark), node_->id);
        if (!helps) remark.remedy = {};
        remarks_.push_back(std::move(remark));
    }
    bool same_node(const Document& document, const std::string& id) const {
        return document.find(id) == session_.document().find(id);
    }

    bool remark_type() {
        const MapClass look = examined_->verdict.map_class;
        if (is_normals() && look == MapClass::two_channel && has_green()) {
            add("type", "the image has no z in blue, but the node reads one", "",
                {Remedy::Kind::encoding, "Make z", std::string(name_of(Encoding::normal_rg))});
            return true;
        }
        const std::string_view better = better_type(*family_, type_->id, look);
        if (better == type_->id || (better.empty() && !is_odd(look))) return false;
        const NodeType* type = session_.registry->find(better);
        add("type",
            "the image looks like " + std::string(description_of(look)) + ", but the node reads " +
                std::string(what_it_reads(*family_, type_->id)),
            summary_of(*examined_),
            type ? Remedy{Remedy::Kind::type, "Read as " + short_kind(better), std::string(better)}
                 : Remedy{});
        return true;
    }
    std::string short_kind(std::string_view type) const {
        return type == family_->height ? "heights" : type == family_->slopes ? "slopes" : "normals";
    }
    // Returns true if the image is of another kind for which the family has no node type.
    bool is_odd(MapClass look) const {
        return look == MapClass::normal_object && type_->id != family_->object &&
               type_->id != family_->slopes;
    }

    void remark_green() {
        const MapClass look = examined_->verdict.map_class;
        const bool down = look == MapClass::normal_dx;
        if (!is_normals() || !has_green() || (!down && look != MapClass::normal_gl)) return;
        if (down == (encoding_ == Encoding::normal_dx)) return;
        const std::string says = down ? "points down (dx)" : "points up (gl)";
        const std::string reads = down ? "up (gl)" : "down (dx)";
        const Encoding right = down ? Encoding::normal_dx : Encoding::normal_gl;
        add("green",
            "the image looks like green " + says + ", but the node reads green as " + reads +
                ". Bumps may look like dents",
            curl_words(examined_->verdict),
            {Remedy::Kind::encoding, down ? "Read as dx" : "Read as gl",
             std::string(name_of(right))});
    }

    void remark_defects() {
        bool seam = false;
        for (const maps::Finding& finding : examined_->verdict.findings) {
            if (!finding.is_defect) continue;
            const bool is_seam = finding.defect == maps::MapDefect::seam_u ||
                                 finding.defect == maps::MapDefect::seam_v;
            if (is_seam && (seam || literal_.wrap != Wrap::repeat)) continue;
            seam |= is_seam;
            const bool of_z = finding.defect == maps::MapDefect::unsigned_z ||
                              finding.defect == maps::MapDefect::length;
            if (of_z && (!is_normals() || !has_green())) continue;
            add(is_seam ? "seam" : std::string(name_of(finding.defect)),
                std::string(words_of(finding.defect)), finding.message, remedy_of(is_seam, of_z));
        }
    }
    Remedy remedy_of(bool seam, bool of_z) const {
        if (seam) return {Remedy::Kind::wrap, "Clamp", std::string(name_of(Wrap::clamp))};
        if (of_z && encoding_ == Encoding::normal_gl)
            return {Remedy::Kind::encoding, "Make z", std::string(name_of(Encoding::normal_rg))};
        return {};
    }

    const Session& session_;
    const Images& images_;
    std::vector<ImageWarning>& remarks_;
    const MapFamily* family_ = nullptr;
    const Node* node_ = nullptr;
    const NodeType* type_ = nullptr;
    const Port* port_ = nullptr;
    ImageLiteral literal_;
    Encoding encoding_ = Encoding::linear;
    const Examined* examined_ = nullptr;
    fs::path file_;
};

// Returns the output of the new type for a user of the old type's `port`: the same name, or a
// gradient.
std::string output_in_place(const NodeType& type, const std::string& port) {
    if (type.find_output(port) != NodeType::none) return port;
    const Port* gradient = first_output(&type, {PortType::gradient_});
    return gradient ? gradient->name : "";
}

// Returns true if every wire from the node starts at an output of a fitting type.
bool keeps_readers(const Session& session, const Document& document, const std::string& id) {
    const NodeType* from = session.registry->find(document.find(id)->type);
    bool fit = true;
    each_wire(document, [&](const Connection& wire) {
        if (wire.from.node != id || wire.node == id) return;
        const auto wanted = wanted_at(session.model, wire.node, wire.port);
        if (!wanted && !wire.node.empty()) return;
        const Port* out = output_port(from, wire.from.port);
        fit = fit && out && converts(out->type, wanted);
    });
    return fit;
}

bool holds_the_same(const Port& a, const Port& b) {
    return a.kind == b.kind && a.type == b.type && a.choices == b.choices;
}

// Changes the node's type: inputs unknown to the new type are reset; the encoding remains that of
// the old port.
Document retyped(const Session& session, const Node& node, const NodeType& to) {
    const NodeType* from = session.type_of(node.id);
    Document result = session.document();
    NodeUpgrade upgrade;
    upgrade.id = node.id;
    upgrade.version = static_cast<int>(to.version);
    for (const Port& port : from->ports) {
        if (port.kind == Port::Kind::output) {
            const std::string name = output_in_place(to, port.name);
            if (name != port.name) upgrade.outputs.push_back({port.name, name});
            continue;
        }
        const Port* input = input_port(&to, port.name);
        if (!input || !holds_the_same(*input, port))
            result = reset_value(result, node.id, port.name);
        else if (port.is_value() && port.type == PortType::image_)
            result = with_image_word(result, node.id, port, "encoding", name_of(port.encoding));
    }
    result = set_type(result, node.id, to.id, static_cast<int>(to.version));
    return upgrade_nodes(result, {upgrade});
}

}  // namespace

std::vector<ImageWarning> find_remarks(const Session& session) {
    std::vector<ImageWarning> remarks;
    if (session.images.known.empty()) return remarks;
    Remarker remarker(session, remarks);
    for (const NodePtr& node : session.document().nodes)
        if (const NodeType* type = session.type_of(node->id)) remarker.look_at(*node, *type);
    return remarks;
}

Document remedied(const Session& session, const ImageWarning& remark) {
    const Document& document = session.document();
    const Node* node = document.find(remark.problem.node);
    const NodeType* type = node ? session.type_of(node->id) : nullptr;
    const Port* port = input_port(type, remark.port);
    if (!port) return document;
    const Remedy& remedy = remark.remedy;
    if (remedy.kind == Remedy::Kind::encoding || remedy.kind == Remedy::Kind::wrap) {
        const bool wrap = remedy.kind == Remedy::Kind::wrap;
        return with_image_word(document, node->id, *port, wrap ? "wrap" : "encoding", remedy.word);
    }
    const NodeType* to =
        remedy.kind == Remedy::Kind::type ? session.registry->find(remedy.word) : nullptr;
    const Port* image = input_port(to, remark.port);
    if (!image) return document;
    const Examined* examined = examined_at(session, *node, remark.port);
    Document result = retyped(session, *node, *to);
    if (examined && examined->verdict.map_class == maps::MapClass::normal_dx)
        result =
            with_image_word(result, node->id, *image, "encoding", name_of(Encoding::normal_dx));
    return keeps_readers(session, result, node->id) ? result : document;
}

void apply_remedy(Session& session, const ImageWarning& remark) {
    session.commit(remark.problem.node + ": " + remark.remedy.label, remedied(session, remark));
}

void dismiss_remark(Session& session, const ImageWarning& remark) {
    const auto known = session.images.known.find(remark.file);
    if (known == session.images.known.end()) return;
    std::vector<std::string>& dismissed = session.keeping.settings.dismissed;
    dismissed.push_back(dismissal_mark(remark.file, known->second.stamp, remark.about));
    if (dismissed.size() > Settings::max_dismissed) dismissed.erase(dismissed.begin());
    ++session.images.changes;
}

std::string dismissal_mark(const fs::path& file, const Stamp& version, std::string_view about) {
    std::error_code error;
    const fs::path absolute = fs::absolute(file, error);
    return (error ? file : absolute).string() + '\n' + std::to_string(version.seconds) + '.' +
           std::to_string(version.nanoseconds) + ' ' + std::to_string(version.size) + '\n' +
           std::string(about);
}

}  // namespace wrinkle::editor
