#include "editor/view/canvas/card_names.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

constexpr float pad = 3;
constexpr size_t min_letters = 3;

// Coverage of the canvas, in cells of 2 x 2 screen pixels.
class Ground {
public:
    Ground(ImVec2 corner, ImVec2 extent)
        : corner_(corner),
          wide_(std::max(static_cast<int>(extent.x / side), 0)),
          tall_(std::max(static_cast<int>(extent.y / side), 0)),
          cells_(static_cast<size_t>(wide_) * static_cast<size_t>(tall_), free) {}

    void cover(ImVec2 low, ImVec2 high) {
        const Squares of = squares(low, high);
        const int x = std::max(of.x0, 0), count = std::min(of.x1, wide_ - 1) - x + 1;
        if (count <= 0) return;
        for (int y = std::max(of.y0, 0); y <= std::min(of.y1, tall_ - 1); ++y)
            std::fill_n(&cells_[index(x, y)], count, covered);
    }
    bool is_free(ImVec2 low, ImVec2 high) const {
        const Squares of = squares(low, high);
        if (of.x0 < 0 || of.y0 < 0 || of.x1 >= wide_ || of.y1 >= tall_) return false;
        const auto count = static_cast<size_t>(of.x1 - of.x0 + 1);
        for (int y = of.y0; y <= of.y1; ++y)
            if (std::memchr(&cells_[index(of.x0, y)], covered, count)) return false;
        return true;
    }

private:
    static constexpr float side = 2;
    static constexpr char free = 0, covered = 1;
    struct Squares {
        int x0, y0, x1, y1;
    };
    Squares squares(ImVec2 low, ImVec2 high) const {
        const auto square = [](float at) {
            return static_cast<int>(std::floor(std::clamp(at / side, -1e6F, 1e6F)));
        };
        const ImVec2 from = low - corner_, to = high - corner_;
        return {square(from.x), square(from.y), square(to.x), square(to.y)};
    }
    size_t index(int x, int y) const {
        return static_cast<size_t>(y) * static_cast<size_t>(wide_) + static_cast<size_t>(x);
    }

    ImVec2 corner_;
    int wide_, tall_;
    std::vector<char> cells_;
};

class Names {
public:
    explicit Names(const State& state)
        : state_(state),
          font_(state.fonts.regular(card_name_size)),
          ground_(state.view.corner, state.view.extent) {
        for (const Card& card : state.layout.cards)
            if (const Extent at = place_of(card); is_seen(at)) ground_.cover(at.low, at.high);
    }

    std::vector<CardName> find() {
        for (size_t i = state_.layout.cards.size(); i-- > 0;) {
            const Card& card = state_.layout.cards[i];
            const Extent at = place_of(card);
            if (card.reroute || !is_seen(at)) continue;
            const std::string& text = card.kind == Card::Kind::node ? card.id : card.name;
            const float width = text_width(font_, card_name_size, text);
            if (width + 2 * pad <= at.high.x - at.low.x && is_tall(at))
                add({i, text, false, false, at.low + ImVec2(pad, 1), {}}, width);
            else if (!put_beside(i, text, width, at) && is_tall(at))
                put_cut(i, text, at);
        }
        return std::move(names_);
    }

private:
    Extent place_of(const Card& card) const {
        const ImVec2 low = to_screen(state_.view, card.at);
        return {low, low + card.size * state_.view.zoom};
    }
    bool is_seen(const Extent& at) const {
        const ImVec2 low = state_.view.corner, high = low + state_.view.extent;
        return at.low.x < high.x && at.low.y < high.y && at.high.x > low.x && at.high.y > low.y;
    }
    static bool is_tall(const Extent& at) { return at.high.y - at.low.y >= card_name_size + 2; }

    void add(CardName name, float width) {
        name.high = name.low + ImVec2(width, card_name_size);
        names_.push_back(std::move(name));
    }
    bool put_beside(size_t card, const std::string& text, float width, const Extent& at) {
        const float middle = (at.low.y + at.high.y - card_name_size) / 2;
        const ImVec2 places[] = {{at.high.x + pad + 1, middle},
                                 {at.low.x, at.high.y + pad},
                                 {at.low.x, at.low.y - card_name_size - pad},
                                 {at.low.x - width - pad - 1, middle}};
        for (const ImVec2 low : places) {
            const ImVec2 high = low + ImVec2(width, card_name_size);
            if (!ground_.is_free(low, high)) continue;
            ground_.cover(low, high);
            add({card, text, false, true, low, {}}, width);
            return true;
        }
        return false;
    }
    void put_cut(size_t card, const std::string& text, const Extent& at) {
        const std::string cut =
            fitting(font_, card_name_size, text, at.high.x - at.low.x - 2 * pad);
        if (cut.size() < min_letters + 3) return;
        add({card, cut, true, false, at.low + ImVec2(pad, 1), {}},
            text_width(font_, card_name_size, cut));
    }

    const State& state_;
    ImFont* font_;
    Ground ground_;
    std::vector<CardName> names_;
};

}  // namespace

std::vector<CardName> card_names(const State& state) {
    if (state.view.zoom >= plain_zoom) return {};
    return Names(state).find();
}

}  // namespace wrinkle::editor
