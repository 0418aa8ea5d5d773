// The text of a document as it was kept last, known by its parts, so that the delta to the text of
// the next snapshot costs what differs between the two and not what there is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

class KeptText {
public:
    KeptText() = default;
    // Gives the whole text too.
    KeptText(const Document& document, std::string& text);

    // That of another snapshot, and the delta (text_delta.h) that leads there.
    KeptText next(const Document& document, std::string& delta) const;

private:
    struct Lengths {
        size_t first = 0;  // where the first one begins
        std::vector<uint32_t> each;
    };
    class Step;

    Document document_;
    bool in_parts_ = false;  // false: the text is not canonical
    std::string head_, middle_, end_;
    Lengths nodes_, positions_;
};

}  // namespace wrinkle::editor
