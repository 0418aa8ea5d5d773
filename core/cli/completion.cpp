// wrinkle completion SHELL: prints a script that calls `wrinkle complete -- WORD...`. Candidates
// are made from the declared commands, the existing files and the nodes of the plugins that would
// be found.
#include <filesystem>
#include <set>
#include <span>

#include "base/text.h"
#include "cli/cli.h"
#include "cli/meshes.h"
#include "cli/output.h"
#include "cli/session.h"
#include "cli/texts.h"
#include "emit/target.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

// Candidates, sorted.
using Found = std::set<std::string>;

bool takes_value(const CLI::Option& option) {
    return option.get_items_expected_max() > 0;
}

// Adds the folders and the files with suffix `end` that begin with `typed`.
void offer_files(const std::string& typed, std::string_view end, Found& found) {
    const size_t slash = typed.rfind('/');
    const std::string folder = slash == typed.npos ? "" : typed.substr(0, slash + 1);
    const std::string begin = typed.substr(folder.size());
    std::error_code error;
    fs::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(begin) || (begin.empty() && name[0] == '.')) continue;
        std::error_code ignored;
        if (entry->is_directory(ignored))
            found.insert(folder + name + "/");
        else if (!end.empty() && name.ends_with(end))
            found.insert(folder + name);
    }
}

// Incomplete command line.
class Line {
public:
    Line(const CLI::App& app, std::span<const std::string> words) : app_(app), words_(words) {}

    Found found() {
        if (words_.empty()) return {};
        std::string typed = words_.back(), before;
        read_words();
        // A shell may split --option=value into three words.
        if (typed == "=" && awaits_) typed.clear();
        if (const size_t equals = typed.find('=');
            !awaits_ && typed.starts_with("--") && equals != typed.npos) {
            awaits_ = option_named(typed.substr(0, equals));
            if (!awaits_) return {};
            before = typed.substr(0, equals + 1);
            typed.erase(0, equals + 1);
        }
        if (awaits_)
            offer_values(*awaits_, typed);
        else if (typed.starts_with('-'))
            offer_options();
        else
            offer_positional(typed);
        Found fitting;
        for (const std::string& each : found_)
            if (each.starts_with(typed)) fitting.insert(before + each);
        return fitting;
    }

private:
    void read_words() {
        for (const std::string& word : words_.first(words_.size() - 1)) {
            if (word == "=" && awaits_) continue;
            if (awaits_) {
                if (awaits_->check_lname("plugin-path")) plugin_paths_.push_back(word);
                awaits_ = nullptr;
            } else if (word.starts_with('-') && word != "-") {
                const CLI::Option* option = option_named(word);
                if (option && takes_value(*option)) awaits_ = option;
            } else if (!command_ || runs_another()) {
                command_ = command_named(word);
            } else {
                ++positionals_;
            }
        }
    }

    // The words after `watch COMMAND` are those of COMMAND.
    bool runs_another() const { return command_ && command_->get_name() == "watch"; }
    const CLI::App* command_named(const std::string& word) const {
        const auto named = [&](const CLI::App* sub) { return sub->get_name() == word; };
        const auto found = app_.get_subcommands(named);
        return found.empty() ? nullptr : found.front();
    }
    const CLI::App& current() const { return command_ ? *command_ : app_; }
    const CLI::Option* option_named(const std::string& word) const {
        return current().get_option_no_throw(word);
    }

    void offer_options() {
        for (const CLI::Option* option : current().get_options()) {
            const std::string names = option->get_positional() ? "" : option->get_name(false, true);
            for (const std::string_view name : split(names, ','))
                found_.emplace(name);
        }
    }

    void offer_positional(const std::string& typed) {
        if (!command_) {
            for (const CLI::App* sub : app_.get_subcommands({}))
                if (!sub->get_group().empty()) found_.insert(sub->get_name());
            return;
        }
        std::vector<const CLI::Option*> positionals;
        for (const CLI::Option* option : command_->get_options())
            if (option->get_positional()) positionals.push_back(option);
        if (!positionals.empty())
            offer_values(*positionals[std::min(positionals_, positionals.size() - 1)], typed);
    }

    // Offers the names listed by the option's validator, else candidates by its type name.
    void offer_values(const CLI::Option& option, const std::string& typed) {
        const std::string kind = option.get_positional() ? option.get_name() : type_of(option);
        if (const std::string names = choices_of(option); !names.empty()) {
            for (const std::string_view name : split(names, ','))
                found_.emplace(name);
        } else if (option.check_lname("target")) {
            for (const Target& target : targets())
                found_.emplace(target.name);
        } else if (kind == "ID") {
            Diagnostics ignored;
            CommonOptions options;
            options.plugin_paths = plugin_paths_;
            for (const std::string& id : load_nodes(options, ignored).registry.ids())
                found_.insert(id);
        } else if (kind == "DIR") {
            offer_files(typed, option.check_lname("plugin-path") ? ".so" : "", found_);
        } else if (kind == "FILE.so") {
            offer_files(typed, ".so", found_);
        } else if (kind == "NAME|PATH") {
            for (const std::string& shape : shape_names())
                found_.insert(shape);
            for (const char* end : {".obj", ".glb", ".gltf"})
                offer_files(typed, end, found_);
        } else if (option.get_positional() &&
                   (kind == "FILE" || kind == "GRAPH" || kind == "PATH" || kind == "BEFORE" ||
                    kind == "AFTER" || kind == "BASE" || kind == "OURS" || kind == "THEIRS")) {
            offer_files(typed, kind == "PATH" ? ".test.json" : ".json", found_);
        }
    }

    static std::string type_of(const CLI::Option& option) {
        const std::string type = option.get_type_name();
        return type.substr(0, type.find(':'));
    }

    const CLI::App& app_;
    std::span<const std::string> words_;
    const CLI::App* command_ = nullptr;
    const CLI::Option* awaits_ = nullptr;  // option with the value being typed
    size_t positionals_ = 0;               // positional words before the typed one
    std::vector<std::string> plugin_paths_;
    Found found_;
};

std::string_view script_of(std::string_view shell) {
    return shell == "bash"  ? texts::completion_bash
           : shell == "zsh" ? texts::completion_zsh
                            : texts::completion_fish;
}

struct CompletionCommand {
    std::string shell;

    int run() const { return write_result("-", std::string(script_of(shell))); }
};

// Prints candidates for the last of `words`, which is being typed and may be "". Folders end with
// '/'. If nothing is printed, the shell offers file names.
struct CompleteCommand {
    const CLI::App* app = nullptr;
    std::vector<std::string> words;  // without the program's name

    int run() const {
        std::string text;
        for (const std::string& each : Line(*app, words).found())
            text += each + "\n";
        return write_result("-", std::move(text));
    }
};

}  // namespace

void declare_completion(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<CompletionCommand>(
        app, run, "completion", "A script that lets a shell complete these commands");
    add_choice(sub, "SHELL", c.shell, {"bash", "zsh", "fish"}, "The shell")->required();
    auto [complete, command] =
        add_command<CompleteCommand>(app, run, "complete", "Words to complete after WORD...");
    command.app = &app;
    complete.group("");
    complete.add_option("WORD", command.words, "After the program's name, the last being typed");
}

}  // namespace wrinkle::cli
