#include "api/c_options.h"

#include <array>
#include <charconv>

#include "base/text.h"

namespace wrinkle::api {
namespace {

using Words = std::vector<std::string>;

// Returns the index of the value among the words of an option; reports any other value.
size_t word(std::string_view name, std::string_view value, const Words& words,
            Diagnostics& diagnostics) {
    for (size_t i = 0; i < words.size(); ++i)
        if (words[i] == value) return i;
    diagnostics.error(RuleId::option,
                      std::string(name) + " has no value '" + std::string(value) + "'",
                      joined(words, " or "));
    return 0;
}

int whole_number(std::string_view name, std::string_view value, Diagnostics& diagnostics) {
    int number = 0;
    const char* end = value.data() + value.size();
    const auto [last, error] = std::from_chars(value.data(), end, number);
    if (error == std::errc() && last == end) return number;
    diagnostics.error(RuleId::option, std::string(name) + "=" + std::string(value),
                      "a whole number");
    return 0;
}

struct Option {
    std::string_view name;
    void (*set)(CompileOptions& options, std::string_view name, std::string_view value,
                Diagnostics& diagnostics);
};

// An option with words. The enumerators from `first` have the order of the words.
template <auto Member, int first, const auto& words>
constexpr void set_word(CompileOptions& options, std::string_view name, std::string_view value,
                        Diagnostics& diagnostics) {
    using Enum = std::remove_reference_t<decltype(options.*Member)>;
    const Words known(words.begin(), words.end());
    options.*Member = static_cast<Enum>(first + word(name, value, known, diagnostics));
}

template <auto Member>
void set_text(CompileOptions& options, std::string_view, std::string_view value, Diagnostics&) {
    options.*Member = value;
}

template <auto Member>
void set_number(CompileOptions& options, std::string_view name, std::string_view value,
                Diagnostics& diagnostics) {
    options.*Member = whole_number(name, value, diagnostics);
}

using Names = std::string_view;
constexpr std::array<Names, 2> flags = {"false", "true"};
constexpr std::array<Names, 2> no_tangents = {"true", "false"};  // sets vertex_tangents
constexpr std::array<Names, 2> forms = {"function", "shader"};
constexpr std::array<Names, 2> parameters = {"baked", "uniform"};
constexpr std::array<Names, 2> differentials = {"screen", "given"};
constexpr std::array<Names, 2> decoders = {"sampler", "shader"};
constexpr std::array<Names, 4> spaces = {"object", "world", "view", "tangent"};
constexpr std::array<Names, 2> origins = {"bottom", "top"};

using O = CompileOptions;
constexpr std::array<Option, 12> table = {{
    {"target", set_text<&O::target>},
    {"form", set_word<&O::form, 1, forms>},
    {"params", set_word<&O::parameters, 0, parameters>},
    {"differentials", set_word<&O::differentials, 0, differentials>},
    {"srgb", set_word<&O::srgb, 0, decoders>},
    {"normal-space", set_word<&O::normal_space, 1, spaces>},
    {"uv-origin", set_word<&O::uv_origin, 0, origins>},
    {"descriptor-set", set_number<&O::descriptor_set>},
    {"first-binding", set_number<&O::first_binding>},
    {"name", set_text<&O::name>},
    {"no-tangents", set_word<&O::vertex_tangents, 0, no_tangents>},
    {"strict", set_word<&O::strict, 0, flags>},
}};

}  // namespace

void set_option(CompileOptions& options, std::string_view text, Diagnostics& diagnostics) {
    const size_t equals = std::min(text.find('='), text.size());
    const std::string name(text.substr(0, equals));
    Words names;
    for (const Option& option : table) {
        names.emplace_back(option.name);
        if (option.name != name) continue;
        if (equals < text.size())
            return option.set(options, name, text.substr(equals + 1), diagnostics);
        return diagnostics.error(RuleId::option, "option '" + name + "' has no value",
                                 name + "=VALUE");
    }
    diagnostics.error(RuleId::option, "there is no option '" + name + "'",
                      did_you_mean(name, names, joined(names, ", ")));
}

}  // namespace wrinkle::api
