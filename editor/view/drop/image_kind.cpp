#include "editor/view/drop/image_kind.h"

#include <algorithm>

#include "editor/model/images/facts.h"
#include "editor/view/panels/search.h"

namespace wrinkle::editor {
namespace {

bool says(std::string_view name, std::initializer_list<std::string_view> words) {
    const std::string lower = lower_case(name);
    return std::ranges::any_of(
        words, [&](std::string_view word) { return lower.find(word) != lower.npos; });
}

ImageKind by_name(std::string_view name) {
    const std::string why = "its name says so";
    if (says(name, {"normal", "_nrm", "_nor."})) return {"tangent_normal_map", why, {}};
    if (says(name, {"height", "bump", "disp", "depth"})) return {"height_map", why, {}};
    if (says(name, {"slope", "derivative"})) return {"derivative_map", why, {}};
    return {"image", "nothing says that it is a bump", {}};
}

}  // namespace

ImageKind kind_of(const Examined& examined, std::string_view name) {
    const std::string why = summary_of(examined);
    switch (examined.verdict.map_class) {
        case maps::MapClass::height:
            return {"height_map", why, {}};
        case maps::MapClass::normal_dx:
            return {"tangent_normal_map", why, Encoding::normal_dx};
        case maps::MapClass::normal_gl:
        case maps::MapClass::normal:
            return {"tangent_normal_map", why, {}};
        case maps::MapClass::normal_object:
            return {examined.info.width == 6 * examined.info.height ? "cube_normal_map"
                                                                    : "object_normal_map",
                    why,
                    {}};
        case maps::MapClass::two_channel:
            return {"derivative_map", why, {}};
        case maps::MapClass::color:
            break;
    }
    return by_name(name);
}

}  // namespace wrinkle::editor
