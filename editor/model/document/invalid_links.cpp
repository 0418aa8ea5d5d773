#include "editor/model/document/invalid_links.h"

#include "editor/model/document/each_wire.h"
#include "editor/model/document/wiring.h"

namespace wrinkle::editor {

Document without_invalid_links(const Document& document, const std::set<std::string>& ids,
                               const std::filesystem::path& folder, const Registry& registry) {
    const Model model = make_model(document, folder, registry);
    Document result = document;
    each_wire(document, [&](const Connection& wire) {
        if (!ids.contains(wire.node) && !ids.contains(wire.from.node)) return;
        const auto given = model.type_of(wire.from);
        if (given && !converts(*given, wanted_at(model, wire.node, wire.port)))
            result = without_wire(result, wire.node, wire.port);
    });
    return result;
}

}  // namespace wrinkle::editor
