#include "editor/model/document/journaled_text.h"

#include "editor/model/document/text_delta.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace {

// A text read from a file is not canonical, and may lack a node.
bool is_in_parts(const Document& document) {
    return (document.edited || !document.source.has_location()) &&
           CanonicalParts{document}.has_node_parts();
}

bool same_part(const NodePtr& a, const NodePtr& b) {
    return a == b;
}
bool same_part(const Position& a, const Position& b) {
    return a.x == b.x && a.y == b.y && a.source.same(b.source) && a.id == b.id;
}
std::string part_of(const NodePtr& node, bool first) {
    return CanonicalParts::node(*node, first);
}
std::string part_of(const Position& position, bool first) {
    return CanonicalParts::position(position, first);
}

}  // namespace

// Computes the next text and the delta to it, part by part.
class JournaledText::Step {
public:
    explicit Step(const JournaledText& before) : before_(before) {}

    JournaledText run(const Document& document) {
        JournaledText after;
        after.document_ = document;
        after.in_parts_ = true;
        const CanonicalParts parts{document};
        const JournaledText& b = before_;
        after.head_ = part(parts.head(), b.head_, 0);
        after.nodes_ = entries(document.nodes, b.document_.nodes, b.nodes_);
        const size_t middle = end_of(b.nodes_);
        after.middle_ = part(parts.middle(at_ == 1), b.middle_, middle);
        after.positions_ = entries(document.positions, b.document_.positions, b.positions_);
        after.end_ = part(parts.end(at_ == 1), b.end_, end_of(b.positions_));
        return after;
    }
    std::string take() { return writer_.take(); }

private:
    static size_t end_of(const Lengths& lengths) {
        size_t end = lengths.first;
        for (const uint32_t length : lengths.each)
            end += length;
        return end;
    }

    std::string part(std::string text, const std::string& before, size_t offset) {
        if (text == before)
            writer_.copy(offset, text.size());
        else
            writer_.add(text);
        at_ += text.size();
        return text;
    }

    // Copies unchanged entries; entries that were moved in the table are written again.
    template <class T>
    Lengths entries(const Table<T>& after, const Table<T>& before, const Lengths& old) {
        Lengths lengths{at_, {}};
        if (after.same(before)) {
            const size_t length = end_of(old) - old.first;
            writer_.copy(old.first, length);
            at_ += length;
            lengths.each = old.each;
            return lengths;
        }
        lengths.each.reserve(after.size());
        size_t i = 0, offset = old.first;
        const auto pass = [&] { offset += old.each[i++]; };
        for (size_t k = 0; k < after.size(); ++k) {
            const auto differs = [&] { return !same_part(before[i], after[k]); };
            while (i < before.size() && differs() && !after.find(table_key(before[i])))
                pass();
            const bool old_is_here = i < before.size() && (!differs() || is_old(before, after[k]));
            if (old_is_here && !differs() && (i == 0) == (k == 0)) {
                writer_.copy(offset, old.each[i]);
                lengths.each.push_back(old.each[i]);
            } else {
                const std::string text = part_of(after[k], k == 0);
                writer_.add(text);
                lengths.each.push_back(static_cast<uint32_t>(text.size()));
            }
            at_ += lengths.each.back();
            if (old_is_here) pass();
        }
        return lengths;
    }
    template <class T>
    static bool is_old(const Table<T>& before, const T& entry) {
        return before.find(table_key(entry)) != nullptr;
    }

    const JournaledText& before_;
    DeltaWriter writer_;
    size_t at_ = 0;  // offset in the new text
};

JournaledText::JournaledText(const Document& document, std::string& text) {
    if (!is_in_parts(document)) {
        document_ = document;
        text = write_document(document);
        return;
    }
    const JournaledText nothing;
    Step step(nothing);
    *this = step.run(document);
    text = apply_text_delta({}, step.take()).value_or("");
}

JournaledText JournaledText::next(const Document& document, std::string& delta) const {
    if (in_parts_ && is_in_parts(document)) {
        Step step(*this);
        JournaledText after = step.run(document);
        delta = step.take();
        return after;
    }
    std::string text;
    JournaledText after(document, text);
    delta = text_delta(write_document(document_), text);
    return after;
}

}  // namespace wrinkle::editor
