#include "report/results_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/file.h"
#include "base/text.h"
#include "json/parse.h"

namespace wrinkle::report {
namespace fs = std::filesystem;
namespace {

constexpr int version = 1;

// The members of each struct, for writing and reading. `visit` is called with the name and the
// member.
template <class Visit>
void visit_members(Measured& measured, Visit&& visit) {
    visit("name", measured.name);
    visit("node", measured.node);
    visit("expected", measured.expected);
    visit("actual", measured.actual);
    visit("value", measured.value);
    visit("limit", measured.limit);
    visit("unit", measured.unit);
}

template <class Visit>
void visit_members(Check& check, Visit&& visit) {
    visit("test", check.test);
    visit("name", check.name);
    visit("status", check.status);
    visit("kind", check.kind);
    visit("file", check.file);
    visit("line", check.line);
    visit("column", check.column);
    visit("pointer", check.pointer);
    visit("message", check.message);
    visit("expected", check.expected);
    visit("seconds", check.seconds);
    visit("measured", check.measured);
    visit("graph", check.graph);
    visit("inputs", check.inputs);
    visit("baseline", check.baseline);
    visit("expected_text", check.expected_text);
    visit("actual_text", check.actual_text);
    visit("nodes_of_lines", check.nodes_of_lines);
    visit("expected_image", check.expected_image);
    visit("actual_image", check.actual_image);
    visit("map_image", check.map_image);
    visit("joined_image", check.joined_image);
    visit("map_measure", check.map_measure);
    visit("map_scale", check.map_scale);
    visit("width", check.width);
    visit("height", check.height);
}

template <class Visit>
void visit_members(Results& results, Visit&& visit) {
    visit("wrinkle", results.version);
    visit("driver", results.driver);
    visit("command", results.command);
    visit("approval", results.approval);
    visit("started", results.started);
    visit("seconds", results.seconds);
    visit("added_fails", results.added_fails);
    visit("before", results.before);
    visit("after", results.after);
    visit("changes", results.changes);
    visit("problems", results.problems);
    visit("causes", results.causes);
    visit("checks", results.checks);
}

template <class T>
std::string object_text(const T& value);

std::string text_of(const std::string& text) {
    return json_quoted(text);
}
std::string text_of(uint32_t number) {
    return std::to_string(number);
}
std::string text_of(bool truth) {
    return truth ? "true" : "false";
}
std::string text_of(double number) {
    return std::isfinite(number) ? shortest(number) : "null";
}
std::string text_of(Status status) {
    return json_quoted(std::string(name_of(status)));
}
std::string text_of(CheckKind kind) {
    return json_quoted(std::string(name_of(kind)));
}
std::string text_of(const Measured& measured) {
    return object_text(measured);
}
std::string text_of(const Check& check) {
    return "\n" + object_text(check);
}
template <class T>
std::string text_of(const std::vector<T>& list) {
    return "[" + joined(list, ", ", [](const T& each) { return text_of(each); }) + "]";
}

template <class T>
std::string object_text(const T& value) {
    static const T defaults;
    std::string text;
    T members = value, standard = defaults;
    std::vector<std::string> standard_texts;
    visit_members(standard, [&](const char*, const auto& member) {
        standard_texts.push_back(text_of(member));
    });
    size_t i = 0;
    visit_members(members, [&](const char* name, const auto& member) {
        const std::string written = text_of(member);
        const std::string& usual = standard_texts[i++];
        if (written == usual && std::string_view(name) != "status") return;
        text += (text.empty() ? "\"" : ", \"") + std::string(name) + "\": " + written;
    });
    return "{" + text + "}";
}

// Reads the members of an object, with an error for each that is of another kind.
class Reader {
public:
    Reader(json::Value object, Diagnostics& diagnostics)
        : object_(std::move(object)), diagnostics_(diagnostics) {}

    template <class T>
    void operator()(const char* name, T& member) {
        const json::Value value = object_.find(name);
        if (object_.has(name) && !read(value, member))
            diagnostics_.add({RuleId::wrong_kind, Severity::error, value.location(),
                              value.pointer(), "", std::string(name) + " does not fit",
                              "a report of `wrinkle test`"});
    }

private:
    static bool read(const json::Value& value, std::string& text) {
        if (!value.is(json::Kind::string)) return false;
        text = value.as_string();
        return true;
    }
    static bool read(const json::Value& value, bool& truth) {
        if (!value.is(json::Kind::boolean)) return false;
        truth = value.as_boolean();
        return true;
    }
    static bool read(const json::Value& value, double& number) {
        number = std::numeric_limits<double>::quiet_NaN();
        if (value.is(json::Kind::number)) number = value.as_number();
        return value.is(json::Kind::number) || value.is(json::Kind::null);
    }
    static bool read(const json::Value& value, uint32_t& number) {
        if (!value.is(json::Kind::number)) return false;
        const double given = value.as_number();
        if (!(given >= 0 && given <= 0xffffffff && given == std::floor(given))) return false;
        number = static_cast<uint32_t>(given);
        return true;
    }
    template <class Names, class Enum>
    static bool read_name(const json::Value& value, const Names& names, Enum& result) {
        if (!value.is(json::Kind::string)) return false;
        const auto found = std::ranges::find(names, value.as_string());
        if (found == names.end()) return false;
        result = static_cast<Enum>(found - names.begin());
        return true;
    }
    static bool read(const json::Value& value, Status& status) {
        return read_name(value, status_names, status);
    }
    static bool read(const json::Value& value, CheckKind& kind) {
        return read_name(value, kind_names, kind);
    }
    template <class T>
    requires requires(T& each, Reader& reader) { visit_members(each, reader); }
    bool read(const json::Value& value, T& each) {
        if (!value.is(json::Kind::object)) return false;
        visit_members(each, Reader(value, diagnostics_));
        return true;
    }
    template <class T>
    bool read(const json::Value& value, std::vector<T>& list) {
        if (!value.is(json::Kind::array)) return false;
        for (const json::Member& member : value.children())
            if (!read(member.value, list.emplace_back())) return false;
        return true;
    }

    json::Value object_;
    Diagnostics& diagnostics_;
};

bool is_inside(const std::string& image) {
    const fs::path path(image);
    return !path.is_absolute() && std::ranges::find(path, "..") == path.end();
}

}  // namespace

std::string to_json(const Results& results) {
    return "{\"version\": " + std::to_string(version) + ", " + object_text(results).substr(1) +
           "\n";
}

std::optional<Results> read_results(const fs::path& file, Diagnostics& diagnostics) {
    std::string why;
    const auto text = read_file(file, why);
    Diagnostics own;
    Results results;
    if (!text) {
        own.add(file_problem(Severity::error, RuleId::file_unreadable, file.string(), why,
                             "a report of `wrinkle test`"));
    } else {
        const json::Value root = json::parse(*text, file.string(), own).root;
        const json::Value number =
            root.is(json::Kind::object) ? root.find("version") : json::Value();
        if (!number.is(json::Kind::number) || number.as_number() != version)
            own.add(file_problem(Severity::error, RuleId::wrong_file, file.string(),
                                 "is not a report of version 1", "results.json of `wrinkle test`"));
        else if (!own.has_errors())
            visit_members(results, Reader(root, own));
    }
    for (const Check& check : results.checks)
        for (const std::string& image :
             {check.expected_image, check.actual_image, check.map_image, check.joined_image})
            if (!is_inside(image))
                own.add(file_problem(Severity::error, RuleId::outside_root, file.string(),
                                     "names an image outside its folder: " + image, ""));
    diagnostics.append(own);
    if (own.has_errors()) return {};
    return results;
}

}  // namespace wrinkle::report
