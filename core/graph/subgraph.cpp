#include "graph/subgraph.h"

#include <map>

#include "base/file.h"
#include "base/text.h"
#include "graph/depth_first.h"
#include "graph/named_files.h"
#include "graph/renamed.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

using File = Project::File;

class Loader {
public:
    Loader(Project& project, const ProjectOptions& options, Diagnostics& diagnostics)
        : project_(project), limits_(options.limits), diagnostics_(diagnostics) {}

    // Breadth first: files are appended while the loop runs.
    void run() {
        for (size_t f = 0; f < project_.files.size(); ++f)
            read_subgraphs(f);
        check_uses();
        for (File& file : project_.files)
            use_current_names(file);
    }

private:
    // Ports of sub-graph nodes get the current names of the inputs.
    void use_current_names(File& file) {
        const Table<NodePtr>& nodes = file.document.nodes;
        std::vector<NodePtr> changed;  // empty: none so far
        for (size_t n = 0; n < nodes.size(); ++n) {
            if (file.subgraphs[n] == File::none) continue;
            NodePtr node = with_current_names(nodes[n], names_of(file.subgraphs[n]));
            if (node == nodes[n]) continue;
            if (changed.empty()) changed.assign(nodes.begin(), nodes.end());
            changed[n] = std::move(node);
        }
        if (!changed.empty()) file.document.nodes = nodes.with_same_keys(std::move(changed));
    }

    const FormerNames& names_of(uint32_t f) {
        return names_.try_emplace(f, project_.files[f].document.inputs).first->second;
    }

    void read_subgraphs(size_t f) {
        const Table<NodePtr> nodes = project_.files[f].document.nodes;
        std::vector<uint32_t> subgraphs(nodes.size(), File::none);
        for (size_t n = 0; n < nodes.size(); ++n)
            if (const auto name = nodes[n]->subgraph())
                subgraphs[n] = find_or_read(f, *nodes[n], *name);
        project_.files[f].subgraphs = std::move(subgraphs);
    }

    uint32_t find_or_read(size_t f, const Node& node, std::string_view name) {
        const Document& document = project_.files[f].document;  // valid until a file is added
        const auto fail = [&](RuleId rule, const std::string& what, std::string expected) {
            diagnostics_.add(diagnose(document, node, rule,
                                      "sub-graph " + json_quoted(name) + " " + what,
                                      std::move(expected)));
            return File::none;
        };
        if (name.empty())
            return fail(RuleId::subgraph_unreadable, "names no file",
                        "expected \"graph:FILE.json\"");
        const auto& path = named_.find(f, name).path;
        if (!path)
            return fail(RuleId::outside_root, "is outside the root " + project_.root.string(),
                        "keep it below the root, or choose another with --root");
        if (known_.empty()) known_[project_.files[0].path] = 0;
        if (const auto known = known_.find(*path); known != known_.end()) return known->second;
        std::string why;
        auto bytes = read_file(*path, why);
        if (!bytes) return fail(RuleId::subgraph_unreadable, why, "expected a graph file");
        const fs::path folder = fs::path(document.file).parent_path();  // as in diagnostics
        return add(*path, (folder / name).lexically_normal().string(), std::move(*bytes));
    }

    uint32_t add(const fs::path& path, std::string name, std::string bytes) {
        ReadLimits limits = limits_;
        for (const File& file : project_.files)
            limits.nodes_before += static_cast<uint32_t>(file.document.nodes.size());
        File file;
        file.path = path;
        file.document = read_document(std::move(bytes), std::move(name), diagnostics_, limits);
        const auto index = static_cast<uint32_t>(project_.files.size());
        project_.files.push_back(std::move(file));
        known_[path] = index;
        return index;
    }

    // Reports each node that closes a cycle of files and removes its sub-graph.
    void check_uses() {
        DepthFirst walk(project_.files.size());
        const auto uses = [&](uint32_t file) { return project_.files[file].subgraphs.size(); };
        const auto used = [&](uint32_t file, uint32_t node) {
            return project_.files[file].subgraphs[node];
        };
        walk.visit(0, uses, used, [&](uint32_t file, uint32_t node, uint32_t target) {
            report_cycle(project_.files[file], node, walk.path(), target);
            project_.files[file].subgraphs[node] = File::none;
        });
    }

    void report_cycle(const File& file, size_t node, const std::vector<DepthFirst::Frame>& path,
                      uint32_t target) {
        std::string text = "the sub-graph contains itself: ";
        bool on_cycle = false;
        for (const DepthFirst::Frame& frame : path) {
            on_cycle = on_cycle || frame.node == target;
            if (on_cycle) text += project_.files[frame.node].document.file + " uses ";
        }
        text += project_.files[target].document.file;
        diagnostics_.add(diagnose(file.document, *file.document.nodes[node], RuleId::subgraph_cycle,
                                  std::move(text), "remove one of these nodes"));
    }

    Project& project_;
    ReadLimits limits_;
    Diagnostics& diagnostics_;
    NamedFiles named_{project_};
    std::map<fs::path, uint32_t> known_;
    std::map<uint32_t, FormerNames> names_;  // by file
};

}  // namespace

const File* Project::subgraph(size_t file, std::string_view node) const {
    const File& from = files[file];
    const size_t i = from.document.nodes.index_of(node);
    if (i == Table<NodePtr>::npos || from.subgraphs[i] == File::none) return nullptr;
    return &files[from.subgraphs[i]];
}

Project load_project(const fs::path& file, const ProjectOptions& options,
                     Diagnostics& diagnostics) {
    Document top;
    top.file = file.string();
    std::string why;
    if (auto bytes = read_file(file, why))
        top = read_document(std::move(*bytes), file.string(), diagnostics, options.limits);
    else
        diagnostics.add(diagnose(top, RuleId::file_unreadable, why));
    return load_project(std::move(top), file.parent_path(), options, diagnostics);
}

Project load_project(Document top, const fs::path& folder, const ProjectOptions& options,
                     Diagnostics& diagnostics) {
    const std::string here = folder.empty() ? "." : folder.native();
    const std::string name = top.file.substr(top.file.rfind('/') + 1);
    Project project;
    File& file = project.files.emplace_back();
    // Without a name real_path() would give the folder, and its parent would become the root.
    file.path = name.empty() ? real_path(here) / "" : real_path(here + '/' + name);
    file.document = std::move(top);
    project.root = options.root.empty() ? file.path.parent_path() : real_path(options.root);
    Loader(project, options, diagnostics).run();
    return project;
}

std::optional<fs::path> resolve_file(const Project& project, size_t file, std::string_view name) {
    if (name.find('\0') != name.npos) return {};
    const std::string_view path = project.files[file].path.native();
    return inside(project.root, fs::path(path.substr(0, path.rfind('/') + 1)) / name);
}

}  // namespace wrinkle
