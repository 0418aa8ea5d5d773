#include "cli/npy.h"

#include <cstring>

#include "base/text.h"
#include "cli/arguments.h"
#include "json/parse.h"

namespace wrinkle::cli {
namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr size_t alignment = 64;  // bytes; NumPy aligns the first record to it

size_t little_endian(std::string_view bytes, size_t first, size_t count) {
    size_t number = 0;
    for (size_t i = count; i-- > 0;)
        number = number << 8 | static_cast<unsigned char>(bytes[first + i]);
    return number;
}

// Spells a Python literal as JSON: tuples as arrays, without commas before a closing bracket.
// Returns "" for strings that are not closed or have escapes.
std::string json_of(std::string_view text) {
    std::string json;
    for (size_t length = 1; !text.empty(); text.remove_prefix(length), length = 1) {
        const char c = text[0];
        if (c == '\'' || c == '"') {
            length = text.find(c, 1) + 1;
            if (length == 0) return {};
            const std::string_view word = text.substr(1, length - 2);
            if (word.find('\\') != word.npos) return {};
            json += json_quoted(word);
        } else if (c == ')' || c == ']' || c == '}') {
            const size_t last = json.find_last_not_of(" \n");
            if (last != json.npos && json[last] == ',') json.erase(last);
            json += c == ')' ? ']' : c;
        } else if (text.starts_with("True") || text.starts_with("False")) {
            length = c == 'T' ? 4 : 5;
            json += c == 'T' ? "true" : "false";
        } else {
            json += c == '(' ? '[' : c;
        }
    }
    return json;
}

void require_form(bool readable) {
    if (!readable)
        throw NpyProblem{"has a header that cannot be read", "write it with numpy.save()"};
}

void read_field(const json::Value& pair, NpyTable& table) {
    require_form(pair.is(json::Kind::array) && pair.size() >= 2 &&
                 pair.at(0).is(json::Kind::string) && pair.at(1).is(json::Kind::string));
    const std::string name(pair.at(0).as_string()), type(pair.at(1).as_string());
    if (pair.size() > 2)
        throw NpyProblem{"has a field '" + name + "' of several numbers",
                         "one number in each field: 'uv0.x', 'uv0.y'"};
    size_t size = type == "<f8" ? 8 : 4;
    if (type.starts_with("|V"))
        require_form(parse_number(std::string_view(type).substr(2), size) && size <= 65536);
    else if (type == "<f4" || type == "<f8")
        table.fields.push_back({name, table.record, type == "<f8"});
    else
        throw NpyProblem{"has a field '" + name + "' of type " + type, "<f4 or <f8"};
    table.record += size;
}

void read_fields(const json::Value& value, NpyTable& table) {
    if (value.is(json::Kind::string))
        throw NpyProblem{"holds numbers without names",
                         "fields such as [('uv0.x', '<f4'), ('uv0.y', '<f4')]"};
    require_form(value.is(json::Kind::array));
    for (const json::Member& member : value.children())
        read_field(member.value, table);
}

// Reads the header: a Python dictionary.
void read_header(std::string_view text, NpyTable& table) {
    Diagnostics problems;
    const json::Value root = json::parse(json_of(text), "", problems).root;
    require_form(!problems.has_errors() && root.is(json::Kind::object));
    for (const auto& [key, value] : root.children()) {
        if (key == "descr") {
            read_fields(value, table);
        } else if (key == "shape") {
            if (value.size() > 1)
                throw NpyProblem{"has more than one dimension", "one record for each point"};
            require_form(value.is(json::Kind::array) && value.size() == 1 &&
                         value.at(0).is(json::Kind::number) &&
                         parse_number(value.at(0).spelling(), table.count));
        } else {
            require_form(key == "fortran_order" && value.is(json::Kind::boolean));
            if (value.as_boolean())
                throw NpyProblem{"has Fortran order", "records one after the other"};
        }
    }
    require_form(root.has("shape") && !table.fields.empty());
}

template <class T>
T read_as(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

}  // namespace

double NpyTable::number(std::string_view bytes, const NpyField& field, size_t point) const {
    const char* from = bytes.data() + first + point * record + field.offset;
    return field.is_double ? read_as<double>(from) : double{read_as<float>(from)};
}

NpyTable read_npy(std::string_view bytes) {
    const bool has_head =
        bytes.starts_with(magic) && bytes.size() >= 12 && bytes[6] >= 1 && bytes[6] <= 3;
    const size_t begin = has_head && bytes[6] == 1 ? 10 : 12;
    const size_t length = has_head ? little_endian(bytes, 8, begin - 8) : 0;
    if (!has_head || length > bytes.size() - begin)
        throw NpyProblem{"is not a whole NPY file", "write it with numpy.save()"};
    NpyTable table;
    table.first = begin + length;
    read_header(bytes.substr(begin, length), table);
    const size_t held = bytes.size() - table.first;
    if (held % table.record != 0 || held / table.record != table.count)
        throw NpyProblem{"holds " + std::to_string(held) + " bytes of points, not " +
                             std::to_string(table.count) + " records of " +
                             std::to_string(table.record),
                         "a whole file"};
    return table;
}

std::string npy_header(const std::vector<std::string>& names, bool doubles, size_t count) {
    std::string text = "{'descr': [";
    for (const std::string& name : names)
        text += "('" + name + "', '" + (doubles ? "<f8" : "<f4") + "'), ";
    text += "], 'fortran_order': False, 'shape': (" + std::to_string(count) + ",), }";
    constexpr size_t before = 12;  // magic, version 2.0, length
    const size_t whole = (before + text.size() + 1 + alignment - 1) / alignment * alignment;
    text.append(whole - before - text.size() - 1, ' ');
    text += '\n';
    std::string header = std::string(magic) + '\x02' + '\0';
    for (int i = 0; i < 4; ++i)
        header += static_cast<char>(text.size() >> (8 * i) & 0xFF);
    return header + text;
}

}  // namespace wrinkle::cli
