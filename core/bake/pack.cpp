#include <algorithm>

#include "bake/maps.h"
#include "base/text.h"

namespace wrinkle {
namespace {

constexpr const char* pack_remedy = "\"r=occlusion g=roughness b=metalness\" is one";

// "r=roughness", "g=normal.g".
std::optional<PackedChannel> parse_channel(std::string_view word) {
    PackedChannel channel;
    if (word.size() < 3 || word[1] != '=' || std::string_view("rgba").find(word[0]) == word.npos)
        return {};
    channel.to = word[0];
    word.remove_prefix(2);
    const size_t dot = word.rfind('.');
    if (dot != word.npos) {
        const std::string_view part = word.substr(dot + 1);
        const size_t index =
            part.size() == 1 ? std::string_view("rgbaxyzw").find(part[0]) : part.npos;
        if (index == part.npos) return {};
        channel.channel = static_cast<uint32_t>(index % 4);
        word = word.substr(0, dot);
    }
    channel.map = word;
    if (channel.map.empty()) return {};
    return channel;
}

}  // namespace

std::optional<MapRequest> parse_pack(const std::string& text, Diagnostics& diagnostics) {
    MapRequest request{"packed", {}, true};
    std::string_view rest = text;
    const size_t colon = rest.find(':');
    if (colon != rest.npos) {
        request.name = rest.substr(0, colon);
        rest.remove_prefix(colon + 1);
    }
    bool ok = request.name != "" && identifier(request.name) == request.name;
    for (const std::string_view word : split(rest, ' ')) {
        if (word.empty()) continue;
        const auto channel = parse_channel(word);
        ok = ok && channel &&
             std::ranges::find(request.pack, channel->to, &PackedChannel::to) == request.pack.end();
        if (!ok) break;
        request.pack.push_back(*channel);
    }
    if (ok && !request.pack.empty()) return request;
    diagnostics.error(RuleId::option, "--pack \"" + text + "\" names no channels of maps",
                      pack_remedy);
    return {};
}

std::string text_of(const MapRequest& pack) {
    std::string text = pack.name + ":";
    for (const PackedChannel& channel : pack.pack)
        text += std::string(" ") + channel.to + "=" + channel.map + "." + "rgba"[channel.channel];
    return text;
}

}  // namespace wrinkle
