// Tests of writing graphs: unchanged bytes, or canonical text.
#include "graph/write.h"

#include <gtest/gtest.h>

#include "graph/edit.h"
#include "sample.h"

namespace wrinkle {
namespace {

TEST(Write, UntouchedIsTheOriginalBytes) {
    for (const std::string& text :
         {std::string("  {\"wrinkle\":1,\r\n\"nodes\":{ }}\n\n"), sample_text(), std::string("[1,"),
          std::string("\xEF\xBB\xBF{\"wrinkle\": 1.0}"), std::string("no"), std::string()})
        EXPECT_EQ(write_document(read_quietly(text)), text);
}

TEST(Write, TheSampleIsCanonical) {
    EXPECT_EQ(canonical_text(read_quietly(sample_text())), sample_text());
}

TEST(Write, CanonicalTextOfAFlatText) {
    const Document document = read_quietly(
        R"({"outputs":{"normal":{"from":"b.n"}},"layout":{"b":[1.50,-0]},"name":"","back_faces":"flip",
"nodes":{"b":{"in":{"y":[1,2.0],"x":1e2,"z":{"from":"surface.uv0"}},"version":1,"type":"t\u00e9","muted":false},
"a":{"muted":true,"type":"u","in":{}}},"wrinkle":1.0,"inputs":{"i":{"doc":"","type":"float"}}})");
    EXPECT_EQ(canonical_text(document), R"({
  "wrinkle": 1,
  "back_faces": "flip",
  "inputs": {
    "i": { "type": "float" }
  },
  "nodes": {
    "b": {
      "type": "té",
      "in": {
        "y": [1, 2.0],
        "x": 1e2,
        "z": { "from": "surface.uv0" }
      }
    },
    "a": { "type": "u", "muted": true }
  },
  "outputs": {
    "normal": { "from": "b.n" }
  },
  "layout": {
    "b": [1.50, -0]
  }
}
)");
}

// On a mesh with a doubleSided material, an explicit "mirror" differs from the default.
TEST(Write, AChosenRuleOfBackFacesStays) {
    const std::string mirror = R"({
  "wrinkle": 1,
  "back_faces": "mirror",
  "nodes": {},
  "outputs": {}
}
)";
    EXPECT_EQ(canonical_text(read_quietly(mirror)), mirror);
}

TEST(Write, CanonicalTextIsAFixedPoint) {
    const std::string once = canonical_text(read_quietly(
        R"({"$schema": "x", "wrinkle": 1, "nodes": {"a": {"type": "t", "k": {"deep": [[], {}]}}, "z": 3},
"future": {"a": ["bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb",
"cccccccccccccccccccccccccccccccccccccccccccccccccc"]}})"));
    EXPECT_EQ(canonical_text(read_quietly(once)), once);
}

TEST(Write, WhatIsNotKnownIsKept) {
    const Document document = read_quietly(
        R"({"$schema": "s.json", "wrinkle": 1, "author": {"name": "me", "n": 1.00},
"inputs": {"i": {"type": "float", "units": "m"}, "j": [2]},
"nodes": {"a": {"type": "plugin_type", "color": [1.0, {"x": null}], "in": {"odd": {"k": [1e1]}, "w": {"from": "a"}}},
"b": null, "c": {"type": 5, "in": 6, "version": "x"}},
"outputs": {"o": 4}, "layout": {"a": "here", "gone": [1, 2], "$new": {"a": 1}, "$frames": {"f": 8, "g": {"rect": [1, 2, 3, 4.0], "color": "red"}}}})");
    EXPECT_EQ(canonical_text(document), R"({
  "$schema": "s.json",
  "wrinkle": 1,
  "inputs": {
    "i": { "type": "float", "units": "m" },
    "j": [2]
  },
  "nodes": {
    "a": {
      "type": "plugin_type",
      "in": {
        "odd": { "k": [1e1] },
        "w": { "from": "a" }
      },
      "color": [1.0, { "x": null }]
    },
    "b": null,
    "c": {
      "type": 5,
      "in": 6,
      "version": "x"
    }
  },
  "outputs": {
    "o": 4
  },
  "layout": {
    "gone": [1, 2],
    "$frames": {
      "f": 8,
      "g": { "rect": [1, 2, 3, 4.0], "color": "red" }
    },
    "a": "here",
    "$new": { "a": 1 }
  },
  "author": { "name": "me", "n": 1.00 }
}
)");
}

TEST(Write, SectionsOfTheWrongKindAreKept) {
    const std::string text = R"({"wrinkle": 3, "name": 1, "nodes": [], "outputs": 2, "layout": 4})";
    EXPECT_EQ(canonical_text(read_quietly(text)), R"({
  "wrinkle": 3,
  "name": 1,
  "nodes": [],
  "outputs": 2,
  "layout": 4
}
)");
}

TEST(Write, AnEmptyDocument) {
    EXPECT_EQ(write_document(Document()),
              "{\n  \"wrinkle\": 1,\n  \"nodes\": {},\n  \"outputs\": {}\n}\n");
    EXPECT_EQ(problems_of(write_document(Document())), "");
}

}  // namespace
}  // namespace wrinkle
