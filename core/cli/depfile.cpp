#include "cli/depfile.h"
#include "cli/cli.h"

#include <set>
#include <string_view>

namespace wrinkle::cli {
namespace {

// tests/ninja checks every printable character with Make and Ninja.
constexpr std::string_view with_backslash = " #:";
constexpr std::string_view unreadable = "\"&'*;<=>?^`|";

std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : name) {
        if (with_backslash.find(c) != with_backslash.npos) text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
}

bool is_readable(std::string_view name, bool target) {
    for (size_t i = 0; i < name.size(); ++i) {
        const char c = name[i], next = i + 1 < name.size() ? name[i + 1] : ' ';
        const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
        if (control || unreadable.find(c) != unreadable.npos || (target && c == '%')) return false;
        if (c == '\\' &&
            (next == '\\' || next == '$' || with_backslash.find(next) != with_backslash.npos))
            return false;
    }
    return !name.empty() && name[0] != '~' && name.back() != ' ' && name.back() != ':';
}

std::string rule(const std::vector<std::string>& made, const std::vector<std::string>& from) {
    std::string text;
    for (const std::string& name : made)
        text += (text.empty() ? "" : " ") + escaped(name);
    text += ":";
    for (const std::string& name : from)
        text += " \\\n  " + escaped(name);
    return text + "\n";
}

}  // namespace

void declare_depfile(CLI::App& command, Depfile& depfile) {
    command.add_flag("--depfile", depfile.wanted, "-MD: also writes what the output depends on");
    command.add_option("--depfile-path", depfile.path, "-MF: where to")->type_name("FILE");
    command.add_option("--depfile-target", depfile.target, "-MT: the name of the output there")
        ->type_name("NAME");
    command.add_flag("--depfile-phony", depfile.phony,
                     "-MP: a target for each input, so that Make continues when one was removed");
}

std::string depfile_fault(const std::vector<Rule>& rules, const Depfile& depfile) {
    const auto check = [](const std::string& name, bool target) {
        if (is_readable(name, target)) return std::string();
        return "no dependency file can hold the name '" + name +
               "'; rename the file, or leave -MD out";
    };
    std::string why;
    if (!depfile.target.empty()) why = check(depfile.target, true);
    for (const Rule& each : rules) {
        for (const std::string& name : each.made)
            if (why.empty() && depfile.target.empty()) why = check(name, true);
        for (const std::string& name : each.from)
            if (why.empty()) why = check(name, depfile.phony);
    }
    return why;
}

std::string make_rules(const std::vector<Rule>& rules, const Depfile& depfile) {
    std::string text;
    std::vector<std::string> all;
    std::set<std::string> seen;
    for (const Rule& each : rules) {
        if (depfile.target.empty()) text += rule(each.made, each.from);
        for (const std::string& name : each.from)
            if (seen.insert(name).second) all.push_back(name);
    }
    if (!depfile.target.empty()) text = rule({depfile.target}, all);
    if (depfile.phony)
        for (const std::string& name : all)
            text += "\n" + rule({name}, {});
    return text;
}

}  // namespace wrinkle::cli
