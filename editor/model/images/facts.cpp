#include "editor/model/images/facts.h"

#include <array>
#include <cctype>
#include <cstdio>

#include "editor/model/words.h"

namespace wrinkle::editor {
namespace {

using maps::Verdict;

// Precondition: only numbers contain '-'; it is replaced by the minus sign (U+2212).
template <typename... Values>
std::string fact_text(const char* format, Values... values) {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, format, values...);
    std::string text = buffer;
    for (size_t at = text.find('-'); at != text.npos; at = text.find('-', at + 1))
        text.replace(at, 1, "\u2212");
    return text;
}

std::string without_article(std::string_view text) {
    for (const std::string_view article : {"an ", "a "})
        if (text.starts_with(article)) text.remove_prefix(article.size());
    return std::string(text);
}

std::string size_words(const ImageInfo& info) {
    constexpr std::array bits = {"8 bits", "16 bits", "halves", "floats"};
    return grouped(info.width) + " \u00D7 " + grouped(info.height) + " px, " +
           counted(info.channels, "channel") + ", " + bits[static_cast<size_t>(info.source)];
}

class Facts {
public:
    explicit Facts(const Examined& examined) : info_(examined.info), verdict_(examined.verdict) {}

    std::vector<Fact> all() {
        std::string kind = without_article(description_of(verdict_.map_class));
        kind[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(kind[0])));
        add("Kind", kind);
        add("Size", size_words(info_));
        if (has("curl_correlation"))
            add("Curl", fact_text("%+.2f (green up +1, down -1); rms %.3g up, %.3g down",
                                  at("curl_correlation"), at("curl_gl"), at("curl_dx")));
        if (has("unit"))
            add("Unit vectors", fact_text("%.1f %%; pointing down %.1f %%", 100 * at("unit"),
                                          100 * at("downward")));
        if (has("tilt_degrees"))
            add("Mean normal", fact_text("leans by %.2f\u00B0", at("tilt_degrees")));
        if (has("signed_z"))
            add("Blue", fact_text("off (1 + z) / 2 by %.4f, off z by %.4f", at("signed_z"),
                                  at("unsigned_z")));
        if (has("offset_red"))
            add("Offset", fact_text("red %+.2f, green %+.2f steps beside 127.5", at("offset_red"),
                                    at("offset_green")));
        add_levels();
        if (has("seam_u") || has("seam_v"))
            add("Border", fact_text("steps %.2g \u00D7 those inside across u, %.2g \u00D7 across v",
                                    at("seam_u"), at("seam_v")));
        return std::move(facts_);
    }

private:
    bool has(std::string_view name) const { return verdict_.measure(name).has_value(); }
    double at(std::string_view name) const { return verdict_.measure(name).value_or(0); }
    void add(const char* name, std::string value) { facts_.push_back({name, std::move(value)}); }

    void add_levels() {
        std::string text;
        for (const std::string channel : {"", "red_", "green_"}) {
            if (!has(channel + "levels")) continue;
            if (!text.empty()) text += ", ";
            if (!channel.empty()) text += channel.substr(0, channel.size() - 1) + " ";
            text += grouped(static_cast<size_t>(at(channel + "levels"))) +
                    fact_text(" (%.0f %% of neighbours equal)", 100 * at(channel + "still"));
        }
        if (!text.empty()) add("Levels", text);
    }

    const ImageInfo& info_;
    const Verdict& verdict_;
    std::vector<Fact> facts_;
};

}  // namespace

std::string summary_of(const Examined& examined) {
    const std::string text = without_article(description_of(examined.verdict.map_class));
    const auto curl = examined.verdict.measure("curl_correlation");
    return text + ": " + (curl ? fact_text("curl %+.2f", *curl) : size_words(examined.info));
}

std::string curl_words(const Verdict& verdict) {
    return fact_text("The curl test gives %+.2f: green points up at +1, down at -1",
                     verdict.measure("curl_correlation").value_or(0));
}

std::vector<Fact> facts_of(const Examined& examined) {
    return Facts(examined).all();
}

}  // namespace wrinkle::editor
