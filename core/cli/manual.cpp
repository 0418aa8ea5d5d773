// wrinkle man [COMMAND]: prints manual pages in roff (man(7)), made from the declared commands.
#include <algorithm>
#include <filesystem>

#include "base/limits.h"
#include "base/text.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "cli/texts.h"

namespace wrinkle::cli {
namespace {

// Escapes text for roff: backslashes, hyphens (so that they can be copied), and a leading . or ',
// which would start a request.
std::string plain(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c == '\n' ? ' ' : c;
    }
    return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string upper(std::string text) {
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

std::string head(const std::string& name, const std::string& summary) {
    return ".TH " + upper(plain(name)) +
           " 1 \"\" \"Wrinkle " WRINKLE_VERSION "\" \"User Commands\"\n.SH NAME\n" + plain(name) +
           " \\- " + plain(summary) + "\n";
}

// Value name of an option: the choices joined by |, or the type name without its validator.
std::string value_of(const CLI::Option& option) {
    std::string names = choices_of(option);
    std::ranges::replace(names, ',', '|');
    const std::string type = option.get_type_name();
    return names.empty() ? type.substr(0, type.find(':')) : names;
}

// Names and value of an option. The compiler-style flags (-MD and so on) are not listed here: the
// description of their option begins with them.
std::string term(const CLI::Option& option) {
    const std::string names =
        joined(split(option.get_name(false, true), ','), ", ",
               [](std::string_view name) { return "\\fB" + plain(name) + "\\fR"; });
    const std::string value = option.get_items_expected_max() > 0 ? value_of(option) : "";
    return names + (value.empty() ? "" : " \\fI" + plain(value) + "\\fR");
}

std::string entry(const std::string& term, std::string text) {
    if (!text.empty() && !text.ends_with('.')) text += '.';
    return ".TP\n" + term + "\n" + plain(text) + "\n";
}

std::string options_of(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional() || option->get_group().empty()) continue;
        std::string doc = option->get_description();
        if (const std::string value = option->get_default_str(); !value.empty())
            doc += "; default: " + value;
        text += entry(term(*option), doc);
    }
    for (const CLI::App* group : app.get_subcommands({}))
        if (group->get_name().empty()) text += options_of(*group);
    return text;
}

std::string arguments_of(const CLI::App& command) {
    std::string text;
    for (const CLI::Option* option : command.get_options())
        if (option->get_positional())
            text += entry("\\fI" + plain(option->get_name()) + "\\fR", option->get_description());
    return text;
}

std::string synopsis_of(const CLI::App& command) {
    std::string text = ".B " + plain("wrinkle " + command.get_name()) + "\n[\\fIOPTION\\fR]...";
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_positional()) continue;
        const std::string dots = option->get_items_expected_max() > 1 ? "..." : "";
        const std::string name = "\\fI" + plain(option->get_name()) + "\\fR" + dots;
        text += option->get_required() ? " " + name : " [" + name + "]";
    }
    return text + "\n";
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

std::string environment() {
    std::string text = ".SH ENVIRONMENT\nLimits of sizes, each a whole number from 1.\n";
    for (const LimitRow& row : limit_rows)
        text += entry("\\fB" + std::string(row.variable) + "\\fR",
                      std::string(row.doc) + "; default: " + std::to_string(row.default_value) +
                          " " + std::string(row.unit));
    return text;
}

std::string manual_page(const CLI::App& app) {
    std::string text = head("wrinkle", app.get_description()) +
                       ".SH SYNOPSIS\n.B wrinkle\n\\fICOMMAND\\fR [\\fIOPTION\\fR]... "
                       "[\\fIFILE\\fR]...\n.SH COMMANDS\n";
    std::string pages;
    for (const CLI::App* command : commands_of(app)) {
        text += entry("\\fB" + plain(command->get_name()) + "\\fR", command->get_description());
        pages += (pages.empty() ? "" : " ,\n") +
                 (".BR wrinkle\\-" + plain(command->get_name()) + " (1)");
    }
    return text +
           ".SH ARGUMENTS\n"
           ".TP\n\\fB@\\fR\\fIFILE\\fR\nStands for the words that a file holds, with '...' and "
           "\"...\" round those with white space.\n"
           ".TP\n\\fB\\-\\fR\nIn place of a file is standard input or standard output.\n"
           ".SH OPTIONS\n" +
           options_of(app) + environment() + std::string(texts::exit_status_roff) +
           ".SH SEE ALSO\n" + pages + "\n";
}

std::string manual_page(const CLI::App& app, const CLI::App& command) {
    std::string text = head("wrinkle-" + command.get_name(), command.get_description()) +
                       ".SH SYNOPSIS\n" + synopsis_of(command);
    if (const std::string arguments = arguments_of(command); !arguments.empty())
        text += ".SH ARGUMENTS\n" + arguments;
    return text + ".SH OPTIONS\n" + options_of(command) + std::string(texts::exit_status_roff) +
           ".SH SEE ALSO\n.BR " + plain(app.get_name()) + " (1)\n";
}

struct ManCommand {
    const CLI::App* app = nullptr;
    std::string name, folder;

    int run() const {
        const auto commands = commands_of(*app);
        if (!folder.empty()) return write_all(commands);
        if (name.empty()) return write_result("-", manual_page(*app));
        const auto found = std::ranges::find(commands, name, &CLI::App::get_name);
        if (found == commands.end())
            return fail(exit_usage,
                        "there is no command '" + name + "'; wrinkle --help lists them");
        return write_result("-", manual_page(*app, **found));
    }

    int write_all(const std::vector<const CLI::App*>& commands) const {
        std::vector<Result> pages = {{folder + "/wrinkle.1", manual_page(*app)}};
        for (const CLI::App* command : commands)
            pages.push_back(
                {folder + "/wrinkle-" + command->get_name() + ".1", manual_page(*app, *command)});
        std::error_code ignored;  // write_results() reports the error
        std::filesystem::create_directories(folder, ignored);
        return write_results(pages);
    }
};

}  // namespace

void declare_man(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<ManCommand>(app, run, "man", "A manual page, in roff");
    c.app = &app;
    sub.group("");
    sub.add_option("COMMAND", c.name, "A command; default: the program");
    sub.add_option("--folder", c.folder, "Writes all pages into this folder")->type_name("DIR");
}

}  // namespace wrinkle::cli
