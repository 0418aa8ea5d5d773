// Standard outputs in Godot: OpenPBR's parameters as those of its Disney-like model.
#include <algorithm>
#include <array>

#include "base/fuzz.h"
#include "base/standard_outputs.h"
#include "base/text.h"
#include "emit/language.h"
#include "export/godot.h"
#include "export/host_text.h"

namespace wrinkle {
namespace {

constexpr std::array taken_outputs =
    std::to_array<std::string_view>({"normal",          "color",
                                     "base_weight",     "roughness",
                                     "metalness",       "occlusion",
                                     "emission",        "emission_luminance",
                                     "opacity",         "specular_weight",
                                     "specular_ior",    "specular_roughness_anisotropy",
                                     "tangent",         "coat_weight",
                                     "coat_color",      "coat_roughness",
                                     "coat_ior",        "coat_darkening",
                                     "fuzz_weight",     "fuzz_roughness",
                                     "fuzz_color",      "subsurface_weight",
                                     "subsurface_color"});

class Assignments {
public:
    Assignments(const GodotVersion& version, const std::map<std::string, std::string>& values,
                std::string to_view)
        : version_(version), values_(values), to_view_(std::move(to_view)) {}

    std::string text() {
        if (has("normal")) assign("NORMAL", value("normal"));
        base();
        specular();
        if (has("metalness")) assign("METALLIC", value("metalness"));
        if (has("occlusion")) assign("AO", value("occlusion"));
        emission();
        if (has("opacity")) assign("ALPHA", value("opacity"));
        coat();
        fuzz();
        return text_;
    }

private:
    bool has(const std::string& output) const { return values_.contains(output); }

    // The expression of an output, or the default of the table.
    std::string value(const std::string& output) const {
        const auto found = values_.find(output);
        if (found != values_.end()) return found->second;
        return output_expression(Reflection{}, glsl(), output);
    }

    void assign(const std::string& name, const std::string& expression) {
        text_ += "    " + name + " = " + expression + ";\n";
    }

    // Subsurface replaces the color of the base (OpenPBR 1.1, "Mixture model").
    void base() {
        std::string color = value("color");
        if (has("base_weight")) color += " * " + value("base_weight");
        if (has("subsurface_weight"))
            color = "mix(" + color + ", " + value("subsurface_color") + ", " +
                    value("subsurface_weight") + ")";
        assign("ALBEDO", color);
        if (has("coat_weight"))
            text_ += indented(
                coat_text(godot3(), "ALBEDO",
                          [&](std::string_view output) { return value(std::string(output)); }),
                4);
        if (has("subsurface_weight")) assign("SSS_STRENGTH", value("subsurface_weight"));
    }

    static std::string specular_of(const std::string& ior) {
        return "2.5 * abs(" + ior + " - 1.0) / (" + ior + " + 1.0)";
    }

    // The value of the base, or of the coat above a dielectric in Godot 3: there a coat reflects
    // lights but not the sky, and a base below a coat of a similar index reflects little.
    std::string below_coat(const std::string& base, const std::string& coat) const {
        if (version_.major > 3 || !has("coat_weight")) return base;
        return "mix(" + base + ", " + coat + ", " + value("coat_weight") + " * (1.0 - " +
               value("metalness") + "))";
    }

    // F0 is 0.16 SPECULAR^2 in Godot.
    void specular() {
        if (has("specular_weight") || has("specular_ior") || has("coat_weight"))
            assign("SPECULAR", below_coat("sqrt(max(" + value("specular_weight") + ", 0.0)) * " +
                                              specular_of(value("specular_ior")),
                                          specular_of(value("coat_ior"))));
        const std::string roughness = below_coat(value("roughness"), value("coat_roughness"));
        if (has("specular_roughness_anisotropy"))
            anisotropy(roughness);
        else
            assign("ROUGHNESS", roughness);
    }

    // Godot's lobe has the roughness r^2 / q along the tangent and r^2 q across, q^2 = 1 - 0.9
    // ANISOTROPY; OpenPBR's are at = R^2 sqrt(2 / (1 + (1 - a)^2)) and (1 - a) at.
    void anisotropy(const std::string& roughness) {
        text_ += "    float across = 1.0 - clamp(" + value("specular_roughness_anisotropy") +
                 ", 0.0, 0.999);\n";
        assign("ROUGHNESS",
               "min(" + roughness + " * sqrt(sqrt(2.0 * across / (1.0 + across * across))), 1.0)");
        assign("ANISOTROPY", "min((1.0 - across) / 0.9, 1.0)");
        if (!has("tangent")) return;
        assign("TANGENT", "normalize(" + to_view_ + " * " + value("tangent") + ")");
        assign("BINORMAL", "cross(NORMAL, TANGENT)");
    }

    void emission() {
        if (!has("emission") && !has("emission_luminance")) return;
        std::string radiance = value("emission");
        if (has("emission_luminance"))
            radiance += " * (" + value("emission_luminance") + " / " +
                        shortest(nits_of_unit_emission) + ".0)";
        assign("EMISSION", "max(" + radiance + ", vec3(0.0))");
    }

    // A coat of Godot has the index 1.5. Godot 3 draws a quarter of it, here on metals.
    void coat() {
        if (!has("coat_weight")) return;
        const std::string ratio = specular_of(value("coat_ior")) + " / 0.5";
        const std::string weight = value("coat_weight") + " * (" + ratio + ") * (" + ratio + ")";
        if (version_.major == 3) {
            assign("CLEARCOAT", "4.0 * " + value("metalness") + " * " + weight);
            assign("CLEARCOAT_GLOSS", "1.0 - " + value("coat_roughness"));
        } else {
            assign("CLEARCOAT", "min(" + weight + ", 1.0)");
            assign("CLEARCOAT_ROUGHNESS", value("coat_roughness"));
        }
    }

    // Fuzz is a diffuse color by the angle of view: Godot's rim has no color and needs lights.
    void fuzz() {
        if (!has("fuzz_weight")) return;
        text_ += indented(with_fields(R"({
float x = clamp(dot(NORMAL, VIEW), 0.0, 1.0);
float y = clamp(@ROUGHNESS@, @MIN@, 1.0);@ALBEDO@
float fuzz = @WEIGHT@ * albedo;
ALBEDO = mix(ALBEDO, @COLOR@, fuzz);
METALLIC *= 1.0 - fuzz;
SPECULAR *= sqrt(1.0 - fuzz);
}
)",
                                      {{"ROUGHNESS", value("fuzz_roughness")},
                                       {"MIN", shortest(min_fuzz_roughness)},
                                       {"ALBEDO", std::string(fuzz_albedo_text)},
                                       {"WEIGHT", value("fuzz_weight")},
                                       {"COLOR", value("fuzz_color")}}),
                          4);
    }

    const GodotVersion& version_;
    const std::map<std::string, std::string>& values_;
    std::string to_view_, text_;
};

}  // namespace

bool godot_takes(std::string_view output) {
    return std::ranges::count(taken_outputs, output) > 0;
}

std::string godot_assignments(const GodotVersion& version,
                              const std::map<std::string, std::string>& values,
                              const std::string& to_view) {
    return Assignments(version, values, to_view).text();
}

}  // namespace wrinkle
