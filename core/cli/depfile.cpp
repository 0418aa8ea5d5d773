#include "cli/depfile.h"

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

}  // namespace

void declare_depfile(CLI::App& command, Depfile& depfile) {
    command.add_flag("--depfile", depfile.wanted, "-MD: also writes what the output depends on");
    command.add_option("--depfile-path", depfile.path, "-MF: where to")->type_name("FILE");
    command.add_option("--depfile-target", depfile.target, "-MT: the name of the output there")
        ->type_name("NAME");
}

std::string make_rule(const std::vector<std::string>& made,
                      const std::vector<std::filesystem::path>& from) {
    std::string text;
    for (const std::string& name : made)
        text += (text.empty() ? "" : " ") + escaped(name);
    text += ":";
    for (const std::filesystem::path& path : from)
        text += " \\\n  " + escaped(path.string());
    return text + "\n";
}

}  // namespace wrinkle::cli
