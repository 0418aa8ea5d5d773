// wrinkle git-setup: makes Git show and merge graphs by node, in one repository.
#include <filesystem>

#include "base/file.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/git.h"
#include "cli/output.h"
#include "cli/session.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view block_begin = "# begin of wrinkle git-setup\n",
                           block_end = "# end of wrinkle git-setup\n";
constexpr std::array config_sections = {"diff.wrinkle", "merge.wrinkle", "merge.wrinkle-ancestor",
                                        "difftool.wrinkle"};

struct Setting {
    std::string key, value;
};

// Returns "wrinkle" if the shell finds this program by that name, else its path in quotes.
std::string program_word() {
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    const char* folders = std::getenv("PATH");
    for (const std::string_view folder : split(folders ? folders : "", ':')) {
        const fs::path found = fs::path(folder) / "wrinkle";
        if (!fs::exists(found, error)) continue;
        return real_path(found) == self ? "wrinkle" : shell_quoted(self.string());
    }
    return shell_quoted(self.string());
}

std::vector<Setting> settings(const std::string& program) {
    const std::string merge = program + " merge %O %A %B --marker-size %L --path %P";
    return {{"diff.wrinkle.textconv", program + " textconv"},
            {"merge.wrinkle.name", "graphs of Wrinkle by node"},
            {"merge.wrinkle.driver", merge},
            {"merge.wrinkle.recursive", "wrinkle-ancestor"},
            {"merge.wrinkle-ancestor.name", "common versions of graphs of Wrinkle"},
            {"merge.wrinkle-ancestor.driver", merge + " --ancestor"},
            {"difftool.wrinkle.cmd", program + " diff --exit-zero \"$LOCAL\" \"$REMOTE\""}};
}

// Returns the text without the block of this command; the other lines unchanged.
std::string without_block(std::string text) {
    const size_t begin = text.find(block_begin);
    if (begin == text.npos) return text;
    const size_t end = text.find(block_end, begin);
    text.erase(begin, end == text.npos ? end : end + block_end.size() - begin);
    return text;
}

struct GitSetupCommand {
    std::vector<std::string> patterns;
    std::string program;
    bool remove = false, show = false;

    int run() {
        if (remove && show) return fail(exit_usage, "--show and --remove exclude each other");
        for (const std::string& pattern : patterns)
            if (pattern.empty() || pattern.find_first_of(" \t\n\"") != pattern.npos)
                return fail(exit_usage,
                            "a pattern of .gitattributes has no spaces or quotes: " + pattern);
        if (patterns.empty()) patterns = {"*.json"};
        if (program.empty()) program = program_word();
        if (show) return write_result("-", shown());
        const GitResult top = run_git({"rev-parse", "--show-toplevel"});
        if (top.code != 0)
            return fail(exit_environment, top.code < 0 ? "git cannot be started"
                                                       : "this folder is not in a Git work tree");
        const fs::path folder(top.output.substr(0, top.output.find_last_not_of('\n') + 1));
        const int code = write_attributes(folder / ".gitattributes");
        if (code != exit_success) return code;
        return remove ? remove_config() : write_config();
    }

    std::string block() const {
        std::string text(block_begin);
        for (const std::string& pattern : patterns)
            text += pattern + " diff=wrinkle merge=wrinkle\n";
        return text + std::string(block_end);
    }

    std::string shown() const {
        std::string text =
            ".gitattributes, to be committed:\n" + block() + "git config, of this clone:\n";
        for (const auto& [key, value] : settings(program))
            text += key + " = " + value + "\n";
        return text;
    }

    int write_attributes(const fs::path& file) const {
        std::string old, why;
        std::error_code error;
        if (fs::exists(file, error)) {
            const auto text = read_file(file, why);
            if (!text) return fail(exit_environment, file.string() + ": " + why);
            old = *text;
        }
        std::string text = without_block(old);
        if (!text.empty() && !text.ends_with('\n') && !remove) text += '\n';
        if (!remove) text += block();
        if (text.empty() && remove && !old.empty()) {
            fs::remove(file, error);
            return error ? fail(exit_environment, file.string() + " cannot be removed")
                         : int{exit_success};
        }
        return text == old ? int{exit_success} : write_result(file.string(), text);
    }

    int write_config() const {
        for (const auto& [key, value] : settings(program))
            if (run_git({"config", "--local", key, value}).code != 0)
                return fail(exit_environment, "git config --local " + key + " failed");
        return write_result("-", shown());
    }

    static int remove_config() {
        for (const char* section : config_sections)
            run_git({"config", "--local", "--remove-section", section});  // fails if absent
        return write_result("-", "removed from .gitattributes and git config\n");
    }
};

}  // namespace

void declare_git_setup(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<GitSetupCommand>(
        app, run, "git-setup", "Makes Git show and merge graphs by node, in this repository");
    sub.footer(
        "It writes .gitattributes, which you commit, and the configuration of this clone, which "
        "every clone needs. Running it again changes nothing.");
    sub.add_option("PATTERN", c.patterns, "Files as in .gitattributes; default: *.json");
    sub.add_flag("--show", c.show, "Prints the lines and writes nothing");
    sub.add_flag("--remove", c.remove, "Removes the lines and the configuration");
    sub.add_option("--program", c.program,
                   "The command that Git starts; default: wrinkle, or the path of this program")
        ->type_name("COMMAND");
}

}  // namespace wrinkle::cli
