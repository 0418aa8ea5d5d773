// Tests of drags of one number of a vector and of all.
#include "editor/model/document/field.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

class VectorDrag : public Headless {
protected:
    void SetUp() override {
        open(R"({"wrinkle": 1, "nodes": {"tile": {"type": "uv_transform", "in": {
            "scale": [2, 4], "offset": [0, 0.5]}}}, "outputs": {}, "layout": {"tile": [0, 0]}})");
        frame();
    }
    std::array<double, 4> numbers(const char* port) const {
        return numbers_at(*state.document().find("tile"), *input_port(state.type_of("tile"), port));
    }
};

TEST_F(VectorDrag, ChangesOneNumber) {
    play("stroke - left field:tile.scale.0 field:tile.scale.0+20,0 field:tile.scale.0+40,0");
    EXPECT_GT(numbers("scale")[0], 2);
    EXPECT_EQ(numbers("scale")[1], 4);
}

TEST_F(VectorDrag, ScalesAllWithCtrlAndShiftInOneStep) {
    const std::string before = write_document(state.document());
    play(
        "stroke Ctrl+Shift left field:tile.scale.0 field:tile.scale.0+20,0 "
        "field:tile.scale.0+40,0");
    EXPECT_GT(numbers("scale")[0], 2);
    EXPECT_NEAR(numbers("scale")[1], 2 * numbers("scale")[0], 1e-9);
    play("key Ctrl+Z");
    EXPECT_EQ(write_document(state.document()), before);
}

TEST_F(VectorDrag, OfZeroMovesAll) {
    play(
        "stroke Ctrl+Shift left field:tile.offset.0 field:tile.offset.0+20,0 "
        "field:tile.offset.0+40,0");
    EXPECT_GT(numbers("offset")[0], 0);
    EXPECT_NEAR(numbers("offset")[1], 0.5 + numbers("offset")[0], 1e-9);
}

}  // namespace
}  // namespace wrinkle::editor
