#include "cost/counted_shader.h"

#include <cctype>
#include <set>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/text.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Calls use(word, index of its first character) for every word.
template <class Use>
void each_word(std::string_view line, Use use) {
    for (size_t at = 0; at < line.size();) {
        const size_t begin = at;
        while (at < line.size() && is_word(line[at]))
            ++at;
        if (at > begin)
            use(line.substr(begin, at - begin), begin);
        else
            ++at;
    }
}

// Returns NAME of a line that begins with "vec3 NAME(..."; "" for any other line.
std::string_view function_begun(std::string_view line) {
    const auto stop = [&](size_t at) {
        while (at < line.size() && is_word(line[at]))
            ++at;
        return at;
    };
    const size_t type = stop(0);
    if (type == 0 || type >= line.size() || line[type] != ' ') return {};
    const size_t end = stop(type + 1);
    const bool opens = end > type + 1 && end < line.size() && line[end] == '(';
    return opens ? line.substr(type + 1, end - type - 1) : std::string_view();
}

struct Helper {
    std::string_view name;
    size_t first = 0, last = 0;  // lines
    std::set<uint32_t> callers;  // nodes, also indirect ones
};

// Rewrites the source: after each helper function, adds a copy of it for each node that calls it.
class Copies {
public:
    explicit Copies(const Shader& shader)
        : lines_(split(shader.source, '\n')), nodes_(shader.reflection.lines) {
        nodes_.resize(lines_.size(), no_node);
        find_helpers();
        find_callers();
    }

    std::string text() const {
        std::string text;
        size_t line = 0;
        for (const Helper& helper : helpers_) {
            for (; line < helper.first; ++line)
                write(lines_[line], nodes_[line], text);
            for (size_t i = helper.first; i <= helper.last; ++i)
                write(lines_[i], no_node, text);
            for (const uint32_t node : helper.callers)
                for (size_t i = helper.first; i <= helper.last; ++i)
                    write(lines_[i], node, text);
            line = helper.last + 1;
        }
        for (; line < lines_.size(); ++line)
            write(lines_[line], nodes_[line], text);
        return text;
    }

private:
    // Returns false also for node 0, the graph itself.
    static bool has_node(uint32_t node) { return node != no_node && node != 0; }

    // A helper is a function without a line of any node.
    void find_helpers() {
        for (size_t i = 0; i < lines_.size(); ++i) {
            Helper helper{function_begun(lines_[i]), i, i, {}};
            if (helper.name.empty()) continue;
            bool owned = false;
            for (; i + 1 < lines_.size() && lines_[i] != "}"; ++i)
                owned = owned || has_node(nodes_[i]);
            helper.last = i;
            if (owned) continue;
            index_.emplace(helper.name, helpers_.size());
            helpers_.push_back(std::move(helper));
        }
    }

    // Functions are defined after their callees, so callers are propagated from last to first.
    void find_callers() {
        for (size_t i = 0; i < lines_.size(); ++i)
            if (has_node(nodes_[i])) add_callers(lines_[i], {nodes_[i]});
        for (size_t h = helpers_.size(); h-- > 0;)
            for (size_t i = helpers_[h].first + 1; i <= helpers_[h].last; ++i)
                add_callers(lines_[i], helpers_[h].callers);
    }

    void add_callers(std::string_view line, const std::set<uint32_t>& callers) {
        each_word(line, [&](std::string_view word, size_t) {
            const auto found = index_.find(word);
            if (found != index_.end())
                helpers_[found->second].callers.insert(callers.begin(), callers.end());
        });
    }

    // Writes a line after its #line directive. In lines of a node, suffixes helper names with
    // "__NODE", which is unique: no name of the source contains "__".
    void write(std::string_view line, uint32_t node, std::string& text) const {
        text += "#line " + std::to_string(has_node(node) ? node + 1 : 1) + "\n";
        size_t copied = 0;
        if (has_node(node))
            each_word(line, [&](std::string_view word, size_t begin) {
                if (!index_.contains(word)) return;
                const size_t end = begin + word.size();
                text += line.substr(copied, end - copied);
                text += "__" + std::to_string(node);
                copied = end;
            });
        text += line.substr(copied);
        text += '\n';
    }

    std::vector<std::string_view> lines_;
    std::vector<uint32_t> nodes_;  // by line
    std::vector<Helper> helpers_;
    std::unordered_map<std::string_view, size_t> index_;
};

}  // namespace

std::string counted_shader(const Shader& shader) {
    const Reflection& r = shader.reflection;
    std::string text = "#version 450\n", body;
    const auto place = [location = 0]() mutable {
        return "layout(location = " + std::to_string(location++) + ") ";
    };
    auto member_place = place, output_place = place;
    if (!r.struct_name.empty()) body = r.struct_name + " surface; ";
    for (const MemberInfo& member : r.members) {
        text += member_place() + "in " + std::string(info(member.type).name) + " counted_" +
                member.name + ";\n";
        body += "surface." + member.name + " = counted_" + member.name + "; ";
    }
    body += result_type(r) + " result = " + call_text(r, "surface") + "; ";
    for (size_t i = 0; i < r.outputs.size(); ++i) {
        const std::string name = "counted_" + std::to_string(i);
        text += output_place() + "out " + std::string(info(r.outputs[i].type).name) + " " + name +
                ";\n";
        body += name + " = " + output_text(r, r.outputs[i], "result") + "; ";
    }
    return text + Copies(shader).text() + "#line 1\nvoid main() { " + body + "}\n";
}

}  // namespace wrinkle
