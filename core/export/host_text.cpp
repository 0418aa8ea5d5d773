#include "export/host_text.h"

#include <algorithm>

#include "base/standard_outputs.h"
#include "base/text.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

const OutputInfo* output_of(const Reflection& reflection, std::string_view output) {
    const auto found = std::ranges::find(reflection.outputs, output, &OutputInfo::output);
    return found == reflection.outputs.end() ? nullptr : &*found;
}

std::string literal(double value) {
    const std::string text = shortest(value);
    return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

}  // namespace

std::string with_fields(std::string_view text,
                        std::initializer_list<std::pair<std::string_view, std::string>> fields) {
    std::string made;
    for (size_t at = 0; at < text.size();) {
        const auto begins = [&](const auto& field) {
            return text.substr(at).starts_with("@" + std::string(field.first) + "@");
        };
        const auto field = text[at] == '@' ? std::ranges::find_if(fields, begins) : fields.end();
        if (field == fields.end()) {
            made += text[at++];
            continue;
        }
        made += field->second;
        at += field->first.size() + 2;
    }
    return made;
}

std::string indented(std::string_view text, size_t spaces) {
    std::string made;
    for (const std::string_view line : split(text, '\n'))
        if (!line.empty()) made.append(spaces, ' ').append(line) += "\n";
    return made;
}

std::string surface_assignments(const Reflection& reflection,
                                const std::map<std::string_view, std::string_view>& inputs) {
    std::string text;
    for (const MemberInfo& member : reflection.members)
        text.append("    s.").append(member.name).append(" = ").append(inputs.at(member.name)) +=
            ";\n";
    return text;
}

std::string output_expression(const Reflection& reflection, const Language& language,
                              std::string_view output, std::string_view result) {
    if (const OutputInfo* found = output_of(reflection, output))
        return output_text(reflection, *found, result);
    const StandardOutput& row = *find_standard_output(output);
    if (row.type != "color") return literal(row.value[0]);
    std::string list;
    for (const double channel : row.value)
        append_item(list, literal(channel));
    return std::string(language.type(Type::vec3_)) + "(" + list + ")";
}

bool has_output(const Reflection& reflection, std::string_view output) {
    return output_of(reflection, output) != nullptr;
}

std::string coat_text(const Language& language, const std::string& color,
                      const std::function<std::string(std::string_view)>& value) {
    const std::string vec3(language.type(Type::vec3_));
    return with_fields(R"({
    float n = @IOR@;
    float mirror_held = (n - 1.0) * (n - 1.0) / ((n + 1.0) * (n + 1.0));
    float mean = log((10893.0 * n - 1438.2) / (-774.4 * n * n + 10212.0 * n + 1.0));
    float diffuse_held = 1.0 - (1.0 - mean) / (n * n);
    float rough = 1.0 + (@ROUGHNESS@ - 1.0) * (1.0 - @METALNESS@);
    float held = mirror_held + (diffuse_held - mirror_held) * rough;
    @VEC3@ darkening = (1.0 - held) / (1.0 - clamp(@COLOR@, 0.0, 1.0) * held);
    @VEC3@ transmitted = 1.0 + (@TINT@ - 1.0) * @WEIGHT@;
    @COLOR@ *= transmitted * (1.0 + (darkening - 1.0) * (@WEIGHT@ * @DARKENING@));
}
)",
                       {{"VEC3", vec3},
                        {"COLOR", color},
                        {"IOR", value("coat_ior")},
                        {"ROUGHNESS", value("roughness")},
                        {"METALNESS", value("metalness")},
                        {"TINT", value("coat_color")},
                        {"WEIGHT", value("coat_weight")},
                        {"DARKENING", value("coat_darkening")}});
}

}  // namespace wrinkle
