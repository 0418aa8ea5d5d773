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

// Reads the header: a Python dictionary.
class Header {
public:
    Header(NpyTable& table, NpyProblem& problem) : table_(table), problem_(problem) {}

    bool read(std::string_view text) {
        Diagnostics problems;
        const json::Value root = json::parse(json_of(text), "", problems).root;
        if (problems.has_errors() || !root.is(Kind::object)) return broken();
        for (const json::Member& member : root.children()) {
            const bool read = member.key == "descr"   ? fields(member.value)
                              : member.key == "shape" ? shape(member.value)
                                                      : order(member);
            if (!read) return false;
        }
        return (has_shape_ && !table_.fields.empty()) || broken();
    }

private:
    using Kind = json::Kind;

    bool fail(std::string message, std::string expected) {
        problem_ = {std::move(message), std::move(expected)};
        return false;
    }
    bool broken() { return fail("has a header that cannot be read", "what numpy.save() writes"); }

    bool order(const json::Member& member) {
        if (member.key != "fortran_order" || !member.value.is(Kind::boolean)) return broken();
        return !member.value.as_boolean() ||
               fail("has Fortran order", "records one after the other");
    }
    bool shape(const json::Value& value) {
        has_shape_ = true;
        if (value.size() > 1)
            return fail("has more than one dimension", "one record for each point");
        const bool is_count = value.is(Kind::array) && value.size() == 1 &&
                              value.at(0).is(Kind::number) &&
                              parse_number(value.at(0).spelling(), table_.count);
        return is_count || broken();
    }

    bool fields(const json::Value& value) {
        if (value.is(Kind::string))
            return fail("holds numbers without names",
                        "fields such as [('uv0.x', '<f4'), ('uv0.y', '<f4')]");
        if (!value.is(Kind::array)) return broken();
        for (const json::Member& member : value.children()) {
            const json::Value& pair = member.value;
            if (!pair.is(Kind::array) || pair.size() < 2 || !pair.at(0).is(Kind::string) ||
                !pair.at(1).is(Kind::string))
                return broken();
            const std::string name(pair.at(0).as_string()), type(pair.at(1).as_string());
            if (pair.size() > 2)
                return fail("has a field '" + name + "' of several numbers",
                            "one number in each field: 'uv0.x', 'uv0.y'");
            if (!add(name, type)) return false;
        }
        return true;
    }
    bool add(const std::string& name, const std::string& type) {
        size_t size = type == "<f8" ? 8 : 4;
        if (type.starts_with("|V")) {
            if (!parse_number(std::string_view(type).substr(2), size) || size > 65536)
                return broken();
        } else if (type == "<f4" || type == "<f8") {
            table_.fields.push_back({name, table_.record, type == "<f8"});
        } else {
            return fail("has a field '" + name + "' of type " + type, "<f4 or <f8");
        }
        table_.record += size;
        return true;
    }

    NpyTable& table_;
    NpyProblem& problem_;
    bool has_shape_ = false;
};

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

std::optional<NpyTable> read_npy(std::string_view bytes, NpyProblem& problem) {
    const auto cut = [&] {
        problem = {"is not a whole NPY file", "what numpy.save() writes"};
        return std::nullopt;
    };
    if (!bytes.starts_with(magic) || bytes.size() < 12) return cut();
    const bool small = bytes[6] == 1;
    if (bytes[6] < 1 || bytes[6] > 3) return cut();
    const size_t begin = small ? 10 : 12;
    const size_t length = little_endian(bytes, 8, small ? 2 : 4);
    if (length > bytes.size() - begin) return cut();
    NpyTable table;
    table.first = begin + length;
    if (!Header(table, problem).read(bytes.substr(begin, length))) return {};
    const size_t held = bytes.size() - table.first;
    if (held % table.record != 0 || held / table.record != table.count) {
        problem = {"holds " + std::to_string(held) + " bytes of points, not " +
                       std::to_string(table.count) + " records of " + std::to_string(table.record),
                   "a whole file"};
        return {};
    }
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
