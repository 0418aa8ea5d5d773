// Colors made and adjusted. All are linear Rec. 709; adjustments leave their range open.
#include <span>

#include "nodes/color_space.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto color_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("color");
}
static constexpr auto adjustment(const char* id, const char* title, const char* doc) {
    return color_family(id, title, doc)
        .in<Color>("color", 0.5, "The color to change, linear", slider(0, 1));
}
template <class Declaration>
static constexpr auto adjusted(const Declaration& declaration) {
    return declaration.template out<Color>("color", "The changed color, linear");
}

// A hue is turned, saturation and value are multiplied. Components below 0 become 0.
static vec3 hsv_adjusted(vec3 color, Float hue, Float saturation, Float value) {
    const vec3 hsv = named("hsv", to_hsv(color));
    return max(from_hsv(vec3(hsv.x() + hue, hsv.y() * saturation, hsv.z() * value)), 0);
}

// The chromaticity of a black body in CIE 1960 (u, v), from 1000 K to 15,000 K to 1e-4: M. Krystek
// 1985. As a color of luminance 1; colors outside Rec. 709 are clamped.
static vec3 black_body(Float kelvin) {
    const auto color = function("blackbody(kelvin)", [](Float t) {
        const Float u = named("u", (0.860117757 + (1.54118254e-4 + 1.28641212e-7 * t) * t) /
                                       (1 + (8.42420235e-4 + 7.08145163e-7 * t) * t));
        const Float v = named("v", (0.317398726 + (4.22806245e-5 + 4.20481691e-8 * t) * t) /
                                       (1 + (1.61456053e-7 * t - 2.89741816e-5) * t));
        // XYZ of luminance 1.
        const Float x = named("x", 1.5 * u / v), z = named("z", (2 - 0.5 * u) / v - 5);
        const vec3 rgb = vec3(3.2404542, -0.9692660, 0.0556434) * x +
                         vec3(-1.5371385, 1.8760108, -0.2040259) +
                         vec3(-0.4985314, 0.0415560, 1.0572252) * z;
        const vec3 shown = named("shown", max(rgb, 0));
        return shown / luminance(shown);
    });
    return color(kelvin);
}

struct Correction {
    vec3 color;
    Float hue, saturation, gamma, lift, gain, contrast, pivot, exposure;
};

static constinit Node color_list[] = {
    color_family("color", "Color", "A color.")
        .in<Color>("color", 0.5, "Red, green and blue, linear", slider(0, 1))
        .out<Color>("color", "The same color")
        .body([](vec3 color) { return color; }),

    adjusted(adjustment("color_gamma", "Gamma", "Each component to a power; negatives count as 0.")
                 .in<Float>("gamma", 1, "The power; above 1 darkens the middle", slider(0.2, 4),
                            limits(0, 16)))
        .body([](vec3 color, Float gamma) { return pow(color, gamma); }),

    adjusted(adjustment("exposure", "Exposure", "Brightens or darkens as a camera does.")
                 .in<Float>("stops", 0, "Each doubles the light", slider(-4, 4), limits(-64, 64)))
        .body([](vec3 color, Float stops) { return color * exp2(stops); }),

    adjusted(adjustment("invert_color", "Invert color", "1 less each component."))
        .body([](vec3 color) { return 1 - color; }),

    color_family("blackbody", "Black body", "The color of a glowing body, with luminance 1.")
        .in<Float>("temperature", 6500, "Temperature of the body, 800 to 12000 kelvin",
                   slider(800, 12000), limits(800, 12000), unit("K"))
        .out<Color>("color", "The color, linear")
        .body([](Float temperature) { return black_body(temperature); }),

    color_family("luminance", "Luminance", "How bright a color is to the eye.")
        .in<Color>("color", 0.5, "The color, linear", slider(0, 1))
        .out<Float>("value", "0.2126 red + 0.7152 green + 0.0722 blue")
        .body([](vec3 color) { return luminance(color); }),

    adjusted(adjustment("saturation", "Saturation", "Moves a color from or to its grey.")
                 .in<Float>("amount", 1, "0 is grey of the same luminance, 1 leaves it unchanged",
                            slider(0, 2)))
        .body([](vec3 color, Float amount) { return mix(vec3(luminance(color)), color, amount); }),

    adjusted(adjustment("hsv_adjust", "Adjust hue, saturation, value",
                        "Turns the hue and scales saturation and value, on linear components.")
                 .in<Float>("hue", 0, "Added, in turns", slider(-0.5, 0.5))
                 .in<Float>("saturation", 1, "Factor; 0 is grey", slider(0, 2), limits(0, 1e6))
                 .in<Float>("value", 1, "Factor of the greatest component", slider(0, 2)))
        .body([](vec3 color, Float hue, Float saturation, Float value) {
            return hsv_adjusted(color, hue, saturation, value);
        }),

    adjusted(adjustment("brightness_contrast", "Brightness and contrast",
                        "Scales differences from 0.5 and adds the brightness.")
                 .in<Float>("brightness", 0, "Added", slider(-1, 1))
                 .in<Float>("contrast", 1, "Factor; 1 leaves it unchanged", slider(0, 4)))
        .body([](vec3 color, Float brightness, Float contrast) {
            return (color - 0.5) * contrast + (brightness + 0.5);
        }),

    adjusted(
        adjustment("color_correct", "Color correction",
                   "Hue, saturation, gamma, lift, gain, contrast and exposure, applied in "
                   "this order.")
            .in<Float>("hue", 0, "Added, in turns", slider(-0.5, 0.5))
            .in<Float>("saturation", 1, "0 is grey of the same luminance", slider(0, 2))
            .in<Float>("gamma", 1, "Above 1 lifts the middle", slider(0.2, 4), limits(0.1, 10))
            .in<Float>("lift", 0, "Raises black to this, leaving white", slider(-1, 1))
            .in<Float>("gain", 1, "Factor", slider(0, 2))
            .in<Float>("contrast", 1, "Factor of differences from the pivot", slider(0, 4))
            .in<Float>("pivot", 0.5, "The component that contrast leaves unchanged", slider(0, 1))
            .in<Float>("exposure", 0, "In stops; each doubles the light", slider(-4, 4),
                       limits(-16, 16)))
        .body([](Correction in) {
            const vec3 turned = named("turned", hsv_adjusted(in.color, in.hue, 1, 1));
            const vec3 saturated =
                named("saturated", mix(vec3(luminance(turned)), turned, in.saturation));
            const vec3 bent = named("bent", pow(saturated, 1 / in.gamma));
            const vec3 lifted = named("lifted", (bent * (1 - in.lift) + in.lift) * in.gain);
            return ((lifted - in.pivot) * in.contrast + in.pivot) * exp2(in.exposure);
        }),

    color_family("to_oklab", "To OKLab", "A color as lightness and two axes of hue.")
        .in<Color>("color", 0.5, "The color, linear", slider(0, 1))
        .out<vec3>("lab", "Lightness 0 to 1, green to red, blue to yellow")
        .body([](vec3 color) { return to_oklab(color); }),

    color_family("from_oklab", "From OKLab", "The color of OKLab numbers.")
        .in<vec3>("lab", {0.5, 0, 0}, "Lightness 0 to 1, green to red, blue to yellow")
        .out<Color>("color", "The color, linear; outside 0 to 1 it cannot be displayed")
        .body([](vec3 lab) { return from_oklab(lab); }),

    adjusted(adjustment("oklch_adjust", "Adjust lightness, chroma, hue",
                        "Changes a color in OKLab, evenly to the eye: a turned hue has "
                        "the same lightness.")
                 .in<Float>("lightness", 1, "Factor", slider(0, 2))
                 .in<Float>("chroma", 1, "Factor; 0 is grey", slider(0, 2))
                 .in<Float>("hue", 0, "Added, in turns", slider(-0.5, 0.5)))
        .body([](vec3 color, Float lightness, Float chroma, Float hue) {
            const vec3 lab = named("lab", to_oklab(color));
            const Float angle = named("angle", hue * two_pi());
            const Float c = cos(angle) * chroma, s = sin(angle) * chroma;
            return from_oklab(
                {lab.x() * lightness, c * lab.y() - s * lab.z(), s * lab.y() + c * lab.z()});
        })};
constinit std::span<Node> color_nodes = color_list;

}  // namespace wrinkle::nodes
