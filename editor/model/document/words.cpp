#include "editor/model/document/words.h"

namespace wrinkle::editor {

std::string nodes_in_words(size_t count) {
    return count == 1 ? "1 node" : std::to_string(count) + " nodes";
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
    return text;
}

}  // namespace wrinkle::editor
