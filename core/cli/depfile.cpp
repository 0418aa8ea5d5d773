#include "cli/depfile.h"

#include <set>

namespace wrinkle::cli {
namespace {

std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : name) {
        if (c == ' ' || c == '#' || c == '\\') text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
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
                     "-MP: a target for each input, so that Make goes on when one was removed");
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
