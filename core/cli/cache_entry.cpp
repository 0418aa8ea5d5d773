#include "cli/cache_entry.h"

#include <map>

#include "base/checksum.h"
#include "base/diagnostics.h"
#include "base/file.h"
#include "cli/arguments.h"
#include "cli/identity.h"
#include "graph/write.h"
#include "image/formats.h"
#include "lower/named_images.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using Fields = std::vector<std::string>;

void add_images(const Project& project, const Types& types, size_t file,
                std::map<fs::path, size_t>& known, Fields& fields) {
    for (const NamedImage& image : named_images(project, types, file)) {
        std::error_code error;
        const bool there = image.path && fs::is_regular_file(*image.path, error);
        const size_t number =
            there ? known.try_emplace(*image.path, known.size()).first->second : 0;
        fields.push_back(there ? "image " + std::to_string(number) : "no image");
        // A warning depends on them.
        if (there) fields.push_back(std::to_string(png_bits(*image.path)));
    }
}

// Returns false if the plugin of a node cannot be read.
bool add_plugins(const Project& project, const Types& types, size_t file,
                 std::map<std::string, std::string>& known, Fields& fields) {
    const auto& nodes = project.files[file].document.nodes;
    for (size_t i = 0; i < nodes.size(); ++i) {
        const NodeType* type = types.of(file, i);
        if (!type || !type->code || known.contains(type->origin)) continue;
        std::string why;
        const auto bytes = read_file(type->origin, why);
        if (!bytes) return false;
        known[type->origin] = sha256(*bytes);
        fields.push_back("plugin " + known[type->origin]);
    }
    return true;
}

void add_graph(const Project::File& file, Fields& fields) {
    // The default name of a sub-graph is its file name.
    fields.push_back(file.path.filename().string());
    fields.push_back(write_document(file.document));
    std::string used;
    for (const uint32_t subgraph : file.subgraphs)
        if (subgraph != Project::File::none) used += std::to_string(subgraph) + " ";
    fields.push_back(used);
}

// Number of fields per warning, in the order of add_warning(). Files of the project are stored by
// index, because paths depend on the location of the project.
constexpr size_t fields_of_warning = 8;

void add_warning(const Diagnostic& warning, const Project& project, Fields& fields) {
    std::string file = "=" + warning.where.file;  // not a file of the project
    for (size_t i = project.files.size(); i-- > 0;)
        if (project.files[i].document.file == warning.where.file) file = std::to_string(i);
    fields.insert(fields.end(),
                  {file, std::to_string(warning.where.line), std::to_string(warning.where.column),
                   warning.pointer, warning.node, warning.message, warning.expected,
                   std::to_string(static_cast<int>(warning.rule))});
}

Diagnostic warning_of(const std::string* fields, const Project& project) {
    Location where;
    size_t file = 0;
    if (fields[0].starts_with('='))
        where.file = fields[0].substr(1);
    else if (parse_number(fields[0], file) && file < project.files.size())
        where.file = project.files[file].document.file;
    parse_number(fields[1], where.line);
    parse_number(fields[2], where.column);
    size_t rule = 0;
    parse_number(fields[7], rule);  // numbered as in this program: its identity is in the key
    return {static_cast<RuleId>(rule),
            Severity::warning,
            where,
            fields[3],
            fields[4],
            fields[5],
            fields[6]};
}

}  // namespace

std::string cache_key(const Project& project, const Types& types, const std::string& name,
                      const Compilation& with) {
    const TextOptions& options = with.options;
    const std::string identity =
        program_identity() + (needs_compilers(options) ? loaded_identity() : "");
    Fields fields = {identity,
                     options.target,
                     options.form,
                     options.params,
                     options.srgb,
                     options.uv_origin,
                     options.normal_space,
                     options.differentials,
                     name,
                     with.common.no_tangents ? "derived" : "vertex",
                     std::to_string(options.set),
                     std::to_string(options.first_binding),
                     options.strict ? "strict" : "lenient",
                     !options.cost  ? "no cost"
                     : options.json ? "cost as JSON"
                                    : "cost",
                     options.reflects ? "reflection" : "no reflection"};
    for (const std::string& output : options.outputs)
        fields.push_back("output " + output);
    for (const std::string& preset : with.overrides.presets)
        fields.push_back("preset " + preset);
    for (const Override& each : with.overrides.list)
        fields.push_back("set " + each.text);
    std::map<fs::path, size_t> images;
    std::map<std::string, std::string> plugins;
    for (size_t i = 0; i < project.files.size(); ++i) {
        add_graph(project.files[i], fields);
        add_images(project, types, i, images, fields);
        if (!add_plugins(project, types, i, plugins, fields)) return {};
    }
    return identity.empty() ? std::string() : sha256(join_fields(fields));
}

bool take_entry(const Compilation& with, const std::string& key, const Project& project,
                CompiledGraph& result) {
    const auto bytes = with.cache->find(key);
    const auto fields = bytes ? split_fields(*bytes) : std::nullopt;
    std::vector<Text> texts = blank_texts(with.options);
    const size_t before_warnings = 2 + texts.size();
    if (!fields || fields->size() < before_warnings ||
        (fields->size() - before_warnings) % fields_of_warning != 0)
        return false;
    const std::string* at = fields->data();
    result.reflection = *at++;
    result.cost = *at++;
    for (Text& text : texts)
        text.bytes = *at++;
    result.texts = std::move(texts);
    result.diagnostics = Diagnostics();
    for (; at != fields->data() + fields->size(); at += fields_of_warning)
        result.diagnostics.add(warning_of(at, project));
    return true;
}

void store_entry(const Compilation& with, const std::string& key, const Project& project,
                 CompiledGraph& result) {
    if (result.diagnostics.dropped() > 0) return;
    Fields fields = {result.reflection, result.cost};
    for (const Text& text : result.texts)
        fields.push_back(text.bytes);
    for (const Diagnostic& warning : result.diagnostics.list())
        add_warning(warning, project, fields);
    std::string why;
    if (with.cache->store(key, join_fields(fields), why)) return;
    result.diagnostics.add(file_problem(Severity::warning, RuleId::cache, "",
                                        "the cache cannot be written: " + why, ""));
}

}  // namespace wrinkle::cli
