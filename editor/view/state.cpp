#include "editor/view/state.h"

#include "base/file.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

const Card* Layout::find(std::string_view id, Card::Kind kind) const {
    if (kind == Card::Kind::node) {
        const size_t index = nodes.index_of(id);
        return index < card_of_node.size() ? &cards[card_of_node[index]] : nullptr;
    }
    for (const Card& card : cards)
        if (card.kind == kind && card.id == id) return &card;
    return nullptr;
}

namespace {

fs::path folder_of(const fs::path& path, const fs::path& unsaved_folder) {
    return path.empty() ? real_path(unsaved_folder) : real_path(path).parent_path();
}

}  // namespace

fs::path State::folder() const {
    return folder_of(path, unsaved_folder);
}

fs::path State::root() const {
    return folder_of(outer.empty() ? path : outer.front().path, unsaved_folder);
}

std::string file_name_of(const fs::path& path) {
    return path.empty() ? "untitled.json" : path.filename().string();
}

std::string State::file_name() const {
    return file_name_of(path);
}

std::string State::title() const {
    return file_name() + (dirty() ? " *" : "") + " - Wrinkle";
}

const Costs* State::costs() const {
    if (follow.came < follow.first || !built.uniform) return nullptr;
    if (follow.is_counted()) return &follow.counted->costs;
    return built.costs ? &*built.costs : nullptr;
}

const Document& State::costs_of() const {
    return follow.is_counted() ? follow.counted->document : follow.built_of;
}

void State::commit(std::string name, Document document, const std::string& merge) {
    if (history.commit(name, std::move(document), merge)) status = std::move(name);
}

}  // namespace wrinkle::editor
