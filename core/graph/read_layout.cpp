#include "graph/reader.h"

namespace wrinkle::reading {
namespace {

using json::Kind;
using json::Value;

bool numbers(const Value& value, size_t count) {
    if (!value.is(Kind::array) || value.size() != count) return false;
    for (const json::Member& item : value.children())
        if (!item.value.is(Kind::number)) return false;
    return true;
}

Box read_box(std::string_view id, const Value& value, std::string_view text_key, Report& report) {
    Box box;
    box.id = id;
    box.source = value;
    if (!report.expect(value, Kind::object, "a frame or note", "")) return box;
    for (const auto& [key, member] : value.children()) {
        if (key == text_key && report.expect(member, Kind::string, text_key, ""))
            box.text = member.as_string();
        else if (key == "rect" && numbers(member, 4))
            box.rect = {member.at(0).as_number(), member.at(1).as_number(),
                        member.at(2).as_number(), member.at(3).as_number()};
        else
            box.unknown.push_back({std::string(key), member});
    }
    if (!numbers(value.find("rect"), 4) && !value.cut_off() && !value.find("rect").cut_off())
        report.at(value.has("rect") ? value.find("rect") : value, "", RuleId::invalid_value,
                  "a frame or note has no rectangle", "expected \"rect\": [x, y, width, height]");
    return box;
}

Table<Box> read_boxes(const Value& value, std::string_view text_key, Report& report) {
    std::vector<Box> boxes;
    for (const json::Member& member : value.children())
        boxes.push_back(read_box(member.key, member.value, text_key, report));
    return Table<Box>(std::move(boxes));
}

bool read_position(const json::Member& member, std::vector<Position>& positions, Report& report) {
    const Value& value = member.value;
    if (!member.key.empty() && member.key[0] == '$') return false;
    if (!numbers(value, 2)) {
        if (!value.cut_off())
            report.at(value, std::string(member.key), RuleId::invalid_value,
                      "the position is not two numbers", "expected [x, y]");
        return false;
    }
    positions.push_back(
        {std::string(member.key), value.at(0).as_number(), value.at(1).as_number(), value});
    return true;
}

}  // namespace

void read_layout(const Value& layout, Document& document, Report& report) {
    std::vector<Position> positions;
    for (const json::Member& member : layout.children()) {
        const bool frames = member.key == "$frames";
        const bool notes = member.key == "$notes";
        if (frames && report.expect(member.value, Kind::object, "\"$frames\"", ""))
            document.frames = read_boxes(member.value, "title", report);
        else if (notes && report.expect(member.value, Kind::object, "\"$notes\"", ""))
            document.notes = read_boxes(member.value, "text", report);
        else if (frames || notes || !read_position(member, positions, report))
            document.unknown_layout.push_back({std::string(member.key), member.value});
    }
    document.positions = Table<Position>(std::move(positions));
}

}  // namespace wrinkle::reading
