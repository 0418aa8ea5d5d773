// The document's text at the last journal record, stored as parts, so that computing the delta to
// the text of the next snapshot is proportional to the difference, not to the text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

class JournaledText {
public:
    JournaledText() = default;
    // Also returns the complete text in `text`.
    JournaledText(const Document& document, std::string& text);

    // Returns the text of another snapshot, and in `delta` the delta (text_delta.h) to it.
    JournaledText next(const Document& document, std::string& delta) const;

private:
    struct Lengths {
        size_t first = 0;  // offset of the first part
        std::vector<uint32_t> each;
    };
    class Step;

    Document document_;
    bool in_parts_ = false;  // false: the text is not canonical
    std::string head_, middle_, end_;
    Lengths nodes_, positions_;
};

}  // namespace wrinkle::editor
