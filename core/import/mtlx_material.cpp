#include "import/mtlx_material.h"

#include <algorithm>
#include <map>

#include "base/text.h"
#include "import/mtlx_importer.h"
#include "import/mtlx_shader.h"

namespace wrinkle::materialx {
namespace {

// Elements that hold no part of a material.
constexpr std::array<std::string_view, 17> ignored = {
    "input",       "output",   "token",       "nodedef", "implementation", "typedef",
    "targetdef",   "unitdef",  "unittypedef", "look",    "lookgroup",      "collection",
    "propertyset", "geominfo", "geompropdef", "comment", "backdrop"};

class MaterialImport {
public:
    MaterialImport(const Document& document, const MaterialOptions& options,
                   Diagnostics& diagnostics)
        : document_(document),
          options_(options),
          diagnostics_(diagnostics),
          importer_(document, options.source, options.target, diagnostics) {}

    std::optional<MaterialGraph> run() {
        const size_t errors = diagnostics_.error_count();
        if (!check_version()) return {};
        const std::optional<uint32_t> material = choose();
        if (!material) return {};
        import(*material);
        report_rest();
        if (diagnostics_.error_count() > errors) return {};
        return MaterialGraph{importer_.graph().finish(document_[*material].name),
                             importer_.images()};
    }

private:
    // Up to 1.37 parameters were elements of their own.
    bool check_version() {
        const std::string_view version = document_[0].attribute("version");
        if (version == "1.38" || version == "1.39") return true;
        const bool is_newer = version > "1.39" && version.starts_with("1.");
        importer_.report(
            0, is_newer ? Severity::warning : Severity::error, RuleId::materialx_unsupported,
            "the document has the version '" + std::string(version) + "'", "1.38 or 1.39");
        return is_newer;
    }

    std::vector<uint32_t> elements_of(bool (*is_wanted)(std::string_view)) const {
        std::vector<uint32_t> found;
        for (const uint32_t child : document_[0].children)
            if (is_wanted(document_[child].category)) found.push_back(child);
        return found;
    }

    // A document without materials may have one surface shader.
    std::optional<uint32_t> choose() {
        auto found =
            elements_of([](std::string_view category) { return category == "surfacematerial"; });
        if (found.empty()) found = elements_of(is_shader);
        std::vector<std::string> names;
        for (const uint32_t element : found)
            names.push_back(document_[element].name);
        if (!options_.material.empty()) {
            const auto at = std::ranges::find(names, options_.material);
            if (at != names.end()) return found[static_cast<size_t>(at - names.begin())];
            return fail("has no material '" + options_.material + "'",
                        did_you_mean(options_.material, names, "one of " + joined(names, ", ")));
        }
        if (found.size() == 1) return found.front();
        if (found.empty())
            return fail("has no surfacematerial", "a material with a surface shader");
        return fail("has " + std::to_string(found.size()) + " materials",
                    "one of them as --material: " + joined(names, ", "));
    }

    std::optional<uint32_t> fail(std::string message, std::string expected) {
        importer_.report(0, Severity::error, RuleId::materialx_value, std::move(message),
                         std::move(expected));
        return {};
    }

    void import(uint32_t material) {
        const NodeKey key{0, material};
        if (is_shader(document_[material].category)) return import_shader(importer_, key);
        const Source surface = importer_.sources().input(key, "surfaceshader");
        if (surface.kind == Source::Kind::node)
            import_surface(surface);
        else if (surface.kind != Source::Kind::bad)
            importer_.report(material, Severity::error, RuleId::materialx_value,
                             "the material has no surface shader", "a surfaceshader");
        const Source displaced = importer_.sources().input(key, "displacementshader");
        if (displaced.kind == Source::Kind::node) import_displaced(displaced);
        if (importer_.sources().input(key, "backsurfaceshader").kind == Source::Kind::node)
            importer_.report(material, Severity::warning, RuleId::materialx_unsupported,
                             "the shader of back faces is left out");
    }

    void import_surface(const Source& surface) {
        const std::string& category = document_[surface.node.element].category;
        if (is_shader(category)) return import_shader(importer_, surface.node);
        importer_.report(surface.node.element, Severity::error, RuleId::materialx_unsupported,
                         "the surface shader '" + category + "' is not supported",
                         "standard_surface, gltf_pbr or open_pbr_surface");
    }

    void import_displaced(const Source& source) {
        const Element& node = document_[source.node.element];
        const uint32_t input = document_.child(source.node.element, "displacement");
        const bool is_vector =
            input != no_element && document_[input].attribute("type") == "vector3";
        if (node.category == "displacement" && !is_vector)
            return import_displacement(importer_, source.node);
        importer_.report(source.node.element, Severity::warning, RuleId::materialx_unsupported,
                         "the displacement by a vector is left out");
    }

    // Nodes of the root that no part of the material needs, and other elements by category.
    void report_rest() {
        std::map<std::string_view, size_t> counts;
        std::map<std::string_view, uint32_t> first;
        for (const uint32_t child : document_[0].children) {
            const Element& element = document_[child];
            const bool is_look = element.category == "look" || element.category == "lookgroup";
            if (std::ranges::find(ignored, element.category) != ignored.end() && !is_look) continue;
            if (!is_look &&
                (element.category == "nodegraph" || is_shader(element.category) ||
                 element.category == "surfacematerial" || element.category == "displacement" ||
                 importer_.is_built(child) || importer_.sources().is_used(child)))
                continue;
            first.try_emplace(element.category, child);
            ++counts[element.category];
        }
        for (const auto& [category, count] : counts)
            importer_.report(first[category], Severity::warning, RuleId::materialx_unsupported,
                             "the material does not use " + std::to_string(count) + " '" +
                                 std::string(category) + "', which is left out");
    }

    const Document& document_;
    const MaterialOptions& options_;
    Diagnostics& diagnostics_;
    Importer importer_;
};

}  // namespace

std::optional<MaterialGraph> material_graph(const Document& document,
                                            const MaterialOptions& options,
                                            Diagnostics& diagnostics) {
    return MaterialImport(document, options, diagnostics).run();
}

}  // namespace wrinkle::materialx
