#include "cli/npy.h"

#include "cli/arguments.h"

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

// Parses the header: a Python dictionary literal.
class Header {
public:
    Header(std::string_view text, NpyTable& table, NpyProblem& problem)
        : text_(text), table_(table), problem_(problem) {}

    bool read() {
        if (!expect("{")) return false;
        while (!accept("}")) {
            std::string key;
            if (!string(key) || !expect(":")) return false;
            if (key == "descr" ? !fields() : key == "shape" ? !shape() : !order(key)) return false;
            if (!accept(",") && !peek("}")) return broken();
        }
        skip();
        if (!text_.empty() || !has_shape_ || table_.fields.empty()) return broken();
        return true;
    }

private:
    bool fail(std::string message, std::string expected) {
        problem_ = {std::move(message), std::move(expected)};
        return false;
    }
    bool broken() { return fail("has a header that cannot be read", "what numpy.save() writes"); }
    void skip() {
        const size_t first = text_.find_first_not_of(" \n");
        text_.remove_prefix(first == text_.npos ? text_.size() : first);
    }
    bool peek(std::string_view word) {
        skip();
        return text_.starts_with(word);
    }
    bool accept(std::string_view word) {
        if (!peek(word)) return false;
        text_.remove_prefix(word.size());
        return true;
    }
    bool expect(std::string_view word) { return accept(word) || broken(); }

    bool string(std::string& value) {
        if (!peek("'") && !peek("\"")) return broken();
        const size_t end = text_.find(text_[0], 1);
        if (end == text_.npos) return broken();
        value = text_.substr(1, end - 1);
        text_.remove_prefix(end + 1);
        return value.find('\\') == value.npos || broken();
    }
    bool number(size_t& value) {
        skip();
        const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
        if (error != std::errc{}) return broken();
        text_.remove_prefix(static_cast<size_t>(end - text_.data()));
        return true;
    }

    bool order(const std::string& key) {
        if (key != "fortran_order") return broken();
        return accept("False") || fail("has Fortran order", "records one after the other");
    }
    bool shape() {
        has_shape_ = true;
        if (!expect("(") || !number(table_.count) || !expect(",")) return false;
        return accept(")") || fail("has more than one dimension", "one record for each point");
    }

    bool fields() {
        if (peek("'") || peek("\""))
            return fail("holds numbers without names",
                        "fields such as [('uv0.x', '<f4'), ('uv0.y', '<f4')]");
        if (!expect("[")) return false;
        while (!accept("]")) {
            NpyField field;
            std::string type;
            if (!expect("(") || !string(field.name) || !expect(",") || !string(type)) return false;
            if (!accept(")"))
                return fail("has a field '" + field.name + "' of several numbers",
                            "one number in each field: 'uv0.x', 'uv0.y'");
            if (!add(field, type)) return false;
            if (!accept(",") && !peek("]")) return broken();
        }
        return true;
    }
    bool add(NpyField& field, const std::string& type) {
        field.offset = table_.record;
        size_t padding = 0;
        if (type.starts_with("|V")) {
            if (!parse_number(std::string_view(type).substr(2), padding) || padding > 65536)
                return broken();
        } else if (type == "<f4" || type == "<f8") {
            field.is_double = type == "<f8";
            table_.fields.push_back(field);
        } else {
            return fail("has a field '" + field.name + "' of type " + type, "<f4 or <f8");
        }
        table_.record += padding > 0 ? padding : field.is_double ? 8 : 4;
        return true;
    }

    std::string_view text_;
    NpyTable& table_;
    NpyProblem& problem_;
    bool has_shape_ = false;
};

}  // namespace

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
    if (!Header(bytes.substr(begin, length), table, problem).read()) return {};
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
